#include "formats/formats.h"

#include "formats/binary/gzip.h"
#include "formats/input_file.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace morph {

namespace {

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

const Format& format_by_name(const std::string& name)
{
    const std::string key = lower_case(name);
    std::vector<std::string> names;
    for (const Format* format : all_formats()) {
        if (format->name == key || format->old_name == key)
            return *format;
        names.emplace_back(format->name);
    }
    throw InputError("format '" + name + "' is not known; known are " + joined(names) +
                     did_you_mean(name, names));
}

const Format& format_by_extension(const std::string& path)
{
    const std::string extension = lower_case(std::filesystem::path(without_gz(path)).extension().string());
    std::vector<std::string> known;
    for (const Format* format : all_formats())
        for (const std::string_view candidate : format->extensions) {
            if (candidate == extension)
                return *format;
            known.emplace_back(candidate);
        }
    throw InputError(path + ": the extension '" + extension + "' is not that of a known format, which are " +
                     joined(known) + "; name the format with --from or --to");
}

bool has_fields(const MeshData& data, FieldLocation location)
{
    return std::any_of(data.fields.begin(), data.fields.end(),
                       [&](const Field& field) { return field.location == location; });
}

/// "3 fields (a, b, c)", for a warning.
std::string field_list(const MeshData& data, FieldLocation location)
{
    std::vector<std::string> names;
    for (const Field& field : data.fields)
        if (field.location == location)
            names.push_back(field.name);
    return std::to_string(names.size()) + (location == FieldLocation::vertex ? " nodal" : " element") +
           " field(s) " + joined(names);
}

std::vector<std::string> losses(const MeshData& data, const Format& format, const WriteOptions& options)
{
    std::vector<std::string> lost;
    const std::string cannot = std::string(format.name) + " cannot hold ";
    if (!format.holds.elements && !data.elements.empty())
        lost.push_back(cannot + std::to_string(data.elements.size()) + " element(s)");
    if (!format.holds.markers && !data.markers.empty()) {
        std::vector<std::string> names;
        for (const Marker& m : data.markers)
            names.push_back(m.name);
        lost.push_back(cannot + std::to_string(names.size()) + " marker(s) " + joined(names));
    }
    if (!format.holds.groups && !data.groups.empty()) {
        std::vector<std::string> names;
        for (const ElementGroup& group : data.groups)
            names.push_back(group.name);
        lost.push_back(cannot + std::to_string(names.size()) + " group(s) of elements " + joined(names));
    }
    if (!format.holds.vertex_fields && has_fields(data, FieldLocation::vertex))
        lost.push_back(cannot + field_list(data, FieldLocation::vertex));
    if (!format.holds.element_fields && has_fields(data, FieldLocation::element))
        lost.push_back(cannot + field_list(data, FieldLocation::element));
    for (const OpaqueSection& carried : data.sections)
        if (carried.format != format.name)
            lost.push_back(cannot + carried.what);
    if (format.losses)
        for (const std::string& what : format.losses(data, options))
            lost.push_back(cannot + what);
    return lost;
}

void require_surface_fits(const MeshData& data, const Format& format, const std::string& path)
{
    if (data.dimension == 3 && !format.holds.surface)
        throw InputError(
            path + ": " + std::string(format.name) +
            " holds planar meshes only, but this is a surface in space; write it as .vtu or .obj");
}

/// The companion's own name, in the folder of @p path.
std::string path_beside(const std::string& path, const Companion& companion)
{
    if (companion.path)
        return companion.path(path);
    return std::filesystem::path(path).replace_extension().string() + companion.suffix;
}

void require_distinct(const std::vector<Companion>& companions, const std::string& path)
{
    std::vector<std::string> names;
    names.reserve(companions.size());
    for (const Companion& companion : companions)
        names.push_back(path_beside(path, companion));
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end())
        throw InputError(path + ": two of the files that go with it would be called " + *twice +
                         "; rename a field");
}

void write_companions(const std::vector<Companion>& companions, const MeshData& data, const std::string& path,
                      OutputFiles& files)
{
    require_distinct(companions, path);
    for (const Companion& companion : companions)
        companion.write(data, files.open(path_beside(path, companion)));
}

} // namespace

const Format& find_format(const std::string& path, const std::string& name)
{
    return name.empty() ? format_by_extension(path) : format_by_name(name);
}

MeshData read_mesh_data(const std::string& path, const std::string& format, const ReadOptions& options,
                        ReadNotes* notes)
{
    const Format& reader = find_format(path, format);
    const InputFile file(path);
    return reader.read({path, file.bytes(), options, notes});
}

Mesh read_mesh(const std::string& path, const std::string& format)
{
    return build_mesh_of(read_mesh_data(path, format), path);
}

Mesh build_mesh_of(MeshData data, const std::string& path)
{
    try {
        return build_mesh(std::move(data));
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
}

std::vector<std::string> write_mesh(const Mesh& mesh, const std::string& path, const std::string& format,
                                    const WriteOptions& options)
{
    return write_mesh_data(to_mesh_data(mesh), path, format, options);
}

std::vector<std::string> write_mesh_data(const MeshData& data, const std::string& path, OutputFiles& files,
                                         const std::string& format, const WriteOptions& options)
{
    const Format& writer = find_format(path, format);
    if (without_gz(path) != path)
        throw InputError(path + ": gzip files are read, but not written; leave out the .gz");
    if (!writer.write)
        throw InputError(path + ": " + std::string(writer.name) + " can only be read; write .vtu");
    require_surface_fits(data, writer, path);
    writer.write(data, options, files.open(path));
    if (writer.companions)
        write_companions(writer.companions(data), data, path, files);
    std::vector<std::string> warnings = losses(data, writer, options);
    for (std::string& warning : warnings)
        warning.insert(0, path + ": ");
    return warnings;
}

std::vector<std::string> write_mesh_data(const MeshData& data, const std::string& path,
                                         const std::string& format, const WriteOptions& options)
{
    OutputFiles files;
    std::vector<std::string> warnings = write_mesh_data(data, path, files, format, options);
    files.commit();
    return warnings;
}

} // namespace morph
