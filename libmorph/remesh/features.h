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

/// What of a mesh is a feature, to be kept when it is remade.
struct FeatureSettings {
    std::vector<MarkerCurve> curves; ///< planar meshes; other markers keep the curve through their nodes
    double corner_angle =
        30; ///< degrees; a node of a line that turns by this much more than its neighbours stays
    double crease_angle = 40; ///< degrees between the normals of two triangles of a surface
};

/// Find the feature edges of a net and the curves they are on, and hold the vertices of both.
///
/// Features are borders, edges of markers and, on a surface, creases. Their vertices become those of curves;
/// where other than two feature edges meet, a marker begins or ends, or the line has a corner, they are
/// fixed.
///
/// @param made      its net has sides of kept elements tagged already, and their vertices fixed
/// @throws InputError  as node_parameters(); a curve whose marker is not in the mesh
void find_features(RemeshState& made, const Mesh& mesh, const FeatureSettings& settings);

/// The halfedge of the net from a vertex of the mesh to another; -1: there is none.
class NetEdges {
public:
    NetEdges(const CornerTable& net, Index mesh_vertices);
    /// Either way round: the halfedge may run from @p to to @p from when only that one exists.
    Index find(Index from, Index to) const;

private:
    Index find_directed(Index from, Index to) const;

    const CornerTable& net_;
    std::vector<Index> first_;        ///< of a mesh vertex
    std::vector<Index> next_of_same_; ///< of a net vertex, the next copy
};

} // namespace morph
