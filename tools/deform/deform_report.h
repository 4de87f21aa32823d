#pragma once

#include "libmorph/quality/quality.h"
#include "libmorph/quality/safe_step.h"
#include "libmorph/untangle/untangle.h"
#include "tools/common/report.h"
#include "tools/deform/case_motion.h"
#include "tools/deform/remesh_guard.h"

#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// Seconds that each stage of morph-deform took.
struct StageSeconds {
    double read = 0;
    double weights = 0;
    double apply = 0;
    double guard = 0;
    double write = 0;
};

/// Everything morph-deform tells about a run.
struct DeformResult {
    std::string method;
    std::string diffusivity;
    std::string guard;
    std::string output;
    WeightsCheck weights;
    std::vector<BoundaryFit> fits; ///< one per boundary
    ControlOutcome control;
    std::vector<std::string> crossings;  ///< of moved boundaries, see boundary_crossings()
    std::optional<QualityReport> before; ///< without guard = "none"
    std::optional<QualityReport> after;
    int steps = 1;                           ///< the move took
    Index tangled = 0;                       ///< inverted elements before the repair
    std::optional<UntangleResult> untangled; ///< with guard = "untangle" or "remesh", when there was
                                             ///< something to repair
    std::optional<RemeshedPart> remeshed;    ///< with guard = "remesh", when there was something left to do
    std::optional<SafeStep> safe_step;       ///< planar meshes, moves linear in the control points
    StageSeconds seconds;
};

/// Whether the moved mesh can be used: no inverted element, no boundary across itself or another.
bool is_valid(const DeformResult& result);

/// How much of the move is safe and what stops it, for a person; the number is rounded down.
std::string safe_step_text(const SafeStep& safe);

/// Put the result into the report, as JSON and as a summary.
void describe(const DeformResult& result, const CaseMotion& motion, Report& report);

} // namespace morph::tools
