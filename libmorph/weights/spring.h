#pragma once

#include "libmorph/core/names.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// How stiff a spring of a given length is.
enum class SpringStiffness {
    inverse_length,        ///< 1 / length
    inverse_length_squared ///< 1 / length^2: short edges keep their length better
};

template <>
inline constexpr auto kEnumNames<SpringStiffness> = std::to_array<EnumName<SpringStiffness>>({
    {SpringStiffness::inverse_length, "inverse-length"},
    {SpringStiffness::inverse_length_squared, "inverse-length-squared"},
});

/// What keeps the corners of elements from turning inside out, in addition to springs along the edges.
enum class SpringBracing {
    none,       ///< nothing: spring_extension()
    torsion,    ///< springs against the change of each corner's angle, 1 / sin^2(angle)
    ball_vertex ///< springs from each corner to the line through its two neighbours
};

template <>
inline constexpr auto kEnumNames<SpringBracing> = std::to_array<EnumName<SpringBracing>>({
    {SpringBracing::none, "none"},
    {SpringBracing::torsion, "torsion"},
    {SpringBracing::ball_vertex, "ball-vertex"},
});

/// Which springs.
struct SpringOptions {
    SpringStiffness stiffness = SpringStiffness::inverse_length_squared;
    SpringBracing bracing = SpringBracing::torsion;
};

/// Springs along the edges of the mesh that pull on x and y apart [Batina 1990, AIAA Journal 28(8),
/// 1381-1388]: the graph Laplacian with the weights of @p stiffness.
///
/// Every column keeps the bounds of its held values. Copies of a split vertex are one unknown; a vertex of no
/// element gets 0. Scaling, turning or shifting the mesh changes the result by round-off only.
///
/// @throws InputError   the mesh is a surface in space; an index in @p boundary is out of range or a vertex
///                      there twice; a part of the mesh has no held vertex; an edge has no length
/// @throws SolverError  the system is singular
std::unique_ptr<BoundaryExtension> spring_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                    SpringStiffness stiffness);

/// Springs along the edges that pull along them only, and a bracing at each corner of each element: torsional
/// springs [Farhat, Degand, Koobus & Lesoinne 1998, Computer Methods in Applied Mechanics and Engineering
/// 163, 231-245] or ball-vertex springs [Bottasso, Detomi & Serra 2005, Computer Methods in Applied Mechanics
/// and Engineering 194, 4244-4264].
///
/// A corner is the triangle of a vertex and its two neighbours along the element: of a quad there are four,
/// and what they hold open is what makes its corner Jacobians positive. The ball is the foot of the
/// perpendicular on the line through the neighbours, which need not lie between them: the spring then resists
/// exactly the change of the height to first order. Torsion with 1 / length springs is multiplied by the root
/// of the product of the corner's two edges, so that the unit of length does not matter.
///
/// Translations, and turns of everything to first order in the angle, are reproduced: no spring changes.
/// Copies of a split vertex are one unknown; a vertex of no element stays.
///
/// @throws InputError   as spring_extension(); a part of the mesh has fewer than two held vertices; a corner
///                      of an element has no angle, three of its points being on a line; no bracing
/// @throws SolverError  the system is singular
std::unique_ptr<BoundaryExtension> braced_spring_extension(const Mesh& mesh,
                                                           const DirichletBoundary& boundary,
                                                           SpringStiffness stiffness, SpringBracing bracing);

} // namespace morph
