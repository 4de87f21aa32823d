#pragma once

#include "formats/cgns/zone.h"

#include <string>
#include <vector>

namespace morph {

/// A family of a base, by whose node boundary conditions and subregions name it.
struct CgnsFamily {
    std::string node;
    std::string name;      ///< which may be longer
    bool no_edges = false; ///< a marker that no zone has an edge of
};

/// One mesh of several zones, whose vertices follow one another. Markers and groups of one name become one,
/// in the order of the families; every zone is a group too when there are several. Fields that some zone does
/// not have are left out with a warning.
/// @throws InputError  the zones have more vertices than an Index can number
VolumeFile merge_cgns_zones(std::vector<CgnsZone> zones, const std::vector<CgnsFamily>& families,
                            const InputBytes& input);

} // namespace morph
