#pragma once

#include "formats/cgns/zone.h"

#include <cstdint>
#include <string>
#include <vector>

namespace morph {

/// What the points of a set are.
enum class CgnsPlace { vertex, element, i_face, j_face, k_face, any_face };

/// A boundary condition or a subregion of a zone, as the file has it.
struct CgnsPointSet {
    std::string what;   ///< "boundary condition 'a'", for messages
    std::string name;   ///< of the marker and the group: that of the family, or its own
    bool range = false; ///< from the first of two points to the second
    CgnsPlace place = CgnsPlace::vertex;
    std::vector<std::int64_t> points; ///< from 1; an index each in an unstructured zone, two or three in a
                                      ///< structured one
};

/// Those of a zone, boundary conditions first.
/// @throws InputError  "path: zone 'a', boundary condition 'b': …"
std::vector<CgnsPointSet> read_cgns_point_sets(const CgnsFile& file, const CgnsZone& zone);

/// Add a set of a structured zone, that is not a list of vertices, to the zone's markers (lines of its grid)
/// or groups (quads).
/// @throws InputError  an index is out of range
void add_cgns_grid_set(const CgnsFile& file, CgnsZone& zone, const CgnsPointSet& set);

/// The numbers of the vertices that a set of a structured zone lists.
/// @throws InputError  an index is out of range
std::vector<Index> cgns_grid_vertices(const CgnsFile& file, CgnsZone& zone, const CgnsPointSet& set);

/// Each of these indices below @p count once, where it is first.
std::vector<Index> each_once(std::vector<Index> indices, std::size_t count);

/// Warn that a set is not in the mesh.
void leave_out_cgns_set(const CgnsFile& file, const CgnsZone& zone, const CgnsPointSet& set,
                        const std::string& why);

/// @throws InputError  about a set
[[noreturn]] void fail_of_cgns_set(const CgnsFile& file, const CgnsZone& zone, const CgnsPointSet& set,
                                   const std::string& what);

} // namespace morph
