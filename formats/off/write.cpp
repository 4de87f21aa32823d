#include "formats/off/files.h"
#include "formats/text/number_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

/// The first field that stands behind coordinates under this name, or null.
const Field* held_field(const MeshData& mesh, std::string_view name)
{
    for (const Field& field : mesh.fields) {
        const Eigen::Index columns = field.values.cols();
        const bool fits =
            name == kOffTexture ? columns == 2 : columns == 3 || (name == kOffColor && columns == 4);
        if (field.location == FieldLocation::vertex && field.name == name && fits)
            return &field;
    }
    return nullptr;
}

/// In the order in which they stand in a line.
std::array<const Field*, 3> held_fields(const MeshData& mesh)
{
    return {held_field(mesh, kOffNormal), held_field(mesh, kOffColor), held_field(mesh, kOffTexture)};
}

} // namespace

void write_off(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    const auto fields = held_fields(mesh);
    out.append(std::string(fields[2] ? "ST" : "") + (fields[1] ? "C" : "") + (fields[0] ? "N" : "") +
               "OFF\n" + std::to_string(mesh.points.rows()) + " " + std::to_string(mesh.elements.size()) +
               " 0\n");
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        char* to = out.room(12 * kLongestNumber);
        for (int k = 0; k < 3; ++k)
            to = number_text(to, mesh.points(v, k), ' ');
        for (const Field* field : fields)
            for (Eigen::Index c = 0; field && c < field->values.cols(); ++c)
                to = number_text(to, field->values(v, c), ' ');
        to[-1] = '\n';
        out.advance_to(to);
    }
    for (const Element& element : mesh.elements) {
        out.append(corner_count(element) == 3 ? "3 " : "4 ");
        append_corners(out, element, 0);
    }
}

std::vector<std::string> off_losses(const MeshData& mesh, const WriteOptions&)
{
    const auto held = held_fields(mesh);
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        if (field.location == FieldLocation::vertex &&
            std::find(held.begin(), held.end(), &field) == held.end())
            names.push_back(field.name);
    if (names.empty())
        return {};
    return {std::to_string(names.size()) + " nodal field(s) " + joined(names) +
            ", only normal, color and texture of 3, 3 or 4, and 2 components"};
}

} // namespace morph
