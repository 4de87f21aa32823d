#pragma once

#include "libmorph/quality/full_quality.h"
#include "tools/common/report.h"

namespace morph::tools {

/// Put the quality of a mesh into the report, as JSON and as a summary with histograms and a table of the worst
/// elements.
void describe(const FullQuality& quality, Report& report);

} // namespace morph::tools
