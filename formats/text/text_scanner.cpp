#include "formats/text/text_scanner.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace morph {

namespace {

constexpr std::size_t kLongestQuote = 40;

bool is_whole(const char* after, const char* end)
{
    return after == end || kEndsNumber[static_cast<unsigned char>(*after)];
}

/// The token in single quotes on one line of plain characters, whatever bytes are in it.
std::string quoted(std::string_view token)
{
    std::string text = "'";
    for (const char c : token.substr(0, kLongestQuote))
        text += c >= ' ' && c <= '~' ? c : '?';
    return text + (token.size() > kLongestQuote ? "...'" : "'");
}

/// "nan", "inf", "-Infinity" and the like, which the scanner refuses.
bool try_not_finite(TextScanner& scanner, double& value)
{
    const std::string_view rest = scanner.rest();
    const auto [after, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const auto length = static_cast<std::size_t>(after - rest.data());
    const bool whole = length == rest.size() || kEndsNumber[static_cast<unsigned char>(rest[length])];
    if (error != std::errc() || std::isfinite(value) || !whole)
        return false;
    scanner.seek(scanner.position() + length);
    return true;
}

} // namespace

void TextScanner::skip_line()
{
    const void* newline =
        here_ == end_ ? nullptr : std::memchr(here_, '\n', static_cast<std::size_t>(end_ - here_));
    here_ = newline ? static_cast<const char*>(newline) + 1 : end_;
}

bool TextScanner::try_integer(std::int64_t& value)
{
    skip_blanks();
    const char* const first = here_ != end_ && *here_ == '+' ? here_ + 1 : here_;
    const bool two_signs = first != here_ && first != end_ && *first == '-';
    std::int64_t number = 0;
    const auto [after, error] = std::from_chars(first, end_, number);
    if (error != std::errc{} || two_signs || !is_whole(after, end_))
        return false;
    here_ = after;
    value = number;
    return true;
}

bool TextScanner::try_real(double& value)
{
    skip_blanks();
    double number = 0;
    const auto [after, error] = std::from_chars(here_, end_, number);
    if (error != std::errc{} || !is_whole(after, end_))
        return try_unusual_real(value);
    if (!std::isfinite(number))
        return false;
    here_ = after;
    value = number;
    return true;
}

/// A leading plus, an exponent D and underflow, which std::from_chars refuses.
bool TextScanner::try_unusual_real(double& value)
{
    const char* p = here_ != end_ && *here_ == '+' ? here_ + 1 : here_;
    const char* last = p;
    while (last != end_ && !is_whole(last, end_))
        ++last;
    if (p == last || (p != here_ && *p == '-'))
        return false;
    std::string text(p, last);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    const char* const text_end = text.data() + text.size();
    double number = 0;
    const auto [after, error] = std::from_chars(text.data(), text_end, number);
    const bool underflow =
        error == std::errc::result_out_of_range && text.find_first_of("eE") + 1 == text.find('-', 1);
    if ((error != std::errc{} && !underflow) || after != text_end || !std::isfinite(number))
        return false;
    here_ = last;
    value = underflow ? 0.0 : number;
    return true;
}

Index TextScanner::index(std::string_view what)
{
    Index value = 0;
    if (!try_index(value))
        fail_expected(what);
    return value;
}

std::int64_t TextScanner::integer(std::string_view what)
{
    std::int64_t value = 0;
    if (!try_integer(value))
        fail_expected(what);
    return value;
}

double TextScanner::real(std::string_view what)
{
    double value = 0;
    if (!try_real(value))
        fail_expected(what);
    return value;
}

std::string_view TextScanner::token() const
{
    const char* last = here_;
    while (last != end_ && *last != '\n' && !is_blank(*last) && !is_comment(*last))
        ++last;
    return {here_, static_cast<std::size_t>(last - here_)};
}

std::string_view TextScanner::word(std::string_view what)
{
    if (at_line_end())
        fail_expected(what);
    const std::string_view found = token();
    here_ += found.size();
    return found;
}

std::string_view TextScanner::rest_of_line()
{
    skip_blanks();
    const char* last = here_;
    while (last != end_ && *last != '\n' && !is_comment(*last))
        ++last;
    std::string_view line(here_, static_cast<std::size_t>(last - here_));
    here_ = last;
    while (!line.empty() && is_blank(line.back()))
        line.remove_suffix(1);
    return line;
}

void TextScanner::end_line(std::string_view what)
{
    if (!at_line_end())
        fail("expected the end of the line after " + std::string(what) + ", found " + found());
}

std::size_t TextScanner::line_of(std::size_t position) const
{
    const std::string_view before = text_.substr(0, position);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::string TextScanner::found() const
{
    if (here_ == end_)
        return "the end of the file";
    const std::string_view next = token();
    return next.empty() ? "the end of the line" : quoted(next);
}

void TextScanner::fail_at(std::size_t position, const std::string& message) const
{
    throw InputError(path_ + ":" + std::to_string(line_of(position)) + ": " + message);
}

void TextScanner::fail_expected(std::string_view what) const
{
    fail("expected " + std::string(what) + ", found " + found());
}

bool read_numbers(TextScanner& scanner, std::size_t limit, std::vector<double>& numbers)
{
    while (numbers.size() < limit && scanner.skip_white()) {
        double value = 0;
        if (!scanner.try_real(value) && !try_not_finite(scanner, value))
            return false;
        numbers.push_back(value);
    }
    return true;
}

} // namespace morph
