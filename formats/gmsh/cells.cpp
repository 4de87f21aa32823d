#include "formats/gmsh/cells.h"

#include <algorithm>
#include <string_view>

namespace morph {

namespace {

struct CellName {
    int type;
    std::string_view name;
};

// From GmshDefines.h.
constexpr std::array<CellName, 21> kNames{{
    {8, "a line of 3 nodes"},
    {9, "a triangle of 6 nodes"},
    {10, "a quad of 9 nodes"},
    {11, "a tetrahedron of 10 nodes"},
    {12, "a hexahedron of 27 nodes"},
    {13, "a prism of 18 nodes"},
    {14, "a pyramid of 14 nodes"},
    {16, "a quad of 8 nodes"},
    {17, "a hexahedron of 20 nodes"},
    {18, "a prism of 15 nodes"},
    {19, "a pyramid of 13 nodes"},
    {20, "a triangle of 9 nodes"},
    {21, "a triangle of 10 nodes"},
    {23, "a triangle of 15 nodes"},
    {25, "a triangle of 21 nodes"},
    {26, "a line of 4 nodes"},
    {27, "a line of 5 nodes"},
    {28, "a line of 6 nodes"},
    {29, "a tetrahedron of 20 nodes"},
    {34, "a polygon"},
    {35, "a polyhedron"},
}};

} // namespace

std::string gmsh_cell_name(std::int64_t type)
{
    const auto* const found =
        std::find_if(kNames.begin(), kNames.end(), [&](const CellName& cell) { return cell.type == type; });
    if (found == kNames.end())
        return "of the unknown type " + std::to_string(type);
    return std::string(found->name) + " (type " + std::to_string(type) + ")";
}

} // namespace morph
