#pragma once

#include "libmorph/pipeline/detail/prepared_motion.h"

#include <optional>

namespace morph {

/// Change displacements as little as the constraints allow. Pulled points stay where they were pulled to, and
/// control points that two boundaries share at an end stay together.
///
/// @param settings       with constraints
/// @param pull           what the pulls reached, if there are any
/// @param displacements  K x 2 or K x 3, changed in place
/// @throws InputError, SolverError  names the constraint: a marker or control point that does not exist, or as
///                                  satisfy_constraints()
ConstrainedMove constrain(const Mesh& mesh, const MotionSettings& settings,
                          const std::optional<PullOutcome>& pull, const PreparedMotion& motion,
                          Matrix& displacements);

} // namespace morph
