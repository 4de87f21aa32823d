#pragma once

#include "libmorph/mesh/mesh.h"

#include <optional>

namespace morph {

/// What was replaced of a moved mesh.
struct RemeshedPart {
    Index elements = 0;        ///< of the moved mesh that are gone
    Index vertices_before = 0; ///< of the whole mesh
    Index vertices_after = 0;
};

/// Remesh a moved planar mesh where elements are inverted or became flat: triangles of quality
/// (4 sqrt(3) area / sum of squared sides) below 0.2 and below half of what they had. Two rings around them
/// go with them, more where retriangulate() needs more. The new triangles get the edge lengths from before
/// the move; every vertex of the boundary and of markers stays where it is. Other vertices and elements keep
/// their numbers where these are below the new counts; markers, groups and fields are transferred.
///
/// @param mesh    moved; replaced by the remeshed one
/// @param before  n x 3 positions before the move
/// @return none where nothing had to be replaced, or a valid mesh would not have got better by it
/// @throws InputError  as retriangulate()
std::optional<RemeshedPart> remesh_bad_part(Mesh& mesh, const Points& before);

} // namespace morph
