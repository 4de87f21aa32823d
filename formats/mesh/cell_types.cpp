#include "formats/mesh/cell_types.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace morph {

namespace {

struct CellType {
    int number;
    std::string_view name;
};

// From VTK's vtkCellType.h.
constexpr std::array<CellType, 39> kCellTypes{{
    {1, "a vertex"},
    {2, "a set of vertices"},
    {3, "an edge"},
    {4, "a polyline"},
    {5, "a triangle"},
    {6, "a triangle strip"},
    {7, "a polygon"},
    {8, "a pixel"},
    {9, "a quad"},
    {10, "a tetrahedron"},
    {11, "a voxel"},
    {12, "a hexahedron"},
    {13, "a prism"},
    {14, "a pyramid"},
    {15, "a pentagonal prism"},
    {16, "a hexagonal prism"},
    {21, "a quadratic edge"},
    {22, "a quadratic triangle"},
    {23, "a quadratic quad"},
    {24, "a quadratic tetrahedron"},
    {25, "a quadratic hexahedron"},
    {26, "a quadratic prism"},
    {27, "a quadratic pyramid"},
    {28, "a biquadratic quad"},
    {29, "a triquadratic hexahedron"},
    {30, "a quadratic-linear quad"},
    {31, "a quadratic-linear prism"},
    {32, "a biquadratic-quadratic prism"},
    {33, "a biquadratic-quadratic hexahedron"},
    {34, "a biquadratic triangle"},
    {35, "a cubic edge"},
    {36, "a quadratic polygon"},
    {42, "a polyhedron"},
    {68, "a Lagrange curve"},
    {69, "a Lagrange triangle"},
    {70, "a Lagrange quad"},
    {71, "a Lagrange tetrahedron"},
    {72, "a Lagrange hexahedron"},
    {73, "a Lagrange prism"},
}};

} // namespace

std::string cell_type_name(std::int64_t type)
{
    const auto* const found = std::find_if(kCellTypes.begin(), kCellTypes.end(),
                                           [&](const CellType& t) { return t.number == type; });
    if (found == kCellTypes.end())
        return "of the unknown type " + std::to_string(type);
    return std::string(found->name) + " (type " + std::to_string(type) + ")";
}

} // namespace morph
