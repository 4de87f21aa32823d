#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace morph {

/// A block of elements in an AFLR/UGRID file.
struct UgridBlock {
    std::string_view name; ///< "triangle", for messages
    std::size_t corners;
};

/// In the order of the counts, behind that of the vertices. Faces have a number of their surface each, cells
/// stand behind these.
inline constexpr std::array<UgridBlock, 6> kUgridBlocks{{{"triangle", 3},
                                                         {"quadrilateral", 4},
                                                         {"tetrahedron", 4},
                                                         {"pyramid", 5},
                                                         {"prism", 6},
                                                         {"hexahedron", 8}}};

/// The seven counts at the start of a file.
using UgridCounts = std::array<std::int64_t, 7>;

/// Whole numbers behind the coordinates.
/// @param counts  none negative, each below 2^31
constexpr std::uint64_t ugrid_whole_numbers(const UgridCounts& counts)
{
    std::uint64_t numbers = 0;
    for (std::size_t b = 0; b < kUgridBlocks.size(); ++b)
        numbers += static_cast<std::uint64_t>(counts[b + 1]) * (kUgridBlocks[b].corners + (b < 2 ? 1 : 0));
    return numbers;
}

} // namespace morph
