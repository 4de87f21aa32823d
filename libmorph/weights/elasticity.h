#pragma once

#include "libmorph/core/names.h"
#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// Young's modulus of the elements: those where it is large keep their shape.
enum class YoungsModulus {
    uniform,          ///< 1
    inverse_distance, ///< 1 / distance of the element's centre to the nearest moving edge
    inverse_area      ///< 1 / area of the element
};

template <>
inline constexpr auto kEnumNames<YoungsModulus> = std::to_array<EnumName<YoungsModulus>>({
    {YoungsModulus::uniform, "uniform"},
    {YoungsModulus::inverse_distance, "inverse-distance"},
    {YoungsModulus::inverse_area, "inverse-area"},
});

/// The mesh as a linearly elastic solid in plane strain.
struct Elasticity {
    YoungsModulus modulus = YoungsModulus::inverse_area;
    double poisson_ratio = 0.3; ///< in (-1, 0.5): near 0.5 areas are kept, near -1 angles
};

/// Linear elasticity: div sigma = 0 with sigma = lambda tr(eps) I + 2 mu eps and eps the symmetric gradient
/// of the displacement [Tezduyar, Behr, Mittal & Johnson 1992, ASME AMD 143, 7-24; for the moduli: Stein,
/// Tezduyar & Benney 2003, Journal of Applied Mechanics 70(1), 58-63].
///
/// Linear triangles and bilinear quads (2 x 2 Gauss points) on the elements of the mesh as they are. With a
/// uniform modulus every affine move of the boundary, turns by any angle among them, moves the whole mesh
/// alike. Otherwise translations do, and turns to first order in the angle. Scaling, turning or shifting the
/// mesh changes the result by round-off only. Copies of a split vertex are one unknown; a vertex of no
/// element stays.
///
/// @throws InputError   the mesh is a surface in space; an index in @p boundary is out of range or a vertex
///                      there twice; a part of the mesh has fewer than two held vertices; Poisson's ratio is
///                      out of range; inverse_distance without moving edges; an element is inverted
/// @throws SolverError  the system is singular
std::unique_ptr<BoundaryExtension>
elastic_extension(const DomainView& domain, const DirichletBoundary& boundary, const Elasticity& elasticity);

} // namespace morph
