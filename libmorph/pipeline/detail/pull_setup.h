#pragma once

#include "libmorph/pipeline/detail/prepared_motion.h"

#include <string>
#include <vector>

namespace morph {

/// Change displacements so that pulled points reach their displacements, by the least change.
///
/// @param displacements  K x 2 or K x 3, changed in place
/// @throws InputError  names the pull: a vertex that the mesh does not have
PullOutcome pull(const Mesh& mesh, const std::vector<PullSettings>& pulls, const PreparedMotion& motion,
                 Matrix& displacements);

/// The vertices that file numbers name, then those nearest to points.
/// @param points  m x 3
/// @param what    in front of messages: "case.toml:12: [[pull]]"
/// @throws InputError  a vertex that the mesh does not have
std::vector<Index> named_vertices(const Mesh& mesh, const std::vector<Index>& file_numbers,
                                  const Matrix& points, const std::string& what);

} // namespace morph
