#pragma once

#include "libmorph/pipeline/remesh_job.h"
#include "tools/common/report.h"

#include <string>

namespace morph::tools {

/// Say and report what became of a mesh: counts, quality before and after, how well the target sizes are met,
/// how far it is from the old one, and what is folded over.
/// @param output  name of the file of the new mesh
void describe_remeshing(const Mesh& old, const RemeshedMesh& remeshed, const RemeshCheck& check,
                        const std::string& output, Report& report);

} // namespace morph::tools
