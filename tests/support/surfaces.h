#pragma once

#include "libmorph/mesh/mesh_data.h"

namespace morph::test {

/// The unit sphere: an octahedron of which every triangle is cut into @p cuts² by lines through the origin.
MeshData sphere(Index cuts);

/// A torus around the z axis, @p around x @p across quads cut in two; radii 1 and 0.4.
MeshData torus(Index around, Index across);

/// The unit cube, each face @p cuts² squares cut in two.
MeshData cube(Index cuts);

/// The upper half of sphere(), open at the equator.
MeshData hemisphere(Index cuts);

/// A quarter of a cylinder of radius 1 and length 2, open, of 2 @p cuts x @p cuts squares cut in two.
MeshData bent_plate(Index cuts);

/// What a scanner leaves: @p count points at random on a sphere with bumps and dents of some 10 % of its
/// radius and a noise of 0.2 %, and the triangles between them, of all shapes.
MeshData scan(Index count);

/// Volume within a closed surface.
double volume(const MeshData& surface);

/// Area of a surface's triangles.
double surface_area(const MeshData& surface);

/// Vertices - edges + faces.
Index euler_characteristic(const MeshData& surface);

} // namespace morph::test
