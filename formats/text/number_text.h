#pragma once

#include "formats/output_file.h"

#include <charconv>
#include <concepts>
#include <string>

namespace morph {

/// No number's text is longer (a double takes at most 24 bytes), its separator included.
inline constexpr std::size_t kLongestNumber = 32;

/// The shortest text that reads back as the same bits, whatever the locale.
/// @param to  room for kLongestNumber bytes
/// @return behind the last byte written
inline char* number_text(char* to, double value)
{
    return std::to_chars(to, to + kLongestNumber, value).ptr;
}

inline char* number_text(char* to, std::integral auto value)
{
    return std::to_chars(to, to + kLongestNumber, value).ptr;
}

/// The number and what separates it from the next: the piece lines are made of.
inline char* number_text(char* to, auto value, char separator)
{
    char* const end = number_text(to, value);
    *end = separator;
    return end + 1;
}

/// The number alone, for messages.
inline std::string exact_text(auto value)
{
    std::string text(kLongestNumber, '\0');
    text.resize(static_cast<std::size_t>(number_text(text.data(), value) - text.data()));
    return text;
}

inline void append_number(OutputFile& out, auto value)
{
    out.advance_to(number_text(out.room(kLongestNumber), value));
}

} // namespace morph
