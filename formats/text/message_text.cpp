#include "formats/text/message_text.h"

namespace morph {

std::string quoted_text(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::string quoted = "'";
    for (const char c : text.substr(0, longest))
        quoted += c >= ' ' && c <= '~' ? c : '?';
    return quoted + (text.size() > longest ? "...'" : "'");
}

} // namespace morph
