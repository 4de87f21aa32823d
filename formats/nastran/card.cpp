#include "formats/nastran/card.h"

#include "formats/text/message_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace morph {

namespace {

constexpr std::size_t kSmall = 8; // columns of a field
constexpr std::size_t kLarge = 16;
constexpr std::size_t kColumns = 72; // behind them stands the mark of the continuation

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\r'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

bool is_whole_number(std::string_view text, Index& value)
{
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() && !digits.starts_with('-');
}

/// With the 'e' that Nastran lets one leave out before the sign of the exponent.
std::string with_exponent(std::string_view text)
{
    std::string usual;
    for (const char c : text) {
        const bool sign = c == '-' || c == '+';
        if (sign && !usual.empty() && usual.back() != 'e')
            usual += 'e';
        const bool letter = c == 'd' || c == 'D' || c == 'E';
        if (!(c == '+' && usual.empty()))
            usual += letter ? 'e' : c;
    }
    return usual;
}

bool is_real_number(std::string_view text, double& value)
{
    std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size())
        return std::isfinite(value);
    const std::string usual = with_exponent(text);
    const char* const end = usual.data() + usual.size();
    read = std::from_chars(usual.data(), end, value);
    const bool underflow = read.ec == std::errc::result_out_of_range && usual.find("e-") != std::string::npos;
    if (underflow)
        value = 0;
    return (read.ec == std::errc() || underflow) && read.ptr == end && std::isfinite(value);
}

} // namespace

bool NastranCards::skip_to_bulk()
{
    for (; in_.skip_white(); in_.skip_line()) {
        const std::string_view first = in_.rest().substr(0, 5);
        if (!std::equal(first.begin(), first.end(), "BEGIN",
                        [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; }))
            continue;
        in_.skip_line();
        return true;
    }
    in_.seek(0);
    return false;
}

bool NastranCards::next(NastranCard& card)
{
    card.fields.clear();
    card.name.clear();
    expanded_.clear();
    comment_ = {};
    std::string_view text;
    do {
        if (in_.position() == in_.text().size())
            return false;
        card.position = in_.position();
        text = line();
    } while (trimmed(text).empty() && comment_.empty());
    if (trimmed(text).empty())
        return true;
    if (continues(text))
        in_.fail_at(card.position, "a continuation line without a card before it");
    take_name(card, text);
    take_fields(card, text);
    while (in_.position() < in_.text().size()) {
        const std::size_t start = in_.position();
        const std::string_view comment = comment_;
        const std::string_view more = line();
        comment_ = comment;
        if (!continues(more)) {
            in_.seek(start);
            break;
        }
        take_fields(card, more);
    }
    return true;
}

/// The next line without its comment, which is kept, and without tabs.
std::string_view NastranCards::line()
{
    const std::size_t start = in_.position();
    in_.skip_line();
    std::string_view text = in_.text().substr(start, in_.position() - start);
    while (text.ends_with('\n') || text.ends_with('\r'))
        text.remove_suffix(1);
    const std::size_t dollar = text.find('$');
    comment_ = dollar == std::string_view::npos ? std::string_view() : text.substr(dollar);
    text = text.substr(0, dollar);
    return text.find('\t') == std::string_view::npos ? text : expanded(text);
}

/// A tab goes on to the next field.
std::string_view NastranCards::expanded(std::string_view line)
{
    std::string& text = expanded_.emplace_back();
    const bool free = line.find(',') != std::string_view::npos;
    for (const char c : line)
        if (c == '\t')
            text.append(free ? 1 : kSmall - text.size() % kSmall, ' ');
        else
            text += c;
    return text;
}

bool NastranCards::continues(std::string_view line) const
{
    if (trimmed(line).empty())
        return false;
    const std::string_view first = trimmed(line.substr(0, std::min(line.find(','), kSmall)));
    return first.empty() || first[0] == '+' || first[0] == '*';
}

void NastranCards::take_name(NastranCard& card, std::string_view line) const
{
    const std::string_view first = trimmed(line.substr(0, std::min(line.find(','), kSmall)));
    for (const char c : first.substr(0, first.find_first_of("* ")))
        card.name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

/// Adds 8 fields, or 4 of a large-field line, so that those of the next line have their places.
void NastranCards::take_fields(NastranCard& card, std::string_view line) const
{
    if (line.find(',') != std::string_view::npos)
        return take_free_fields(card, line);
    const bool large = line.substr(0, kSmall).find('*') != std::string_view::npos;
    const std::size_t width = large ? kLarge : kSmall;
    for (std::size_t column = kSmall; column < kColumns; column += width)
        card.fields.push_back(column < line.size() ? trimmed(line.substr(column, width))
                                                   : std::string_view());
}

void NastranCards::take_free_fields(NastranCard& card, std::string_view line) const
{
    const bool large = line.substr(0, line.find(',')).find('*') != std::string_view::npos;
    const std::size_t count = large ? (kColumns - kSmall) / kLarge : (kColumns - kSmall) / kSmall;
    const std::size_t before = card.fields.size();
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;) {
        const std::size_t next = line.find(',', comma + 1);
        card.fields.push_back(trimmed(line.substr(comma + 1, next - comma - 1)));
        comma = next;
    }
    card.fields.resize(before + count);
}

Index NastranCards::index(const NastranCard& card, std::size_t field, std::string_view what) const
{
    Index value = 0;
    if (!is_whole_number(card.field(field), value))
        fail(card, field, what);
    return value;
}

Index NastranCards::index(const NastranCard& card, std::size_t field, std::string_view what,
                          Index otherwise) const
{
    return card.field(field).empty() ? otherwise : index(card, field, what);
}

double NastranCards::real(const NastranCard& card, std::size_t field, std::string_view what) const
{
    double value = 0;
    if (!card.field(field).empty() && !is_real_number(card.field(field), value))
        fail(card, field, what);
    return value;
}

void NastranCards::fail(const NastranCard& card, std::size_t field, std::string_view what) const
{
    in_.fail_at(card.position, "expected " + std::string(what) + " in field " + std::to_string(field + 2) +
                                   " of " + quoted_text(card.name) + ", found " +
                                   (card.field(field).empty() ? "nothing" : quoted_text(card.field(field))));
}

} // namespace morph
