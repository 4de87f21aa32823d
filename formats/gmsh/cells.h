#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace morph {

/// Element types by Gmsh's numbers, as far as they are understood.
inline constexpr int kGmshLine = 1;
inline constexpr int kGmshTriangle = 2;
inline constexpr int kGmshQuad = 3;
inline constexpr int kGmshPoint = 15;

struct GmshCell {
    int dimension = -1; ///< -1: not understood
    int corners = 0;
};

inline GmshCell gmsh_cell(std::int64_t type)
{
    constexpr std::array<GmshCell, 8> cells{{{}, {1, 2}, {2, 3}, {2, 4}, {3, 4}, {3, 8}, {3, 6}, {3, 5}}};
    if (type == kGmshPoint)
        return {0, 1};
    return type > 0 && type < 8 ? cells.at(static_cast<std::size_t>(type)) : GmshCell{};
}

/// "a quadratic triangle (type 9)", or "of the unknown type 999": for the message that refuses it.
std::string gmsh_cell_name(std::int64_t type);

} // namespace morph
