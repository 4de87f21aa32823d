#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// The candidate nearest to @p name by edit distance, or empty when none is near enough to be meant.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" with the nearest candidate, or empty.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// The names separated by ", ".
std::string joined(const std::vector<std::string>& names);

/// A number for a message, with up to 9 digits.
std::string number_text(double value);

} // namespace morph
