#include "formats/nastran/names.h"

#include "formats/text/names_in_text.h"

#include <charconv>

namespace morph {

namespace {

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Takes a number off the front of @p text; -1: there is none.
Index take_number(std::string_view& text)
{
    text = trimmed(text);
    Index number = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 0)
        return -1;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// Takes the text up to the next semicolon off the front.
std::string_view take_part(std::string_view& text)
{
    const std::string_view part = text.substr(0, text.find(';'));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return trimmed(part);
}

bool take_prefix(std::string_view& text, std::string_view prefix)
{
    if (!text.starts_with(prefix))
        return false;
    text.remove_prefix(prefix.size());
    return true;
}

} // namespace

void NastranNames::take(std::string_view comment)
{
    comment = trimmed(comment.substr(1)); // the '$'
    if (named_next_ >= 0) {
        properties_[named_next_] = comment;
        named_next_ = -1;
        return;
    }
    if (take_own(comment) || take_ansa(comment))
        return;
    take_hypermesh(comment);
    take_femap(comment);
}

bool NastranNames::take_own(std::string_view comment)
{
    const bool group = take_prefix(comment, "group ");
    if (group || take_prefix(comment, "marker ")) {
        if (const Index property = take_number(comment); property >= 0)
            (group ? groups_ : markers_)[property] = percent_decoded(trimmed(comment));
        return true;
    }
    if (!take_prefix(comment, "ungrouped "))
        return false;
    ungrouped_ = take_number(comment);
    return true;
}

bool NastranNames::take_ansa(std::string_view comment)
{
    const bool on_this_line = take_prefix(comment, "ANSA_NAME_COMMENT;");
    if (!on_this_line && !take_prefix(comment, "ANSA_NAME;"))
        return false;
    std::string_view number = take_part(comment);
    const Index property = take_number(number);
    if (!take_part(comment).starts_with('P') || property < 0) // nodes, materials and sets have names too
        return true;
    if (on_this_line)
        properties_[property] = take_part(comment);
    else
        named_next_ = property;
    return true;
}

void NastranNames::take_hypermesh(std::string_view comment)
{
    if (!take_prefix(comment, "HMNAME "))
        return;
    const bool property = take_prefix(comment, "PROP");
    if (!property && !take_prefix(comment, "COMP"))
        return;
    const Index number = take_number(comment);
    const std::size_t open = comment.find('"');
    const std::size_t close = comment.find('"', open + 1);
    if (number >= 0 && open != std::string_view::npos && close != std::string_view::npos)
        (property ? properties_ : components_)[number] = comment.substr(open + 1, close - open - 1);
}

void NastranNames::take_femap(std::string_view comment)
{
    if (!take_prefix(comment, "Femap Property ") && !take_prefix(comment, "Femap with NX Nastran Property "))
        return;
    const Index number = take_number(comment);
    comment = trimmed(comment);
    if (number >= 0 && take_prefix(comment, ":"))
        properties_[number] = trimmed(comment);
}

std::optional<std::string> NastranNames::name(Index property) const
{
    for (const auto* names : {&properties_, &components_})
        if (const auto found = names->find(property); found != names->end() && !found->second.empty())
            return found->second;
    return std::nullopt;
}

} // namespace morph
