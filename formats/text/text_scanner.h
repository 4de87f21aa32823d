#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// Reads numbers and words from the text of a file, front to back, at the speed of memory, and knows
/// the line for messages.
///
/// Numbers are read whole or refused: `12abc` and `1e-3x` are no numbers, `12,` is one before a comma.
/// A leading `+` and Fortran exponents (`1.0D-3`) are understood; the locale plays no role. NaN,
/// infinity and what overflows are refused; what underflows is 0.
///
/// The readers below skip blanks (space, tab, carriage return) but stay on the line. Where a format
/// lets lines run on, call skip_white() first. Lines are counted only when a message needs them.
class TextScanner {
public:
    /// @param path     for messages
    /// @param text     outlives the scanner
    /// @param comment  from this character on, the rest of a line is skipped as if not there; 0: none
    TextScanner(std::string path, std::string_view text, char comment = '\0')
        : path_(std::move(path)), text_(text), here_(text.data()), end_(text.data() + text.size()),
          comment_(comment == '\0' ? -1 : static_cast<unsigned char>(comment))
    {
    }

    /// Skip blanks; true when nothing else is left on this line.
    bool at_line_end();
    /// Skip blanks, comments and line ends; false when nothing is left in the text.
    bool skip_white();
    /// Go to the start of the next line, whatever is left on this one.
    void skip_line();

    /// Read a number from 0 to 2^31 - 1. False, and nothing is read, when there is none.
    bool try_index(Index& value);
    bool try_integer(std::int64_t& value);
    bool try_real(double& value);

    /// As the above.
    /// @throws InputError  "path:line: expected WHAT, found 'TOKEN'"
    Index index(std::string_view what);
    std::int64_t integer(std::string_view what);
    double real(std::string_view what);
    /// What stands before the next blank, comment or line end; not empty.
    std::string_view word(std::string_view what);
    /// The rest of this line without comment and blanks at its ends; may be empty.
    std::string_view rest_of_line();
    /// @throws InputError  something else is left on this line after @p what
    void end_line(std::string_view what);

    /// Bytes from the start of the text to what is read next; also after seek().
    std::size_t position() const { return static_cast<std::size_t>(here_ - text_.data()); }
    void seek(std::size_t position) { here_ = text_.data() + position; }
    /// All that has not been read.
    std::string_view rest() const { return text_.substr(position()); }
    std::string_view text() const { return text_; }
    const std::string& path() const { return path_; }

    /// Line of a position, from 1.
    std::size_t line_of(std::size_t position) const;
    /// What is read next, quoted for a message and cut when long: "'1e-3x'", "the end of the line".
    std::string found() const;
    /// @throws InputError  "path:line: message", with the line of the position
    [[noreturn]] void fail(const std::string& message) const { fail_at(position(), message); }
    [[noreturn]] void fail_at(std::size_t position, const std::string& message) const;
    [[noreturn]] void fail_expected(std::string_view what) const;

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
    bool is_comment(char c) const { return static_cast<unsigned char>(c) == comment_; }
    void skip_blanks();
    std::string_view token() const;
    bool try_unusual_real(double& value);

    std::string path_;
    std::string_view text_;
    const char* here_;
    const char* end_;
    int comment_; ///< -1: none
};

/// Append the real numbers that come next in a text to @p numbers until there are @p limit; "nan" and
/// "inf" count as numbers here.
/// @return false when something else comes first, which the scanner then stands at
bool read_numbers(TextScanner& scanner, std::size_t limit, std::vector<double>& numbers);

/// True for what may stand right after a number: white space, quotes, brackets and separators.
/// Letters, digits, `_ . + -`, control characters and bytes beyond ASCII may not.
inline constexpr std::array<bool, 256> kEndsNumber = [] {
    std::array<bool, 256> ends{};
    for (const char c : std::string_view(" \t\r\n\f\v,;:%#<>()[]{}/\\'\"!|=&*"))
        ends[static_cast<unsigned char>(c)] = true;
    return ends;
}();

inline void TextScanner::skip_blanks()
{
    while (here_ != end_ && is_blank(*here_))
        ++here_;
}

inline bool TextScanner::at_line_end()
{
    skip_blanks();
    return here_ == end_ || *here_ == '\n' || is_comment(*here_);
}

inline bool TextScanner::skip_white()
{
    while (at_line_end()) {
        if (here_ == end_)
            return false;
        skip_line();
    }
    return true;
}

inline bool TextScanner::try_index(Index& value)
{
    constexpr std::ptrdiff_t most_digits = 18; // cannot overflow 64 bits
    skip_blanks();
    const char* const first = here_ != end_ && *here_ == '+' ? here_ + 1 : here_;
    const char* p = first;
    std::uint64_t number = 0;
    while (p != end_ && static_cast<unsigned char>(*p - '0') < 10)
        number = number * 10 + static_cast<unsigned char>(*p++ - '0');
    const bool whole = p == end_ || kEndsNumber[static_cast<unsigned char>(*p)];
    if (p == first || p - first > most_digits || number > INT32_MAX || !whole)
        return false;
    here_ = p;
    value = static_cast<Index>(number);
    return true;
}

} // namespace morph
