#pragma once

#include "libmorph/basis/closest.h"
#include "libmorph/basis/curve.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"
#include "libmorph/weights/weights.h"

#include <string>
#include <vector>

namespace morph {

/// A curve and the marker that follows it.
struct NamedCurve {
    std::string marker;
    Curve curve;
};

/// A marker of the mesh and the curve it follows; each node has its parameter.
struct CurveBoundary {
    std::string name; ///< of the marker
    Curve curve;
    std::vector<Index> vertices;            ///< m, in order along the marker
    std::vector<CurveParameter> parameters; ///< m
    bool closed_chain = false;              ///< the last vertex is followed by the first
};

/// Give each node of a marker its parameter on a curve.
///
/// @throws InputError  no such marker, it branches or is in pieces, the mesh is not planar, a closed
///                     marker on an open curve whose ends do not meet
CurveBoundary parametrize_marker(const Mesh& mesh, const std::string& marker_name, const Curve& curve);

/// A vertex that more than one boundary lays claim to: the ends of two curves, or an end on a fixed marker.
struct SharedVertex {
    /// Basis functions of one of the curves at the vertex.
    struct Claim {
        std::size_t boundary; ///< which of the CurveBoundary list
        BasisRow row;
    };

    Index vertex = 0;
    std::vector<Claim> claims;
    std::string fixed_by; ///< the marker that holds it, or empty
};

/// What the weights are on the boundary, and how their matrix is laid out.
struct BoundaryConditions {
    std::vector<ControlPoint> columns; ///< K: those of the first boundary, then of the second, ...
    std::vector<Index> first_column;   ///< of each boundary
    DirichletBoundary boundary;        ///< markers that follow curves move, fixed ones stay
    Matrix values; ///< k x K, row i belongs to boundary.vertices[i]: basis functions, 0 on the fixed markers
    std::vector<SharedVertex> shared;
    Index unmarked = 0; ///< vertices of the boundary in no marker; they are held too
};

/// Prescribe the weights on the boundary.
///
/// Node l of a curve gets the basis functions N_i(u_l) [Tavla 2021, 3.5], every fixed node 0. A vertex
/// that several curves end in gets the mean of their rows, so that it follows them when they move
/// alike; one that a fixed marker holds as well stays fixed. Boundary vertices in no marker are held.
/// The copies of a split vertex are one vertex here, and one of them stands for it in the result.
///
/// @param mesh        undeformed, planar
/// @param boundaries  markers that follow a curve, see parametrize_marker()
/// @param fixed       markers held still; other markers without a curve are left free
/// @throws InputError  a fixed marker does not exist or is one of the boundaries
BoundaryConditions boundary_conditions(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                                       const std::vector<std::string>& fixed);

/// The same in one call: each marker follows its curve, every other marker is fixed.
/// @throws InputError  as parametrize_marker()
BoundaryConditions boundary_conditions(const Mesh& mesh, const std::vector<NamedCurve>& curves);

/// The names of the markers of a mesh that are not among @p carried, each once.
std::vector<std::string> other_markers(const Mesh& mesh, const std::vector<std::string>& carried);

/// Weights of the control points: what extends their basis functions from the boundary into the mesh.
///
/// Methods whose components influence each other have none; they extend the displacements of the boundary,
/// conditions.values times those of the control points.
/// @param conditions  K columns and the boundary they are given on
/// @param extension   of conditions.boundary
/// @throws InputError   the extension has more than one component; as BoundaryExtension::extend()
/// @throws SolverError  the result is not finite
Weights extended_weights(const BoundaryConditions& conditions, const BoundaryExtension& extension);

/// Check that ends which share a vertex stay together.
///
/// @param mesh           for the numbers in messages
/// @param boundaries     as given to boundary_conditions()
/// @param conditions     from boundary_conditions()
/// @param displacements  K x 2, in the order of conditions.columns
/// @throws InputError  names the vertex, the boundaries and the control points that part
void require_ends_together(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                           const BoundaryConditions& conditions, const Points2& displacements);

} // namespace morph
