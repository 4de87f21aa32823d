#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <string>
#include <vector>

namespace morph::examples {

/// One of the thesis's cases of carrying a field between two meshes of one domain (its section 4.4), rebuilt
/// with about as many nodes and elements.
struct RemapCase {
    std::string name;
    MeshData coarse;
    MeshData fine;
};

/// An S-shaped pipe, x in [0, 2], with triangles and with quads, and the surroundings of a NACA 0012 with
/// quads near the airfoil and triangles farther out.
std::vector<RemapCase> remap_cases();

/// A smooth velocity, the same for every case.
std::array<double, 2> velocity(double x, double y);

/// The mesh with the velocity as a nodal field of that name, two components.
MeshData with_velocity(MeshData mesh);

} // namespace morph::examples
