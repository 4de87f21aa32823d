#include "formats/su2/sections.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cctype>

namespace morph {

std::string_view try_su2_key(TextScanner& in)
{
    const std::string_view line = in.rest();
    const auto is_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::size_t length = 0;
    while (length < line.size() && is_name(line[length]))
        ++length;
    std::size_t equals = length;
    while (equals < line.size() && (line[equals] == ' ' || line[equals] == '\t'))
        ++equals;
    if (length == 0 || equals == line.size() || line[equals] != '=')
        return {};
    in.seek(in.position() + equals + 1);
    return line.substr(0, length);
}

std::optional<std::size_t> find_su2_key(TextScanner& in, std::string_view name, std::size_t from)
{
    const std::string_view text = in.text();
    for (std::size_t at = text.find(name, from); at != std::string_view::npos; at = text.find(name, at + 1)) {
        const std::size_t before = text.substr(0, at).find_last_not_of(" \t\r");
        in.seek(at);
        if ((before == std::string_view::npos || text[before] == '\n') && try_su2_key(in) == name)
            return at;
    }
    return std::nullopt;
}

std::size_t find_su2_dimension(TextScanner& in, std::size_t from)
{
    if (const auto key = find_su2_key(in, "NDIME", from))
        return *key;
    const std::string where =
        from == 0 ? ", so this is no SU2 mesh" : " behind line " + std::to_string(in.line_of(from));
    throw InputError(in.path() + (in.text().empty() ? ": the file is empty" : ": NDIME= is missing" + where));
}

Su2Section read_su2_section(TextScanner& in, std::string_view name, std::size_t key)
{
    Su2Section section{std::string(name), key, 0,
                       in.index("a number of lines after " + std::string(name) + "=")};
    while (!in.at_line_end())
        in.index("a number after " + std::string(name) + "= " + std::to_string(section.count));
    in.skip_line();
    section.start = in.position();
    return section;
}

std::size_t su2_room(const TextScanner& in, const Su2Section& section, std::size_t shortest_line)
{
    const std::size_t most = (in.rest().size() + 1) / shortest_line; // the last one may lack its line end
    return std::min(static_cast<std::size_t>(section.count), most);
}

void fail_su2_short(TextScanner& in, const Su2Section& section, std::size_t done, const std::string& what)
{
    const std::string head = section.name + "= " + std::to_string(section.count) + " but the ";
    if (!in.skip_white())
        in.fail_at(section.key, head + "file ends after " + std::to_string(done));
    const std::string found = in.found();
    const std::string_view key = try_su2_key(in);
    if (!key.empty())
        in.fail_at(section.key,
                   head + "section ends after " + std::to_string(done) + ", at " + std::string(key) + "=");
    in.fail("expected " + what + ", found " + found);
}

std::string_view skip_su2_section(TextScanner& in, std::size_t start,
                                  const std::vector<std::string_view>& parts)
{
    std::size_t end = start;
    do {
        in.skip_line();
        end = in.position();
        if (!in.skip_white())
            break;
        const std::size_t line = in.position();
        const std::string_view key = try_su2_key(in);
        in.seek(line);
        if (!key.empty() && std::find(parts.begin(), parts.end(), key) == parts.end())
            break;
    } while (true);
    return in.text().substr(start, end - start);
}

void fail_su2_vertex(const TextScanner& in, const std::string& who, Index vertex, Index vertices)
{
    in.fail(who + " names vertex " + std::to_string(vertex) + ", but the mesh has " +
            std::to_string(vertices));
}

void seek_su2_line(TextScanner& in, std::size_t section_start, std::size_t line)
{
    in.seek(section_start);
    for (std::size_t i = 0; i < line && in.skip_white(); ++i)
        in.skip_line();
    in.skip_white();
}

} // namespace morph
