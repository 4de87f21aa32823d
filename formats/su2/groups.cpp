#include "formats/su2/groups.h"

#include "formats/text/message_text.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::string_view kTag = "% GROUP_TAG=";
constexpr std::string_view kCount = "% GROUP_ELEMS=";
constexpr std::size_t kPerLine = 16;

/// A scanner at the same place to which comments are text.
TextScanner without_comments(const TextScanner& in)
{
    TextScanner scanner(in.path(), in.text());
    scanner.seek(in.position());
    return scanner;
}

} // namespace

bool Su2Groups::skip_to_section(TextScanner& in)
{
    while (in.at_line_end()) {
        const std::string_view rest = in.rest();
        if (rest.empty())
            return false;
        if (rest.starts_with(kTag))
            read(in);
        else
            in.skip_line();
    }
    return true;
}

void Su2Groups::read(TextScanner& in)
{
    TextScanner lines = without_comments(in);
    positions_.push_back(in.position());
    lines.seek(in.position() + kTag.size());
    ElementGroup& group = groups_.emplace_back();
    group.name = percent_decoded(lines.rest_of_line());
    lines.skip_line();
    if (!lines.rest().starts_with(kCount))
        lines.fail_expected("'" + std::string(kCount) + "' below the name of a group");
    lines.seek(lines.position() + kCount.size());
    const Index count = lines.index("the number of elements of the group " + quoted_text(group.name));
    lines.end_line("the number of elements");
    lines.skip_line();
    while (group.elements.size() < static_cast<std::size_t>(count)) {
        if (!lines.rest().starts_with('%'))
            lines.fail_expected("'%' and more of the " + std::to_string(count) + " elements of the group " +
                                quoted_text(group.name));
        lines.seek(lines.position() + 1);
        while (!lines.at_line_end())
            group.elements.push_back(lines.index("an element of the group " + quoted_text(group.name)));
        lines.skip_line();
    }
    if (group.elements.size() > static_cast<std::size_t>(count))
        in.fail("the group " + quoted_text(group.name) + " should have " + std::to_string(count) +
                " elements, but has " + std::to_string(group.elements.size()));
    in.seek(lines.position());
}

void Su2Groups::check_elements(const TextScanner& in, std::size_t elements) const
{
    std::vector<std::size_t> last(elements, groups_.size()); // group that named each element last
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (const Index element : groups_[g].elements) {
            const auto e = static_cast<std::size_t>(element);
            if (e >= elements)
                in.fail_at(positions_[g], "the group " + quoted_text(groups_[g].name) + " names element " +
                                              std::to_string(e) + ", but the mesh has " +
                                              std::to_string(elements));
            if (last[e] == g)
                in.fail_at(positions_[g], "the group " + quoted_text(groups_[g].name) + " names element " +
                                              std::to_string(e) + " twice");
            last[e] = g;
        }
}

void append_su2_groups(const std::vector<ElementGroup>& groups, OutputFile& out)
{
    for (const ElementGroup& group : groups) {
        out.append(std::string(kTag) + " " + line_name(group.name) + "\n");
        out.append(std::string(kCount) + " " + std::to_string(group.elements.size()) + "\n");
        for (std::size_t i = 0; i < group.elements.size(); ++i) {
            const bool ends_line = (i + 1) % kPerLine == 0 || i + 1 == group.elements.size();
            char* to = out.room(kLongestNumber + 2);
            if (i % kPerLine == 0)
                to = std::copy_n("% ", 2, to);
            out.advance_to(number_text(to, group.elements[i], ends_line ? '\n' : ' '));
        }
    }
}

} // namespace morph
