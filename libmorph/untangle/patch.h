#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/untangle/corner_energy.h"
#include "libmorph/untangle/vertex_stars.h"

#include <array>
#include <complex>
#include <vector>

namespace morph {

/// Positions in the plane as complex numbers x + i y.
using PlanePositions = std::vector<std::complex<double>>;

/// Corner of an element, and the corner it should look like.
struct TargetCorner {
    std::array<Index, 3> vertex{}; ///< of the patch: the corner itself, the next and the previous one
    std::array<std::complex<double>, 3> slope{}; ///< a = sum slope x, b = sum conj(slope) x; they sum to 0
    double weight = 1;

    CornerMap map(const PlanePositions& x) const;
};

/// Some vertices that may move, and the elements around them.
struct Patch {
    std::vector<Index> vertices;       ///< of the mesh: the free ones first, ascending, then the rim
    Index free = 0;                    ///< number of free vertices
    std::vector<Index> elements;       ///< ascending
    std::vector<TargetCorner> corners; ///< of these elements, but those without a free vertex
};

/// The patches around some elements: the vertices within @p rings elements of them that are not held. VertexLists
/// that share an element are one.
///
/// @param held   by vertex, see VertexStars for which
/// @param rings  negative: the whole mesh
/// @return with vertices and elements only
std::vector<Patch> find_patches(const VertexStars& stars, const std::vector<char>& held,
                                const std::vector<Index>& elements, int rings);

/// Fill in the corners of a patch: their targets are the same corners at @p reference. A corner that is not
/// positive there has the target of its kind (60 or 90 degrees) with the area of a mean corner of the patch.
/// Each element has the same weight.
///
/// @param ignored  by element: has no corners
void set_targets(Patch& patch, const VertexStars& stars, const PositionsView& reference,
                 const std::vector<char>& ignored);

} // namespace morph
