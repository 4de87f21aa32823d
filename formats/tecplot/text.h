#pragma once

#include "formats/text/text_scanner.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace morph {

/// What the header of a Tecplot file is made of. Commas separate as blanks do.

/// Skip blanks, line ends, comments and commas; false when nothing is left in the text.
bool skip_tecplot_white(TextScanner& in);

/// Letters, digits and underscores that come next, in upper case. Empty, and nothing is read, when something
/// else comes next, a number among it.
std::string try_tecplot_word(TextScanner& in);

/// The '=' that comes next, or false.
bool try_tecplot_equals(TextScanner& in);

/// A string in quotes, without them, its escapes resolved; a list in brackets, with them; or all up to the
/// next blank or comma.
/// @param what  for the message
/// @throws InputError  there is none, or its closing quote or bracket is missing
std::string read_tecplot_value(TextScanner& in, const std::string& what);

/// "NAME = value", of auxiliary data: the name and the value.
/// @throws InputError  there is no '=' on the line, or no value
std::pair<std::string, std::string> read_tecplot_auxiliary(TextScanner& in);

/// The name in quotes, as read_tecplot_value() resolves it: `\"`, `\\` and `\n` as Tecplot has them, and
/// `\xHH` for other control characters.
std::string tecplot_quoted(std::string_view name);

/// Numbers of a list such as "[1-3,5]" or "1-10 12", from 1 to @p most.
/// @param position  of the list in the file, for the message
/// @throws InputError  it is none, or a number is out of range
std::vector<Index> tecplot_numbers(const TextScanner& in, std::size_t position, std::string_view list,
                                   Index most, const std::string& what);

inline bool skip_tecplot_white(TextScanner& in)
{
    while (in.skip_white()) {
        if (in.text()[in.position()] != ',')
            return true;
        in.seek(in.position() + 1);
    }
    return false;
}

} // namespace morph
