#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// What the formats share that know parts of a mesh by number only (MEDIT, UGRID): the names go into comments
/// "# marker 3 = wing", which other programs pass over.

/// One line of a table of names. Several numbers in a row may share a name: "# vertex field 5 to 9 = stress".
struct NumberedName {
    std::string kind; ///< what is numbered: "marker", "group", "vertex field"
    std::int64_t first = 0;
    std::int64_t last = 0;
    std::string name;
};

/// The comments that stand for a table, a line each. Control characters, percent signs and blanks at the ends
/// of a name become %XX.
std::string names_text(const std::vector<NumberedName>& names);

/// The lines of a table among the comments of @p text; other comments are passed over.
std::vector<NumberedName> read_names(std::string_view text);

/// A number of its own for each name: the name itself where it is one (a file's "3" stays 3; of several such,
/// the first), else the smallest number from 1 that is free.
/// @param zero  whether a name "0" may keep its number
std::vector<std::int32_t> numbers_of(const std::vector<std::string>& names, bool zero);

/// The numbers of a mesh's groups, and for each element that of its first group; 0: of none.
struct GroupReferences {
    std::vector<std::int32_t> groups;
    std::vector<std::int32_t> elements;
};
GroupReferences group_references(const MeshData& mesh);

/// The groups that the numbers of the elements say; 0 is no group unless the table has it. Those of the table
/// come first, in its order, then others by the first of their elements, called as their number.
std::vector<ElementGroup> groups_from(const std::vector<std::int64_t>& references,
                                      const std::vector<NumberedName>& names);

/// The same for the edges of markers, of which every number counts.
std::vector<Marker> markers_from(const std::vector<std::array<Index, 2>>& edges,
                                 const std::vector<std::int64_t>& references,
                                 const std::vector<NumberedName>& names);

} // namespace morph
