#pragma once

#include "libmorph/core/predicates.h"
#include "libmorph/mesh/mesh.h"

#include <array>

namespace morph {

/// Corners of a triangle or quad of the plane, in order around it, whichever way round.
struct PlaneElement {
    std::array<PlanePoint, 4> corner{};
    int corners = 3; ///< 3 or 4
};

/// The element of a planar mesh, its first corner as in the file.
PlaneElement plane_element(const Mesh& mesh, Index face);

/// The diagonal that cuts a quad into two triangles.
enum class Diagonal {
    first_third,   ///< triangles 1 2 3 and 1 3 4, counted from 1: that of the thesis
    second_fourth, ///< triangles 2 3 4 and 2 4 1
};

/// The diagonal that lies inside a quad: the first where both do, or none (the sides cross).
Diagonal inner_diagonal(const PlaneElement& quad);

/// Whether all corners of a quad turn the same way, none of them straight: exact.
bool is_convex(const PlaneElement& quad);

/// The two triangles of a quad as numbers of its corners, from 0.
std::array<std::array<int, 3>, 2> halves(Diagonal diagonal);

/// Whether a point lies in a triangle or on its sides, whichever way round it runs; a triangle without area
/// is the segment that it covers: exact.
bool triangle_contains(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint p);

/// Whether a point lies in an element or on its sides: exact. A quad that is not convex is its two triangles
/// along the inner diagonal.
bool contains(const PlaneElement& element, PlanePoint p);

} // namespace morph
