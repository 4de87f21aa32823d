#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>

namespace morph::tools {

/// Give the mesh the fields of a file of their own (see read_fields()), in the place of its fields of the
/// same names.
/// @return whether the file is SU2's restart file as text
/// @throws InputError  as read_fields()
bool take_fields_from(const std::string& path, MeshData& mesh);

} // namespace morph::tools
