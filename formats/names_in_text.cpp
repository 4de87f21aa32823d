#include "formats/names_in_text.h"

namespace morph {

std::string line_name(std::string_view name, std::string_view also)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto code = static_cast<unsigned char>(name[i]);
        const bool outer_blank = name[i] == ' ' && (i == 0 || i + 1 == name.size());
        if (code >= ' ' && code != 127 && name[i] != '%' && !outer_blank &&
            also.find(name[i]) == std::string_view::npos)
            text += name[i];
        else
            ((text += '%') += digits[code >> 4]) += digits[code & 15U];
    }
    return text;
}

} // namespace morph
