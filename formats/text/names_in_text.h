#pragma once

#include <string>
#include <string_view>

namespace morph {

/// A name as it stands on a line of text: control characters, percent signs, blanks at its ends and
/// the characters @p also are %XX; percent_decoded() takes that back.
std::string line_name(std::string_view name, std::string_view also = "");

/// A name or string as legacy VTK files hold it: what is not printable, blanks, quotes and percent signs as
/// %XX.
std::string percent_encoded(std::string_view name);

/// The inverse of percent_encoded() and line_name().
std::string percent_decoded(std::string_view text);

} // namespace morph
