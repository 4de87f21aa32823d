#pragma once

#include "libmorph/basis/closest.h"
#include "libmorph/basis/curve.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/numerics/dirichlet_laplacian.h"
#include "libmorph/weights/weights.h"

#include <string>
#include <vector>

namespace morph {

/// A marker of the mesh and the curve that carries it; each node has its parameter.
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
    DirichletSet held;                 ///< basis functions on the curves, 0 on the fixed markers
    std::vector<SharedVertex> shared;
    std::vector<std::array<Index, 2>> moving_edges; ///< edges of the markers that curves carry
    std::vector<std::array<Index, 2>> marker_edges; ///< edges of all held markers
    Index unmarked = 0; ///< vertices of the boundary in no marker; they are held too
};

/// Prescribe the weights on the boundary.
///
/// Node l of a curve gets the basis functions N_i(u_l) [Tavla 2021, 3.5], every fixed node 0. A vertex
/// that several curves end in gets the mean of their rows, so that it follows them when they move
/// alike; one that a fixed marker holds as well stays fixed. Boundary vertices in no marker are held.
/// The copies of a split vertex are one vertex here, and one of them stands for it in the result.
///
/// @param fixed  markers held still; other markers without a curve are left free
/// @throws InputError  a fixed marker does not exist or is one of the boundaries
BoundaryConditions boundary_conditions(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                                       const std::vector<std::string>& fixed);

/// Check that ends which share a vertex stay together.
///
/// @param displacements  K x 2, in the order of conditions.columns
/// @throws InputError  names the vertex, the boundaries and the control points that part
void require_ends_together(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                           const BoundaryConditions& conditions, const Points2& displacements);

} // namespace morph
