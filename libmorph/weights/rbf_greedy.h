#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"
#include "libmorph/weights/rbf.h"

#include <vector>

namespace morph {

/// When greedy_centres() has enough.
struct GreedyOptions {
    double tolerance = 1e-3;   ///< largest error at a held vertex, over the largest value (norms of rows)
    Index most_centres = 4000; ///< at most kMostCentres
};

/// Held vertices that interpolate given values to a tolerance, as centres for rbf_extension() [greedy choice:
/// Rendall and Allen 2009, Journal of Computational Physics 228, 6231-6249].
///
/// From a few that span the mesh on, each round adds the vertices where the error is largest: to keep the
/// rounds few, the worst of each group of neighbours, half as many groups as there are centres. m centres of
/// k held vertices cost about m^3 / 2 + 3 k m and m^2 numbers of memory.
///
/// @param values  k x c, in the order of held.vertices
/// @return vertices, ascending
/// @throws InputError   as rbf_extension() and UniqueDirichletVertices::join(); a tolerance that is not
///                      positive
/// @throws SolverError  as rbf_extension(); most_centres are not enough
std::vector<Index> greedy_centres(const DomainView& domain, const DirichletBoundary& boundary,
                                  const Matrix& values, const RbfOptions& options = {},
                                  const GreedyOptions& greedy = {});

} // namespace morph
