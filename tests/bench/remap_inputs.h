#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph::bench {

/// Points at random in the unit square.
Points random_points(Index count);

/// Unit square of about @p vertices vertices and twice as many triangles, numbered row by row, with the nodal
/// fields "pressure" (1 component) and "velocity" (3): as a file holds it.
MeshData source_data(Index vertices);

/// The same as a mesh.
Mesh source_mesh(Index vertices);

/// Where the unknown points of a Cloud lie: between the known ones, or in a rim of a tenth around them.
enum class Place { between, around };

/// What is left to inverse distance weighting: 100,000 random points of a square with values of 4
/// components, and as many without; both along a space-filling curve, as the vertices of a Mesh are.
struct Cloud {
    Points positions;
    std::vector<Index> known, unknown;
    Matrix values;
};
Cloud cloud(Place place);

} // namespace morph::bench
