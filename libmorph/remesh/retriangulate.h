#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

struct RetriangulateSettings {
    bool inner_vertices = true; ///< false: only those of the outline and of markers are used
    bool transfer = true;       ///< groups and fields are transferred
    const Points* shape =
        nullptr; ///< n x 3: where old and new elements are compared; null: where the mesh is
};

/// A mesh some of whose elements were cut out and meshed again.
struct Retriangulated {
    MeshData data;             ///< numbers of the file stay where they are below the new counts
    std::vector<bool> made;    ///< per element of the data: it is new
    std::vector<Index> vertex; ///< per vertex of the data: its number in the old file
    Index cut_out = 0;         ///< elements of the old mesh that are gone
};

/// Cut elements out of a planar mesh and fill the hole with the constrained Delaunay triangulation of its
/// outline, of the edges of markers in it and of the old vertices strictly inside. No vertex is added; those
/// that lie outside or on the outline are left out.
///
/// Cut out are the elements not kept and all inverted ones. Where their outline crosses itself, because
/// neighbours are folded over, elements around the crossing are cut out too, until it does not. No element of
/// the result is inverted (exact signs). New elements take groups and element fields of the nearest old one,
/// by centres; nodal fields stay with their vertices.
///
/// @param kept  m: elements to keep
/// @throws InputError  the boundary of the mesh or a marker crosses itself or is inside out (names the
///                     place); the mesh is a surface in space; kept of the wrong number
Retriangulated retriangulate(const Mesh& mesh, const std::vector<bool>& kept,
                             const RetriangulateSettings& settings = {});

} // namespace morph
