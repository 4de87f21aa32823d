#pragma once

#include "libmorph/mesh/mesh_data.h"

namespace morph::test {

/// A quad and two triangles in space; the vertices appear in the order of their numbers.
MeshData small_surface();

/// The mesh without markers, groups, fields and carried text.
MeshData bare(MeshData mesh);

/// The mesh with three groups: "first", the first half of the elements; "upper side, 50 %", every third
/// one, so that some are in both; "last", the last one. None when there are no elements.
MeshData with_groups(MeshData mesh);

} // namespace morph::test
