#pragma once

#include "libmorph/mesh/mesh.h"
#include "tools/common/report.h"

#include <string>

namespace morph::tools {

/// Say and report what became of a mesh: counts, quality before and after, how well sizes were met, how far
/// it is from the old one, and what is folded over.
/// @param sizes   edge lengths wanted at the vertices of @p mesh
/// @param output  name of its file
void describe_remeshing(const Mesh& old, const Mesh& mesh, const Eigen::VectorXd& sizes,
                        const std::string& output, Report& report);

} // namespace morph::tools
