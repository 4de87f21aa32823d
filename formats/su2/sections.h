#pragma once

#include "formats/text/text_scanner.h"

#include <optional>
#include <vector>

namespace morph {

/// A key with the number of lines that follow it, such as "NELEM= 12".
struct Su2Section {
    std::string name;      ///< "NELEM"
    std::size_t key = 0;   ///< where it stands
    std::size_t start = 0; ///< of the lines
    Index count = 0;
};

/// "NELEM" of a line "NELEM= …", read up to behind the '='. Empty, and nothing is read, when the
/// line is none of that kind.
std::string_view try_su2_key(TextScanner& in);

/// The position of the first line "NAME= …" at or behind @p from, read up to behind its '='.
std::optional<std::size_t> find_su2_key(TextScanner& in, std::string_view name, std::size_t from);

/// The position of "NDIME=", which may stand behind what cannot be read without it.
/// @param from  where the file or its zone begins
/// @throws InputError  there is none
std::size_t find_su2_dimension(TextScanner& in, std::size_t from);

/// The count behind a key. The first line of the section is next.
/// @throws InputError  it is none
Su2Section read_su2_section(TextScanner& in, std::string_view name, std::size_t key);

/// Number of lines worth making room for: what the section says, but not more than the file could hold.
std::size_t su2_room(const TextScanner& in, const Su2Section& section, std::size_t shortest_line);

/// The section lacks its line number @p done; says why. A line of something else is expected to be @p what.
/// @throws InputError  always
[[noreturn]] void fail_su2_short(TextScanner& in, const Su2Section& section, std::size_t done,
                                 const std::string& what);

/// Skip to the next key that is not one of @p parts; returns the text from @p start to there,
/// without trailing comments.
std::string_view skip_su2_section(TextScanner& in, std::size_t start,
                                  const std::vector<std::string_view>& parts = {});

/// Skip the numbers that may end a line and say nothing here: ids, level of the parallel run.
/// False when something else is there.
bool end_su2_line(TextScanner& in);

/// @throws InputError  always: "WHO names vertex 12, but the mesh has 10"
[[noreturn]] void fail_su2_vertex(const TextScanner& in, const std::string& who, Index vertex,
                                  Index vertices);

/// Go to line @p line (from 0) of a section, over blank lines and comments.
void seek_su2_line(TextScanner& in, std::size_t section_start, std::size_t line);

inline bool end_su2_line(TextScanner& in)
{
    Index id = 0;
    std::int64_t number = 0;
    while (!in.at_line_end())
        if (!in.try_index(id) && !in.try_integer(number))
            return false;
    return true;
}

} // namespace morph
