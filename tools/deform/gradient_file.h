#pragma once

#include "formats/output_file.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/weights.h"

#include <array>
#include <string>
#include <vector>

namespace morph::tools {

/// Read the derivative of an objective with respect to the vertices: columns id, dx, dy and, in space, dz;
/// ids as the mesh's file numbers them, in any order, missing ones zero.
///
/// @return n x dimension, in the numbering of the mesh; of the copies of a split vertex the first has it all
/// @throws InputError  "path:line: …": an id that is no vertex or there twice
Matrix read_vertex_gradient(const std::string& path, const Mesh& mesh);

/// Write the derivative with respect to the control points: boundary, i (from 1), dx, dy; of a lattice i, j
/// and, in space, k (from 0) instead.
///
/// @param gradient        K x dimension
/// @param lattice_points  control points along i, j, k; {0, 0, 0} for boundaries
void write_control_point_gradient(OutputFile& out, const std::vector<ControlPoint>& columns,
                                  const Matrix& gradient, const std::array<Index, 3>& lattice_points);

} // namespace morph::tools
