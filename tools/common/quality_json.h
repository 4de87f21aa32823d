#pragma once

#include "libmorph/quality/quality.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace morph::tools {

/// The block that morph-quality writes at the top and morph-deform as quality.before and quality.after.
nlohmann::ordered_json quality_json(const QualityReport& report);

/// The same in three or four lines for a person.
std::vector<std::string> quality_summary(const QualityReport& report);

} // namespace morph::tools
