#pragma once

#include <string>
#include <string_view>

namespace morph {

/// A name as it stands on a line of text: control characters, percent signs, blanks at its ends and
/// the characters @p also are %XX; percent_decoded() of vtk_legacy.h takes that back.
std::string line_name(std::string_view name, std::string_view also = "");

} // namespace morph
