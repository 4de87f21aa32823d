#include "formats/ugrid/names.h"

#include "formats/input_file.h"
#include "formats/text/element_order.h"
#include "formats/text/names_in_text.h"
#include "formats/text/text_scanner.h"
#include "formats/ugrid/layout.h"

#include <filesystem>
#include <map>

namespace morph {

namespace {

constexpr std::string_view kNotInNames = " \t#"; // a name is one word there

std::string path_of_names(const std::string& mesh_path)
{
    return ugrid_stem(mesh_path) + ".mapbc";
}

/// The carried conditions by the name of the surface, as the file has it.
std::map<std::string, std::int64_t, std::less<>> conditions(const MeshData& mesh)
{
    std::map<std::string, std::int64_t, std::less<>> found;
    for (const OpaqueSection& carried : mesh.sections) {
        TextScanner in("", carried.text, '#');
        while (carried.format == "ugrid" && in.skip_white()) {
            const std::int64_t condition = in.integer("a condition");
            found.try_emplace(std::string(in.rest_of_line()), condition);
        }
    }
    return found;
}

void write_names(const MeshData& mesh, OutputFile& out)
{
    const GroupReferences references = group_references(mesh);
    const auto known = conditions(mesh);
    out.append(std::to_string(mesh.groups.size()) + "\n");
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        const std::string name = line_name(mesh.groups[g].name, kNotInNames);
        const auto condition = known.find(name);
        out.append(std::to_string(references.groups[g]) + " " +
                   std::to_string(condition == known.end() ? 0 : condition->second) + " " + name + "\n");
    }
    out.append(element_order_text(mesh.elements));
}

} // namespace

UgridNames read_ugrid_names(const std::string& path, std::string_view text)
{
    UgridNames names{{}, std::string(text), {}};
    TextScanner in(path, text, '#');
    in.skip_white();
    const Index count = in.index("the number of surfaces");
    in.skip_line();
    std::size_t set = 0;
    std::string conditions;
    for (Index i = 0; i < count; ++i) {
        in.skip_white();
        const std::int64_t number = in.integer("the number of surface " + std::to_string(i + 1));
        const std::int64_t condition =
            in.integer("the boundary condition of surface " + std::to_string(number));
        const std::string name(in.at_line_end() ? std::to_string(number) : in.word("a name"));
        in.skip_line();
        names.groups.push_back({"group", number, number, percent_decoded(name)});
        set += condition != 0 ? 1 : 0;
        conditions += std::to_string(condition) + " " + name + "\n";
    }
    if (set > 0)
        names.sections.push_back(
            {"ugrid", "the boundary conditions of " + std::to_string(set) + " group(s)", conditions, false});
    return names;
}

UgridNames read_ugrid_names_beside(const std::string& mesh_path)
{
    const std::string path = path_of_names(mesh_path);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return {};
    const InputFile file(path);
    return read_ugrid_names(path, file.bytes());
}

std::vector<Companion> ugrid_names(const MeshData& mesh)
{
    if (mesh.groups.empty() && element_order_text(mesh.elements).empty())
        return {};
    return {{".mapbc", write_names, path_of_names}};
}

} // namespace morph
