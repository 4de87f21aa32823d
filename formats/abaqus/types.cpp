#include "formats/abaqus/types.h"

#include <array>
#include <cctype>
#include <string_view>

namespace morph {

namespace {

struct Base {
    std::string_view name;
    AbaqusType type;
};

constexpr AbaqusType kShellTriangle{AbaqusShape::triangle, false};
constexpr AbaqusType kPlaneTriangle{AbaqusShape::triangle, true};
constexpr AbaqusType kShellQuad{AbaqusShape::quad, false};
constexpr AbaqusType kPlaneQuad{AbaqusShape::quad, true};
constexpr AbaqusType kLine{AbaqusShape::line, false};
constexpr AbaqusType kPoint{AbaqusShape::point, false};

// From the index of elements in the Abaqus Elements Guide.
constexpr std::array<Base, 63> kBases{{
    {"S3", kShellTriangle},
    {"STRI3", kShellTriangle},
    {"DS3", kShellTriangle},
    {"M3D3", kShellTriangle},
    {"R3D3", kShellTriangle},
    {"SFM3D3", kShellTriangle},
    {"F3D3", kShellTriangle},
    {"CPS3", kPlaneTriangle},
    {"CPE3", kPlaneTriangle},
    {"CPEG3", kPlaneTriangle},
    {"CAX3", kPlaneTriangle},
    {"DC2D3", kPlaneTriangle},
    {"AC2D3", kPlaneTriangle},
    {"DCAX3", kPlaneTriangle},
    {"ACAX3", kPlaneTriangle},
    {"S4", kShellQuad},
    {"DS4", kShellQuad},
    {"M3D4", kShellQuad},
    {"R3D4", kShellQuad},
    {"SFM3D4", kShellQuad},
    {"F3D4", kShellQuad},
    {"CPS4", kPlaneQuad},
    {"CPE4", kPlaneQuad},
    {"CPEG4", kPlaneQuad},
    {"CAX4", kPlaneQuad},
    {"DC2D4", kPlaneQuad},
    {"AC2D4", kPlaneQuad},
    {"DCAX4", kPlaneQuad},
    {"ACAX4", kPlaneQuad},
    {"B21", kLine},
    {"B23", kLine},
    {"B31", kLine},
    {"B33", kLine},
    {"T2D2", kLine},
    {"T3D2", kLine},
    {"PIPE21", kLine},
    {"PIPE31", kLine},
    {"R2D2", kLine},
    {"RB2D2", kLine},
    {"RB3D2", kLine},
    {"DC1D2", kLine},
    {"F2D2", kLine},
    {"SAX1", kLine},
    {"MAX1", kLine},
    {"RAX2", kLine},
    {"C3D4", {AbaqusShape::tetrahedron}},
    {"DC3D4", {AbaqusShape::tetrahedron}},
    {"AC3D4", {AbaqusShape::tetrahedron}},
    {"C3D5", {AbaqusShape::pyramid}},
    {"AC3D5", {AbaqusShape::pyramid}},
    {"C3D6", {AbaqusShape::prism}},
    {"DC3D6", {AbaqusShape::prism}},
    {"AC3D6", {AbaqusShape::prism}},
    {"SC6", {AbaqusShape::prism}},
    {"COH3D6", {AbaqusShape::prism}},
    {"C3D8", {AbaqusShape::hexahedron}},
    {"DC3D8", {AbaqusShape::hexahedron}},
    {"AC3D8", {AbaqusShape::hexahedron}},
    {"SC8", {AbaqusShape::hexahedron}},
    {"COH3D8", {AbaqusShape::hexahedron}},
    {"MASS", kPoint},
    {"ROTARYI", kPoint},
    {"HEATCAP", kPoint},
}};

constexpr std::array<std::string_view, 5> kPointFamilies{"SPRING", "DASHPOT", "CONN", "JOINTC", "DCOUP"};

} // namespace

std::optional<AbaqusType> abaqus_type(const std::string& name)
{
    for (const std::string_view family : kPointFamilies)
        if (name.starts_with(family))
            return kPoint;
    for (const Base& base : kBases) {
        const std::size_t length = base.name.size();
        if (name.starts_with(base.name) &&
            (name.size() == length || std::isdigit(static_cast<unsigned char>(name[length])) == 0))
            return base.type;
    }
    return std::nullopt;
}

int corner_count(AbaqusShape shape)
{
    constexpr std::array<int, 8> counts{2, 3, 4, 4, 5, 6, 8, 0};
    return counts.at(static_cast<std::size_t>(shape));
}

std::vector<int> abaqus_side(AbaqusShape shape, int number)
{
    using Sides = std::vector<std::vector<int>>;
    static const std::array<Sides, 8> sides{{
        {},
        {{0, 1}, {1, 2}, {2, 0}},
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
        {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}},
        {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}},
        {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
        {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}},
        {},
    }};
    const Sides& of_shape = sides.at(static_cast<std::size_t>(shape));
    if (number < 1 || static_cast<std::size_t>(number) > of_shape.size())
        return {};
    return of_shape[static_cast<std::size_t>(number) - 1];
}

} // namespace morph
