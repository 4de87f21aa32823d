#include "formats/abaqus/lines.h"

#include <algorithm>
#include <cctype>

namespace morph {

namespace {

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::string_view unquoted(std::string_view text)
{
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

/// Takes the text up to the next comma outside quotes off the front.
std::string_view take_part(std::string_view& text)
{
    bool quoted = false;
    std::size_t end = 0;
    for (; end < text.size() && (quoted || text[end] != ','); ++end)
        quoted = quoted != (text[end] == '"');
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return trimmed(part);
}

std::string single_blanks(std::string_view text)
{
    std::string result;
    for (const char c : text)
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            result += c;
        else if (!result.empty() && result.back() != ' ')
            result += ' ';
    return result;
}

} // namespace

std::string upper_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string without_instance(const std::string& field)
{
    return field.substr(field.rfind('.') + 1);
}

std::optional<std::string> AbaqusKeyword::value(const std::string& parameter) const
{
    for (const auto& [known, text] : parameters)
        if (known == parameter)
            return text;
    return std::nullopt;
}

bool AbaqusLines::skip_comment()
{
    if (!in_.rest().starts_with("**"))
        return false;
    comments_.emplace_back(trimmed(in_.rest_of_line().substr(2)));
    in_.skip_line();
    return true;
}

bool AbaqusLines::next_keyword(AbaqusKeyword& keyword)
{
    while (in_.skip_white() && (skip_comment() || in_.text()[in_.position()] != '*'))
        if (in_.position() < in_.text().size() && in_.text()[in_.position()] != '*')
            in_.skip_line();
    if (!in_.skip_white())
        return false;
    keyword = {};
    keyword.position = in_.position();
    std::string line(in_.rest_of_line().substr(1));
    in_.skip_line();
    while (line.ends_with(',') && in_.skip_white()) {
        if (skip_comment())
            continue;
        line += in_.rest_of_line();
        in_.skip_line();
    }
    std::string_view rest = line;
    keyword.name = upper_case(single_blanks(take_part(rest)));
    if (keyword.name.empty())
        in_.fail_at(keyword.position, "expected a keyword behind '*'");
    while (!rest.empty()) {
        const std::string_view part = take_part(rest);
        const std::size_t equals = std::min(part.find('='), part.size());
        const std::string_view name = trimmed(part.substr(0, equals));
        const std::string_view value = part.substr(std::min(equals + 1, part.size()));
        if (!name.empty())
            keyword.parameters.emplace_back(upper_case(std::string(name)), unquoted(trimmed(value)));
    }
    return true;
}

bool AbaqusLines::next_data_line()
{
    while (in_.skip_white())
        if (!skip_comment())
            return in_.text()[in_.position()] != '*';
    return false;
}

/// A line that ends with a comma goes on in the next one.
void AbaqusLines::begin_field(std::string_view what)
{
    if (!in_.at_line_end())
        return;
    const std::size_t end = in_.position();
    const std::size_t last = in_.text().substr(0, end).find_last_not_of(" \t\r");
    const bool goes_on = last != std::string_view::npos && in_.text()[last] == ',' && next_data_line();
    if (!goes_on) {
        in_.seek(end);
        in_.fail_expected(what);
    }
}

void AbaqusLines::end_field()
{
    if (!in_.at_line_end() && in_.text()[in_.position()] == ',')
        in_.seek(in_.position() + 1);
    else if (!in_.at_line_end())
        in_.fail_expected("a comma");
}

Index AbaqusLines::index(std::string_view what)
{
    begin_field(what);
    const Index value = in_.index(what);
    end_field();
    return value;
}

double AbaqusLines::real(std::string_view what)
{
    begin_field(what);
    const double value = in_.real(what);
    end_field();
    return value;
}

bool AbaqusLines::try_field(std::string& field)
{
    if (in_.at_line_end())
        return false;
    std::string_view line = in_.rest().substr(0, in_.rest().find('\n'));
    const std::size_t length = line.size();
    field = unquoted(take_part(line));
    in_.seek(in_.position() + length - line.size());
    return true;
}

bool AbaqusLines::at_line_end()
{
    return in_.at_line_end();
}

void AbaqusLines::end_line(std::string_view what)
{
    in_.end_line(what);
    in_.skip_line();
}

} // namespace morph
