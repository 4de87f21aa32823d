#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/clip.h"

#include <array>
#include <span>

namespace morph {

/// How elements are cut into convex pieces.
enum class Cut {
    where_dented, ///< only quads that are not convex, into two triangles along the inner diagonal
    triangles,    ///< also convex quads, along the diagonal from the first corner (of the file) to the third
};

/// A convex piece of an element. It runs counter-clockwise, also where the element does not.
struct ConvexPart {
    ConvexPolygon outline; ///< sides: k for the element's from corner k (from 0), kNoSide for a diagonal
    std::array<Index, 4> vertices{-1, -1, -1, -1}; ///< at the corners; the fourth of a triangle is -1
    double area = 0;                               ///< length unit squared, never negative
};

/// The one or two pieces of an element.
struct ConvexParts {
    std::array<ConvexPart, 2> piece;
    int count = 0;

    std::span<const ConvexPart> all() const& { return {piece.data(), static_cast<std::size_t>(count)}; }
    std::span<ConvexPart> all() & { return {piece.data(), static_cast<std::size_t>(count)}; }
    void all() && = delete; // a loop over what split_convex() returns would outlive it
};

/// Cut an element of a planar mesh.
ConvexParts split_convex(const Mesh& mesh, Index face, Cut cut);

/// The number of pieces that split_convex() makes.
int convex_part_count(const Mesh& mesh, Index face, Cut cut);

/// Sum of the areas of all elements of a planar mesh, each positive. Equal bytes for any thread count.
double total_area(const Mesh& mesh);

} // namespace morph
