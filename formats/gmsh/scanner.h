#pragma once

#include "formats/format.h"
#include "formats/text/text_scanner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace morph {

/// What stands between "$Name" and "$EndName".
struct GmshSection {
    std::string name;      ///< "Nodes"
    std::size_t key = 0;   ///< where "$Name" stands
    std::size_t start = 0; ///< of the line after it
    std::size_t end = 0;   ///< where "$EndName" stands
};

/// Reads the numbers of a Gmsh file (.msh) of version 2, 4.0 or 4.1, whether they are text or bytes.
///
/// Counts, and in 4.1 tags, have the type size_t of the program that wrote them, other whole numbers are
/// int; as text, numbers are apart by any white space. Binary numbers have the byte order that the header
/// tells. Source: "MSH file format" in the reference manual, https://gmsh.info/doc/texinfo/gmsh.html.
class GmshScanner {
public:
    /// Reads the header and finds the sections.
    /// @throws InputError  no Gmsh file, a version not known, a section without its end
    explicit GmshScanner(const InputBytes& file);

    const std::vector<GmshSection>& sections() const { return sections_; }
    bool is_version_2() const { return version_ < 3; }
    bool is_version_4_0() const { return version_ == 4.0; }
    bool binary() const { return binary_; }
    std::string version_text() const;

    /// Stand at the first number, or line of text, of a section.
    void enter(const GmshSection& section);
    /// @throws InputError  numbers are left in the section
    void leave();
    /// True at the end of the section.
    bool at_end();

    /// The lines of the section that are text in every file. The numbers start on the line after them.
    TextScanner& text() { return text_; }
    void begin_numbers();

    std::int64_t integer(std::string_view what);
    double real(std::string_view what);
    /// A number of the type size_t, which in a binary file of version 2 is int.
    std::int64_t size(std::string_view what);
    /// Of a vertex or element: size_t in version 4.1, else int.
    std::int64_t tag(std::string_view what);
    /// size(), when the rest of the section can hold as many records.
    /// @param text_bytes, binary_bytes  the least that a record takes
    /// @throws InputError  it cannot
    Index count(std::string_view what, std::size_t text_bytes, std::size_t binary_bytes);
    /// size() of a file of version 4; as text on a line of its own in version 2, also in binary files.
    Index first_count(std::string_view what, std::size_t text_bytes, std::size_t binary_bytes);

    /// Where the next number stands, for fail_at().
    std::size_t position() const { return in_bytes_ ? at_ : text_.position(); }
    /// @throws InputError  "path:line: message", in a binary file "path: byte N: message"
    [[noreturn]] void fail_at(std::size_t position, const std::string& message) const;

private:
    void read_header();
    void find_sections();
    void find_section();
    Index checked_count(std::int64_t number, std::size_t position, std::string_view what,
                        std::size_t record_bytes) const;
    std::int64_t text_integer(std::string_view what);
    double text_real(std::string_view what);
    [[noreturn]] void fail_short(std::string_view what) const;

    template <class T>
    T raw(std::string_view what)
    {
        if (end_ - at_ < sizeof(T))
            fail_short(what);
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), bytes_.data() + at_, sizeof(T));
        if (swapped_)
            std::reverse(bytes.begin(), bytes.end());
        at_ += sizeof(T);
        return std::bit_cast<T>(bytes);
    }

    const InputBytes& file_;
    std::string_view bytes_;
    TextScanner text_;
    std::vector<GmshSection> sections_;
    double version_ = 0;
    bool binary_ = false;
    bool swapped_ = false;
    bool wide_ = true;      ///< size_t has 8 bytes
    bool in_bytes_ = false; ///< at_ counts, not the position in the text
    std::size_t at_ = 0;
    std::size_t end_ = 0; ///< of the section
};

inline std::int64_t GmshScanner::integer(std::string_view what)
{
    Index value = 0;
    if (in_bytes_)
        return raw<std::int32_t>(what);
    return text_.try_index(value) ? value : text_integer(what);
}

inline double GmshScanner::real(std::string_view what)
{
    return in_bytes_ ? raw<double>(what) : text_real(what);
}

inline std::int64_t GmshScanner::size(std::string_view what)
{
    if (!in_bytes_ || is_version_2())
        return integer(what);
    return wide_ ? raw<std::int64_t>(what) : raw<std::uint32_t>(what);
}

inline std::int64_t GmshScanner::tag(std::string_view what)
{
    return is_version_4_0() ? integer(what) : size(what);
}

} // namespace morph
