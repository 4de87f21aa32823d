#pragma once

#include "libmorph/mesh/mesh_data.h"
#include "tools/case/case_file.h"

namespace morph::tools {

/// The mesh of a case with `generate`: the box without the insides of its curves, a marker for each
/// [[boundary]] in the order of the case and "farfield" for the box. See mesh_domain().
///
/// @throws InputError   "case.toml: what is wrong": no generate, a boundary without nodes, or what
///                      mesh_domain() refuses
/// @throws SolverError  as mesh_domain()
MeshData generate_mesh(const CaseFile& file);

} // namespace morph::tools
