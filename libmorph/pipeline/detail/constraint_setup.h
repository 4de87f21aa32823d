#pragma once

#include "tools/deform/case_motion.h"

namespace morph::tools {

/// Change the displacements of a case as little as its [constraints] allow. Pulled points stay where they
/// were pulled to, and control points that two boundaries share at an end stay together.
///
/// @param pull    what [[pull]] reached, if there is any
/// @param motion  its displacements are changed in place
/// @throws InputError, SolverError  "case.toml:12: …": a marker or control point that does not exist, or as
///                                  satisfy_constraints()
ConstrainedMove constrain(const Mesh& mesh, const CaseFile& file, const std::optional<PullOutcome>& pull,
                          CaseMotion& motion);

} // namespace morph::tools
