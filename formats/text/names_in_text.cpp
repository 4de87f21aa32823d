#include "formats/text/names_in_text.h"

#include <charconv>

namespace morph {

namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

} // namespace

std::string line_name(std::string_view name, std::string_view also)
{
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto code = static_cast<unsigned char>(name[i]);
        const bool outer_blank = name[i] == ' ' && (i == 0 || i + 1 == name.size());
        if (code >= ' ' && code != 127 && name[i] != '%' && !outer_blank &&
            also.find(name[i]) == std::string_view::npos)
            text += name[i];
        else
            ((text += '%') += kDigits[code >> 4]) += kDigits[code & 15U];
    }
    return text;
}

std::string percent_encoded(std::string_view name)
{
    std::string text;
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (code > 32 && code < 127 && c != '"' && c != '%')
            text += c;
        else
            (((text += '%') += kDigits[code >> 4])) += kDigits[code & 15U];
    }
    return text;
}

std::string percent_decoded(std::string_view text)
{
    std::string name;
    while (!text.empty()) {
        unsigned code = 0;
        const bool percent = text[0] == '%' && text.size() >= 3;
        const auto [stop, error] = percent ? std::from_chars(text.data() + 1, text.data() + 3, code, 16)
                                           : std::from_chars_result{text.data(), std::errc::invalid_argument};
        const bool escape = error == std::errc() && stop == text.data() + 3;
        name += escape ? static_cast<char>(code) : text[0];
        text.remove_prefix(escape ? 3 : 1);
    }
    return name;
}

} // namespace morph
