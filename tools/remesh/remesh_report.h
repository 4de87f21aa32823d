#pragma once

#include "libmorph/mesh/mesh.h"
#include "tools/common/report.h"

#include <string>

namespace morph::tools {

/// What was wished for a mesh, at its n vertices.
struct RemeshWishes {
    Eigen::VectorXd sizes;    ///< target edge lengths
    Eigen::VectorXd possible; ///< what curved boundaries and kept elements leave of them
    Index vertices = 0;       ///< target number; 0: any
};

/// Say and report what became of a mesh: counts, quality before and after, how well wishes were met, how far
/// it is from the old one, and what is folded over.
/// @param output  name of the file of @p mesh
void describe_remeshing(const Mesh& old, const Mesh& mesh, const RemeshWishes& wishes,
                        const std::string& output, Report& report);

} // namespace morph::tools
