#pragma once

#include <string>
#include <string_view>

namespace morph {

/// A name or token from a file for a message of one line: in single quotes, cut when long, bytes that are not
/// printable ASCII as '?'.
std::string quoted_text(std::string_view text);

} // namespace morph
