#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/remesh_state.h"

#include <string>
#include <vector>

namespace morph {

/// A curve that the nodes of a marker are on.
struct MarkerCurve {
    std::string marker;
    Curve curve;
};

/// What of a mesh is a feature, to be kept when it is remeshed.
struct FeatureSettings {
    std::vector<MarkerCurve> curves; ///< planar meshes; other markers keep the curve through their nodes
    double corner_angle =
        30; ///< degrees; a node of a line that turns by this much more than its neighbours stays
    double crease_angle = 40; ///< degrees between the normals of two triangles of a surface
};

/// Find the feature edges of a corner table and the curves they are on, and hold the vertices of both.
///
/// Features are borders, edges of markers and, on a surface, creases. Their vertices become those of curves;
/// where other than two feature edges meet, a marker begins or ends, or the line has a corner, they are
/// fixed.
///
/// @param state     its corner table has sides of kept elements tagged already, and their vertices fixed
/// @param mesh      the input
/// @param settings  angles that make a feature
/// @throws InputError  as node_parameters(); a curve whose marker is not in the mesh
void find_features(RemeshState& state, const Mesh& mesh, const FeatureSettings& settings);

/// The halfedge of the corner table from a vertex of the mesh to another; -1: there is none.
class TableEdges {
public:
    TableEdges(const CornerTable& table, Index mesh_vertices);
    /// Either way round: the halfedge may run from @p to to @p from when only that one exists.
    Index find(Index from, Index to) const;

private:
    Index find_directed(Index from, Index to) const;

    const CornerTable& table_;
    std::vector<Index> first_;        ///< of a mesh vertex
    std::vector<Index> next_of_same_; ///< of a vertex of the table, the next copy
};

} // namespace morph
