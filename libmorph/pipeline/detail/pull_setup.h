#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/weights_view.h"
#include "tools/case/case_file.h"

#include <string>
#include <vector>

namespace morph::tools {

/// What [[pull]] did.
struct PullOutcome {
    std::vector<Index> vertices; ///< pulled ones, as the file numbers them
    Matrix residual;             ///< m x 2 or m x 3: wanted minus reached displacement
    Index rank = 0;              ///< how many of them the control points can move independently
};

/// Change the displacements of a case so that its pulled points come where they are wanted, by the least
/// change.
///
/// @param weights        of the case's control points, n x K
/// @param held           control points that keep their displacement
/// @param displacements  K x 2 or K x 3, changed in place
/// @throws InputError  "case.toml:12: …": a vertex that the mesh does not have
PullOutcome pull(const Mesh& mesh, const CaseFile& file, WeightsView weights, const std::vector<Index>& held,
                 Matrix& displacements);

/// The vertices that numbers in the file, or the nearest places, name.
/// @param place  "case.toml:12: [[pull]]", for messages
std::vector<Index> named_vertices(const Mesh& mesh, const std::vector<Index>& file_numbers,
                                  const Matrix& points, const std::string& place);

} // namespace morph::tools
