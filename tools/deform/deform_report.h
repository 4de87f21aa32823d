#pragma once

#include "libmorph/pipeline/deformer.h"
#include "tools/common/report.h"

#include <string>
#include <vector>

namespace morph::tools {

/// What morph-deform did.
struct DeformRun {
    std::string output;
    MoveResult moved; ///< with --gradient nothing moves, and it is empty
    double read_seconds = 0;
    double weights_seconds = 0;
    double write_seconds = 0;
};

/// Put a run into the report, as JSON and as a summary.
void describe(const DeformRun& run, const Deformer& deformer, Report& report);

/// What a user of the moved mesh should know of its repair, a sentence each.
std::vector<std::string> repairs(const DeformRun& run);

/// What is wrong with the moved mesh and what may help, a sentence each.
std::vector<std::string> defects(const DeformRun& run, Guard guard);

} // namespace morph::tools
