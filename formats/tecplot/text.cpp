#include "formats/tecplot/text.h"

#include "formats/text/message_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace morph {

namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// One character of a string, which may be escaped; moves @p at behind it.
char next_character(std::string_view text, std::size_t& at)
{
    const char c = text[at++];
    if (c != '\\' || at == text.size())
        return c;
    const char escaped = text[at++];
    unsigned code = 0;
    const char* const digits = text.data() + at;
    if (escaped == 'x' && text.size() - at >= 2 &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
        at += 2;
        return static_cast<char>(code);
    }
    return escaped == 'n' ? '\n' : escaped;
}

std::string read_quoted(TextScanner& in, char quote)
{
    const std::string_view text = in.text();
    const std::size_t start = in.position();
    std::string value;
    std::size_t at = start + 1;
    while (at < text.size() && text[at] != quote && text[at] != '\n')
        value += next_character(text, at);
    if (at >= text.size() || text[at] != quote)
        in.fail_at(start, "the string has no closing quote");
    in.seek(at + 1);
    return value;
}

/// Brackets within brackets are part of the list: ([4]=CELLCENTERED).
std::string read_bracketed(TextScanner& in)
{
    const std::string_view text = in.text();
    const std::size_t start = in.position();
    int depth = 0;
    for (std::size_t at = start; at < text.size(); ++at) {
        depth += text[at] == '(' || text[at] == '[' ? 1 : 0;
        depth -= text[at] == ')' || text[at] == ']' ? 1 : 0;
        if (depth > 0)
            continue;
        in.seek(at + 1);
        return std::string(text.substr(start, at + 1 - start));
    }
    in.fail_at(start, "the list has no closing bracket");
}

} // namespace

std::string try_tecplot_word(TextScanner& in)
{
    const std::string_view rest = in.rest();
    std::size_t length = 0;
    while (length < rest.size() && is_word(rest[length]))
        ++length;
    if (length == 0 || std::isdigit(static_cast<unsigned char>(rest[0])) != 0)
        return {};
    std::string word(rest.substr(0, length));
    in.seek(in.position() + length);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return word;
}

bool try_tecplot_equals(TextScanner& in)
{
    if (!in.skip_white() || in.text()[in.position()] != '=')
        return false;
    in.seek(in.position() + 1);
    return true;
}

std::string read_tecplot_value(TextScanner& in, const std::string& what)
{
    if (!in.skip_white())
        in.fail_expected(what);
    const char first = in.text()[in.position()];
    if (first == '"' || first == '\'')
        return read_quoted(in, first);
    if (first == '(' || first == '[')
        return read_bracketed(in);
    const std::string_view rest = in.rest();
    const std::size_t length = std::min(rest.find_first_of(" \t\r\n,#"), rest.size());
    if (length == 0)
        in.fail_expected(what);
    in.seek(in.position() + length);
    return std::string(rest.substr(0, length));
}

std::pair<std::string, std::string> read_tecplot_auxiliary(TextScanner& in)
{
    in.skip_white();
    const std::string_view rest = in.rest();
    const std::size_t length = std::min(rest.find_first_of("= \t\r\n"), rest.size());
    const std::string name(rest.substr(0, length));
    in.seek(in.position() + length);
    if (!try_tecplot_equals(in))
        in.fail_expected("'=' after the name " + name + " of auxiliary data");
    return {name, read_tecplot_value(in, "the value of " + name)};
}

std::string tecplot_quoted(std::string_view name)
{
    std::string text = "\"";
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (text += '\\') += c;
        else if (c == '\n')
            text += "\\n";
        else if (code < 32 || code == 127)
            (((text += "\\x") += kDigits[code >> 4])) += kDigits[code & 15U];
        else
            text += c;
    }
    return text + '"';
}

std::vector<Index> tecplot_numbers(const TextScanner& in, std::size_t position, std::string_view list,
                                   Index most, const std::string& what)
{
    std::vector<Index> numbers;
    const char* at = list.data();
    const char* const end = at + list.size();
    const auto fail = [&]() {
        in.fail_at(position, what + " must be numbers from 1 to " + std::to_string(most) + ", found " +
                                 quoted_text(list));
    };
    while (true) {
        at = std::find_if(at, end, [](char c) {
            return std::string_view(" \t\r\n,[]()").find(c) == std::string_view::npos;
        });
        if (at == end)
            return numbers;
        Index first = 0;
        std::from_chars_result read = std::from_chars(at, end, first);
        Index last = first;
        if (read.ec == std::errc() && read.ptr != end && *read.ptr == '-')
            read = std::from_chars(read.ptr + 1, end, last);
        if (read.ec != std::errc() || first < 1 || last > most)
            fail();
        for (Index number = first; number <= last; ++number)
            numbers.push_back(number);
        at = read.ptr;
    }
}

} // namespace morph
