#pragma once

#include "libmorph/remap/integral.h"
#include "libmorph/remap/remap.h"
#include "tools/common/report.h"

#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// Smallest, largest value and integral of a field before and after.
struct FieldChange {
    std::string name;
    FieldLocation location = FieldLocation::vertex;
    FieldTotals source;
    FieldTotals target;
};

struct RemapSeconds {
    double read = 0;
    double locate = 0;
    double interpolate = 0;
    double write = 0;
};

/// What morph-remap reports of a run.
struct RemapResult {
    std::string source;
    std::string target;
    std::string output;
    std::string outside_rule;
    TargetCounts vertices;
    std::optional<TargetCounts> elements; ///< with element fields
    std::vector<FieldChange> fields;
    std::optional<Conservation> nodal_conservation;
    std::optional<Conservation> element_conservation;
    RemapSeconds seconds;
};

/// "183 of 4055 targets (4.5 %) lie outside the source, ..." when more than 1 % do; else empty.
std::string outside_warning(const TargetCounts& counts, const std::string& what);

/// The result as JSON and as a summary.
void describe(const RemapResult& result, Report& report);

} // namespace morph::tools
