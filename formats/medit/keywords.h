#pragma once

#include "formats/mesh/volume_cells.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// The keywords of MEDIT's files, in text as words and in binary as numbers: the table of libMeshb 7,
/// https://github.com/LoicMarechal/libMeshb.

inline constexpr std::int32_t kMeditDimension = 3;
inline constexpr std::int32_t kMeditEnd = 54;

/// A section with a line of corners and a reference for each edge, face or cell.
struct MeditShape {
    std::string_view keyword;
    std::string_view singular; ///< "triangle", for messages
    std::size_t corners;
    std::optional<VolumeShape> volume = std::nullopt;
};
/// The shape of a section, or null.
const MeditShape* find_medit_shape(std::string_view keyword);

/// What the numbers of a section such as Ridges count.
enum class MeditListed { vertices, edges, triangles, quads };

/// A section that lists vertices, edges or faces.
struct MeditList {
    std::string_view keyword;
    MeditListed listed;
};
/// All of them.
const std::vector<MeditList>& medit_lists();

/// True for curved edges, faces and cells (TrianglesP2) and for polygons and polyhedra.
bool is_unsupported_medit_shape(std::string_view keyword);

/// Number of a keyword; 0: none that is known here.
std::int32_t medit_code(std::string_view keyword);
/// Keyword of a number; one not known here is called "number 94".
std::string medit_keyword(std::int32_t code);

} // namespace morph
