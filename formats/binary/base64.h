#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace morph {

/// At least the first @p wanted bytes that a base64 text stands for, fewer when it is shorter.
///
/// White space is passed over. Padding may occur anywhere and ends a group of four, so that a text
/// put together from several encoded pieces (VTK's compressed arrays) decodes to the pieces' bytes.
/// @return nothing when the text holds anything else
std::optional<std::string> decode_base64(std::string_view text, std::size_t wanted);

} // namespace morph
