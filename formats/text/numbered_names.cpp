#include "formats/text/numbered_names.h"

#include "formats/text/names_in_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <unordered_map>

namespace morph {

namespace {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

/// The whole number that a text is, or nothing.
std::optional<std::int64_t> number_in(std::string_view text)
{
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// Cut the last word off a text.
std::string_view take_last_word(std::string_view& text)
{
    const std::size_t blank = text.find_last_of(" \t");
    const std::string_view word = blank == std::string_view::npos ? text : text.substr(blank + 1);
    text = trimmed(text.substr(0, text.size() - word.size()));
    return word;
}

/// A comment without its '#', if it is a line of a table.
std::optional<NumberedName> table_line(std::string_view comment)
{
    const std::size_t equals = comment.find('=');
    if (equals == std::string_view::npos)
        return std::nullopt;
    std::string_view left = trimmed(comment.substr(0, equals));
    const auto last = number_in(take_last_word(left));
    auto first = last;
    std::string_view before = left;
    if (take_last_word(before) == "to") {
        first = number_in(take_last_word(before));
        left = before;
    }
    if (!first || !last || *last < *first || left.empty())
        return std::nullopt;
    return NumberedName{std::string(left), *first, *last,
                        percent_decoded(trimmed(comment.substr(equals + 1)))};
}

/// Gives each number of a file a place in a list of names.
class Places {
public:
    Places(const std::vector<NumberedName>& table, std::string_view kind)
    {
        for (const NumberedName& row : table)
            if (row.kind == kind) {
                place_.try_emplace(row.first, names.size());
                names.push_back(row.name);
            }
    }

    bool knows(std::int64_t number) const { return place_.count(number) > 0; }

    std::size_t of(std::int64_t number)
    {
        if (number == last_number_ && !names.empty())
            return last_place_;
        const auto [entry, is_new] = place_.try_emplace(number, names.size());
        if (is_new)
            names.push_back(std::to_string(number));
        last_number_ = number;
        last_place_ = entry->second;
        return last_place_;
    }

    std::vector<std::string> names;

private:
    std::unordered_map<std::int64_t, std::size_t> place_;
    std::int64_t last_number_ = INT64_MIN; // neighbours in a file mostly have the same
    std::size_t last_place_ = 0;
};

} // namespace

std::string names_text(const std::vector<NumberedName>& names)
{
    std::string text;
    for (const NumberedName& row : names) {
        text += "# " + row.kind + " " + std::to_string(row.first);
        text += row.last > row.first ? " to " + std::to_string(row.last) : "";
        text += " = " + line_name(row.name) + "\n";
    }
    return text;
}

std::vector<NumberedName> read_names(std::string_view text)
{
    std::vector<NumberedName> names;
    for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at)) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (auto row = table_line(text.substr(at + 1, end - at - 1)))
            names.push_back(std::move(*row));
        at = end;
    }
    return names;
}

std::vector<std::int32_t> numbers_of(const std::vector<std::string>& names, bool zero)
{
    std::vector<std::int32_t> numbers(names.size());
    std::vector<bool> done(names.size(), false);
    std::set<std::int64_t> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto number = number_in(names[i]);
        done[i] = number && std::to_string(*number) == names[i] && *number == static_cast<Index>(*number) &&
                  (zero || *number != 0) && taken.insert(*number).second;
        numbers[i] = done[i] ? static_cast<std::int32_t>(*number) : 0;
    }
    std::int32_t next = 1;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (done[i])
            continue;
        while (taken.count(next) > 0)
            ++next;
        numbers[i] = next++;
    }
    return numbers;
}

GroupReferences group_references(const MeshData& mesh)
{
    std::vector<std::string> names;
    for (const ElementGroup& group : mesh.groups)
        names.push_back(group.name);
    GroupReferences references{numbers_of(names, false), std::vector<std::int32_t>(mesh.elements.size(), 0)};
    for (std::size_t g = mesh.groups.size(); g-- > 0;) // the first has the last word
        for (const Index element : mesh.groups[g].elements)
            references.elements[static_cast<std::size_t>(element)] = references.groups[g];
    return references;
}

std::vector<ElementGroup> groups_from(const std::vector<std::int64_t>& references,
                                      const std::vector<NumberedName>& names)
{
    Places places(names, "group");
    const bool zero = places.knows(0);
    std::vector<ElementGroup> groups(places.names.size());
    for (std::size_t e = 0; e < references.size(); ++e) {
        if (references[e] == 0 && !zero)
            continue;
        const std::size_t place = places.of(references[e]);
        groups.resize(std::max(groups.size(), place + 1));
        groups[place].elements.push_back(static_cast<Index>(e));
    }
    for (std::size_t g = 0; g < groups.size(); ++g)
        groups[g].name = places.names[g];
    return groups;
}

std::vector<Marker> markers_from(const std::vector<std::array<Index, 2>>& edges,
                                 const std::vector<std::int64_t>& references,
                                 const std::vector<NumberedName>& names)
{
    Places places(names, "marker");
    std::vector<Marker> markers(places.names.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t place = places.of(references[i]);
        markers.resize(std::max(markers.size(), place + 1));
        markers[place].edges.push_back(edges[i]);
    }
    for (std::size_t m = 0; m < markers.size(); ++m)
        markers[m].name = places.names[m];
    return markers;
}

} // namespace morph
