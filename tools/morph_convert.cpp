// morph-convert: from one mesh format to another.
//   morph-convert wing.su2 wing.vtu
#include "formats/binary/gzip.h"
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "tools/common/command_line.h"
#include "tools/common/field_source.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/convert/file_info.h"
#include "tools/convert/transform.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-convert";

struct Options {
    std::vector<std::string> files;
    std::string from, to;
    std::string into;
    std::string fields;
    bool list = false;
    bool info = false;
    bool check = false;
    bool binary = false;
    bool ascii = false;
    bool compress = false;
    std::string scale, rotate, translate;
    std::vector<std::string> drop_fields;
    std::vector<std::string> renames;
    ReadOptions read;
    Edits edits;
};

void add_mode_options(CommandLine& line, Options& options)
{
    line.add("files", options.files,
             "Mesh to read and mesh to write; with --info or --into-dir: meshes to read")
        .type_name("IN OUT | IN...");
    line.add_from(options.from);
    line.add_to(options.to);
    line.add("--into-dir", options.into,
             "Convert every IN to a file of the same name in this folder, in the format --to;\n"
             "one that fails does not stop the others, and the exit status is then 1")
        .type_name("DIR");
    line.add("--fields", options.fields,
             "Take fields from a separate file: an SU2 restart or other CSV file, or\n"
             "a mesh file of the same mesh")
        .type_name("FILE");
    line.add_flag("--list", options.list, "List the formats and what each can hold");
    line.add_flag("--info", options.info, "Say what the files hold");
    line.add_flag("--check", options.check,
                  "Build the halfedge structure first, which refuses what is no manifold mesh, by element");
    line.add("--zone", options.read.zone,
             "Number (from 1) or name of the zone to take (default: all, each a group of elements)")
        .type_name("ZONE");
    line.add_flag("--surface", options.read.surface, "Take the boundary faces of a volume mesh");
}

void add_write_options(CommandLine& line, Options& options)
{
    const Option binary =
        line.add_flag("--binary", options.binary, "Write numbers (default where the format has them)");
    line.add_flag("--ascii", options.ascii, "Write text, which reads back to the same numbers")
        .excludes(binary);
    line.add_flag("--compress", options.compress, "Compress, where the format can");
}

void add_edit_options(CommandLine& line, Options& options)
{
    line.add_flag("--triangulate", options.edits.triangulate, "Split quads along the shorter diagonal");
    line.add("--scale", options.scale, "Multiply coordinates by a factor, or by one for each axis")
        .type_name("S|SX,SY,SZ");
    line.add("--rotate", options.rotate,
             "Then turn about the origin by degrees, counter-clockwise about the z axis or the named one")
        .type_name("DEG|AXIS:DEG");
    line.add("--translate", options.translate, "Then move").type_name("DX,DY[,DZ]");
    line.add("--merge-tolerance", options.edits.merge_tolerance,
             "Make one vertex of those nearer to each other than this, in the units of the file")
        .type_name("LENGTH")
        .positive();
    line.add("--rename-marker", options.renames, "Rename a marker or group; may be given several times")
        .type_name("OLD=NEW")
        .one_value_each_time();
    line.add("--drop-fields", options.drop_fields, "Leave out the fields of these names, or all")
        .type_name("[NAME,...]")
        .count(0, 1);
}

/// @throws UsageError  arguments that do not go together
void check_usage(const Options& options)
{
    const std::size_t files = options.files.size();
    if (options.list)
        return;
    if (options.info && files == 0)
        throw UsageError("--info needs a file; --help shows the usage");
    if (!options.into.empty() && (options.to.empty() || files == 0))
        throw UsageError("--into-dir needs files and their new format, --to NAME");
    if (!options.info && options.into.empty() && files != 2)
        throw UsageError("expected IN and OUT, found " + std::to_string(files) +
                         " file(s); several go with --into-dir DIR");
    for (const std::string& rename : options.renames)
        if (const std::size_t equals = rename.find('=');
            equals == std::string::npos || equals == 0 || equals + 1 == rename.size())
            throw UsageError("--rename-marker needs OLD=NEW, not '" + rename + "'");
}

void finish_edits(const CommandLine& line, Options& options)
{
    options.edits.transform = make_transform(options.scale, options.rotate, options.translate);
    for (const std::string& rename : options.renames) {
        const std::size_t equals = rename.find('=');
        options.edits.renames.push_back({rename.substr(0, equals), rename.substr(equals + 1)});
    }
    for (const std::string& names : options.drop_fields) {
        std::istringstream list(names);
        for (std::string name; std::getline(list, name, ',');)
            if (!name.empty())
                options.edits.drop_fields.push_back(name);
    }
    options.edits.drop_all_fields = line.given("--drop-fields") && options.edits.drop_fields.empty();
}

/// @throws UsageError  the format has not what was asked for
WriteOptions write_options(const Options& options, const Format& format)
{
    const std::string name(format.name);
    if (options.binary && !format.holds.binary)
        throw UsageError("--binary: " + name + " is written as text only");
    if (options.ascii && !format.holds.ascii)
        throw UsageError("--ascii: " + name + " is written in binary only");
    if (options.compress && !format.holds.compressed)
        throw UsageError("--compress: " + name + " cannot be compressed");
    return {.binary = !options.ascii, .compress = options.compress};
}

/// Read, with warnings said; with --check built and turned back.
MeshData read_input(const std::string& path, const Options& options, ReadNotes& notes)
{
    MeshData mesh = read_mesh_data(path, options.from, options.read, &notes);
    for (const std::string& warning : notes.warnings)
        warn(kTool, warning);
    if (!options.fields.empty())
        take_fields_from(options.fields, mesh);
    if (options.check)
        return to_mesh_data(build_mesh_of(std::move(mesh), path));
    return mesh;
}

nlohmann::ordered_json convert_file(const std::string& in, const std::string& out, const Options& options,
                                    OutputFiles& outputs)
{
    Stopwatch watch;
    const Format& format = find_format(out, options.to);
    const WriteOptions write = write_options(options, format);
    OutputFiles::require_writable(out);
    ReadNotes notes;
    MeshData mesh = read_input(in, options, notes);
    const double read_seconds = watch.lap();
    std::vector<std::string> warnings;
    try {
        warnings = apply_edits(options.edits, mesh);
    } catch (const InputError& error) {
        throw InputError(in + ": " + error.what());
    }
    for (std::string& warning : warnings)
        warning.insert(0, in + ": ");
    const double edit_seconds = watch.lap();
    for (std::string& warning : write_mesh_data(mesh, out, outputs, options.to, write))
        warnings.push_back(std::move(warning));
    for (const std::string& warning : warnings)
        warn(kTool, warning);
    warnings.insert(warnings.begin(), notes.warnings.begin(), notes.warnings.end());
    nlohmann::ordered_json json = file_info(in, find_format(in, options.from), mesh, notes);
    json["output"] = out;
    json["output_format"] = format.name;
    json["warnings"] = warnings;
    json["seconds"] = {{"read", read_seconds}, {"edit", edit_seconds}, {"write", watch.lap()}};
    return json;
}

std::string conversion_line(const nlohmann::ordered_json& json)
{
    return std::string(json["file"]) + ": " + std::to_string(json["vertices"].get<std::size_t>()) +
           " vertices, " + std::to_string(json["triangles"].get<std::size_t>()) + " triangles, " +
           std::to_string(json["quads"].get<std::size_t>()) + " quads, written to " +
           std::string(json["output"]);
}

int convert_one(const Options& options, Report& report)
{
    OutputFiles outputs;
    report.json = convert_file(options.files[0], options.files[1], options, outputs);
    report.say(conversion_line(report.json));
    report.finish(outputs);
    return kDone;
}

std::string name_in_folder(const std::string& in, const Options& options)
{
    const std::filesystem::path plain = without_gz(in);
    const Format& format = find_format("", options.to);
    return (std::filesystem::path(options.into) / plain.stem()).string() +
           std::string(format.extensions.front());
}

/// Say what failed and go on with the next file.
void fail_one(nlohmann::ordered_json& list, const std::string& in, const std::string& what)
{
    std::cerr << kTool << ": " << what << '\n';
    list.push_back({{"file", in}, {"error", what}});
}

int convert_all(const Options& options, Report& report)
{
    std::size_t failures = 0;
    std::set<std::string> taken;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const std::string& in : options.files) {
        try {
            const std::string out = name_in_folder(in, options);
            if (!taken.insert(out).second)
                throw InputError(in + ": would be written to " + out + ", as another input is");
            OutputFiles outputs;
            list.push_back(convert_file(in, out, options, outputs));
            outputs.commit();
            report.say(conversion_line(list.back()));
        } catch (const UsageError&) {
            throw;
        } catch (const std::bad_alloc&) {
            ++failures;
            fail_one(list, in, in + ": out of memory");
        } catch (const std::exception& error) {
            ++failures;
            fail_one(list, in, error.what());
        }
    }
    report.json["files"] = std::move(list);
    report.json["failed"] = failures;
    report.say(std::to_string(options.files.size() - failures) + " of " +
               std::to_string(options.files.size()) + " file(s) converted");
    report.finish();
    return failures == 0 ? kDone : kFailed;
}

int tell(const Options& options, Report& report)
{
    report.json["files"] = nlohmann::ordered_json::array();
    for (const std::string& path : options.files) {
        ReadNotes notes;
        const MeshData mesh = read_input(path, options, notes);
        const auto info = file_info(path, find_format(path, options.from), mesh, notes);
        for (const std::string& line : info_lines(info))
            report.say(line);
        report.json["files"].push_back(info);
    }
    report.finish();
    return kDone;
}

int list_formats(Report& report)
{
    for (const std::string& line : format_list())
        report.say(line);
    report.json["formats"] = format_table();
    report.finish();
    return kDone;
}

int convert(int argc, char** argv)
{
    Options options;
    CommandLine line(
        kTool,
        "Converts meshes from one format to another, with their markers, groups and fields. What\n"
        "the new format cannot hold is named in a warning.",
        "  morph-convert wing.msh wing.su2\n"
        "  morph-convert scans/*.stl --into-dir clean --to vtu --merge-tolerance 1e-6\n"
        "  morph-convert --info wing.cgns");
    add_mode_options(line, options);
    add_write_options(line, options);
    add_edit_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    check_usage(options);
    finish_edits(line, options);
    Report report(line.common());
    if (options.list)
        return list_formats(report);
    if (options.info)
        return tell(options, report);
    return options.into.empty() ? convert_one(options, report) : convert_all(options, report);
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-convert", [&] { return morph::tools::convert(argc, argv); });
}
