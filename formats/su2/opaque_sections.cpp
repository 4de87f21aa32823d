#include "formats/su2/opaque_sections.h"

#include <algorithm>

namespace morph {

Su2OpaqueSections::Section& Su2OpaqueSections::append(const std::string& what, bool counted,
                                                      std::size_t count, std::string_view text)
{
    if (sections_.empty() || !counted || sections_.back().what != what)
        sections_.push_back({what, counted, 0, "", true});
    Section& section = sections_.back();
    section.count += count;
    section.text += text;
    if (!section.text.ends_with('\n'))
        section.text += '\n';
    return section;
}

void Su2OpaqueSections::add_section(std::string_view key, std::string_view text)
{
    if (key.starts_with("FFD_"))
        append("FFD box(es)", true, key == "FFD_TAG" ? 1 : 0, text);
    else if (key.starts_with("NPERIODIC") || key.starts_with("PERIODIC_"))
        append("periodic transformation(s)", true, key == "PERIODIC_INDEX" ? 1 : 0, text).names_vertices =
            false;
    else
        append("the section " + std::string(key), false, 0, text).names_vertices =
            key != "AOA_OFFSET" && key != "AOS_OFFSET";
}

void Su2OpaqueSections::add_marker(std::string_view text)
{
    append("SEND_RECEIVE marker(s)", true, 1, text);
}

void Su2OpaqueSections::add_marker_vertices(const std::string& marker, std::size_t count,
                                            const std::string& text)
{
    const std::string number = std::to_string(count);
    append(number + " single vertices of the marker " + marker, false, 0,
           "MARKER_TAG= " + marker + "\nMARKER_ELEMS= " + number + "\n" + text);
}

void Su2OpaqueSections::add_header(std::string_view line)
{
    std::string plain(line);
    std::replace(plain.begin(), plain.end(), '\t', ' ');
    append("the second number of " + plain, false, 0, line);
}

std::vector<OpaqueSection> Su2OpaqueSections::texts() const
{
    std::vector<OpaqueSection> texts;
    for (const Section& section : sections_)
        texts.push_back({"su2",
                         section.counted ? std::to_string(section.count) + " " + section.what : section.what,
                         section.text, section.names_vertices});
    return texts;
}

} // namespace morph
