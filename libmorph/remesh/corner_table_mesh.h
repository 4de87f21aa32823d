#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/remesh_state.h"

#include <vector>

namespace morph {

/// The triangles of a mesh that are not kept, in its numbering. Sides of kept elements are tagged kKeptTag,
/// vertices of such elements fixed.
/// @param mesh  with m elements
/// @param kept  m: the element stays as it is; quads are always kept
CornerTable corner_table_of(const Mesh& mesh, const std::vector<bool>& kept);

/// How the new mesh is numbered.
enum class NumberingRule {
    fresh,   ///< kept elements first, then along the corner table
    keep_old ///< what is left of the input keeps its number where that is within the new count
};

/// Where the vertices of a remeshed mesh come from.
struct RemeshResult {
    MeshData data; ///< without fields and groups
    std::vector<Index>
        below; ///< per vertex of the data: triangle of the background mesh, -1 for one of kept elements only
    Eigen::VectorXd sizes; ///< per vertex of the input: target size after limit_by_curves()
};

/// The mesh after remeshing: kept elements, new triangles, markers in their order. Listed as the input lists
/// its elements, markers as the input lists theirs.
/// @param state   after remeshing
/// @param before  corner_table_of() the mesh with its features found: markers are known on it
/// @param mesh    the input
/// @param kept    m: elements that stayed
/// @param rule    how vertices and elements are numbered
RemeshResult mesh_of(const RemeshState& state, const CornerTable& before, const Mesh& mesh,
                     const std::vector<bool>& kept, NumberingRule rule);

} // namespace morph
