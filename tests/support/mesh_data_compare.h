#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>

namespace morph::test {

/// What differs between two meshes, bit for bit (also the sign of zero and the payload of NaN):
/// dimension, points, elements, markers, groups, fields, in order. Empty when nothing does.
std::string difference(const MeshData& a, const MeshData& b);

} // namespace morph::test
