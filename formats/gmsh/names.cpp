#include "formats/gmsh/names.h"

#include "formats/text/names_in_text.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kLongestName = 127; ///< by the specification

bool is_quotable(char c)
{
    const auto code = static_cast<unsigned char>(c);
    return code >= ' ' && code != '"' && code != 0x7f;
}

} // namespace

void GmshNames::read(TextScanner& text, std::size_t end)
{
    text.skip_white();
    if (text.rest_of_line() != kGmshNamesTitle)
        return;
    for (text.skip_line(); text.skip_white() && text.position() < end; text.skip_line()) {
        const std::string_view kind = text.word("a line of names");
        Index first = 0;
        Index second = 0;
        if (!text.try_index(first) || !text.try_index(second))
            continue;
        const std::string name = percent_decoded(text.rest_of_line());
        if (kind == "physical")
            physicals_.try_emplace({first, second}, name);
        else if (kind == "field")
            fields_.try_emplace(first, FieldNote{second, name});
    }
}

const std::string* GmshNames::physical(int dimension, std::int64_t tag) const
{
    const auto found = physicals_.find({dimension, tag});
    return found == physicals_.end() ? nullptr : &found->second;
}

const GmshNames::FieldNote* GmshNames::field(Index number) const
{
    const auto found = fields_.find(number);
    return found == fields_.end() ? nullptr : &found->second;
}

bool fits_gmsh_quotes(std::string_view name)
{
    return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), is_quotable);
}

std::string gmsh_quotable(std::string_view name)
{
    std::string text(name.substr(0, kLongestName));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return !is_quotable(c); }, '_');
    return text.empty() ? "unnamed" : text;
}

} // namespace morph
