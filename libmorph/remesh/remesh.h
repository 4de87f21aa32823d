#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/corner_table_mesh.h"
#include "libmorph/remesh/features.h"

#include <vector>

namespace morph {

struct RemeshSettings {
    FeatureSettings features;
    std::vector<bool> kept; ///< m: elements that stay as they are; empty: quads only
    int iterations = 5;     ///< rounds of splitting, collapsing, flipping and smoothing
    NumberingRule numbering = NumberingRule::fresh;
    bool hold_features = false; ///< no vertex of a feature moves, no edge of one is split
    bool fresh = false; ///< planar: start from the vertices of borders, markers and kept elements only
};

/// Replace the triangles of a mesh by ones of the target edge lengths.
///
/// Edges longer than 1.4 times the target length are split and those shorter than 0.7 times collapsed, edges
/// flipped to Delaunay's criterion, vertices smoothed [Botsch & Kobbelt 2004, A remeshing approach to
/// multiresolution modeling, SGP], then the worst triangles improved one by one. Planar: never an element of
/// area 0 or less (exact). Surfaces: vertices stay on the input, no single change turns a triangle by
/// more than 60 degrees. Features
/// (see find_features()) stay; vertices on them move along them only. The same bytes for any number of
/// threads.
///
/// Fresh: the start is the constrained Delaunay triangulation of the vertices of features, see
/// retriangulate(); of the input's inside only the sizes count.
///
/// @param mesh      planar with no inverted triangle, or a surface
/// @param sizes     n: target edge length at each vertex, between them linear; positive, but for vertices of no
///                  element, which are left out; limit_by_curves() lowers them
/// @param settings  what stays, and how long to work
/// @throws InputError  a size that is not positive or not finite (names the vertex); an inverted triangle
///                     that is
///                     not kept; sizes or kept of the wrong number; fresh: as retriangulate()
RemeshResult remesh(const Mesh& mesh, const Eigen::VectorXd& sizes, const RemeshSettings& settings = {});

} // namespace morph
