#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <cstdint>
#include <random>

namespace morph::test {

/// What a small random mesh is like.
struct RandomMesh {
    Index vertices = 20;
    double quads = 0;    ///< share of triangles that are joined with a neighbour to a convex quad
    double holes = 0;    ///< share of elements left out: holes, concave sides, parts that touch or are apart
    double thinness = 1; ///< y is multiplied by it: slivers
    double size_ratio = 1; ///< edges shrink by up to this towards the origin
    int grid = 0;          ///< coordinates are multiples of 1 / grid, so that ties are frequent; 0: any
    std::uint32_t seed = 1;
};

/// A Delaunay triangulation of random points in the unit square, changed as asked for, elements in random
/// order. Vertices of no element may be left.
MeshData random_mesh(const RandomMesh& settings);

/// Points of every kind for a mesh: random ones in and around its box, its vertices, points of its sides
/// (exactly on those with a short midpoint), and some of them twice.
Points random_targets(const MeshData& mesh, Index count, std::mt19937& random);

/// Some mesh of a family that goes through all of RandomMesh with the seed.
RandomMesh some_settings(std::uint32_t seed);

} // namespace morph::test
