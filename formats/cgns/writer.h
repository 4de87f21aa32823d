#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>

namespace morph {

/// Write a mesh as a CGNS file of HDF5 with libcgns: a base with one unstructured zone, in it the elements as
/// they are listed, a section of BAR_2 and a boundary condition with its family for each marker, a subregion
/// for each group, fields as solutions at vertices and cells. To be
/// called in a process of its own.
/// @throws SolverError  libcgns cannot write it
void write_cgns(const MeshData& mesh, const std::string& path);

} // namespace morph
