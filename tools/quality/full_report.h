#pragma once

#include "libmorph/quality/element_place.h"
#include "libmorph/quality/quality.h"
#include "libmorph/quality/wall.h"
#include "tools/common/report.h"

#include <vector>

namespace morph::tools {

/// Everything morph-quality tells about a mesh.
struct FullQuality {
    QualityReport summary;
    std::vector<ElementPlace> worst_places; ///< of summary.worst
    std::vector<WallQuality> walls;
};

/// Look at all of a mesh where it is.
/// @param reference  positions before the move, or null
FullQuality full_quality(const Mesh& mesh, const PositionsView* reference);

/// Put it into the report, as JSON and as a summary with histograms and a table of the worst elements.
void describe(const FullQuality& quality, Report& report);

} // namespace morph::tools
