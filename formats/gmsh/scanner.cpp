#include "formats/gmsh/scanner.h"

#include "libmorph/core/error.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kLongestName = 40; ///< of a section in a message

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// The position of @p key as a word of its own, or npos.
std::size_t find_word(std::string_view text, const std::string& key, std::size_t from)
{
    for (std::size_t at = text.find(key, from); at != std::string_view::npos; at = text.find(key, at + 1))
        if (at + key.size() == text.size() || is_blank(text[at + key.size()]))
            return at;
    return std::string_view::npos;
}

} // namespace

GmshScanner::GmshScanner(const InputBytes& file)
    : file_(file), bytes_(file.bytes), text_(file.path, file.bytes), end_(file.bytes.size())
{
    read_header();
    find_sections();
}

std::string GmshScanner::version_text() const
{
    const std::string number = is_version_2() ? "2.2" : is_version_4_0() ? "4.0" : "4.1";
    return number + (binary_ ? ", binary" : ", ASCII");
}

void GmshScanner::read_header()
{
    text_.skip_white();
    if (!text_.rest().starts_with("$MeshFormat"))
        text_.fail(text_.rest().starts_with("$NOD")
                       ? "a Gmsh file of version 1; only 2, 4.0 and 4.1 are read"
                       : "expected $MeshFormat, with which Gmsh files begin, found " + text_.found());
    text_.skip_line();
    const std::size_t position = text_.position();
    version_ = text_.real("the version of the format");
    if (!(version_ >= 2 && version_ < 3) && version_ != 4.0 && version_ != 4.1)
        text_.fail_at(position, "a Gmsh file of another version than 2, 4.0 and 4.1");
    const std::int64_t type = text_.integer("0 for text or 1 for binary");
    const std::int64_t size = text_.integer("the size of numbers");
    binary_ = type == 1;
    wide_ = size == 8;
    const bool known_size = wide_ || (size == 4 && version_ == 4.1);
    if ((type != 0 && type != 1) || (binary_ && !known_size))
        text_.fail_at(position, "expected a file type of 0 or 1 and numbers of " +
                                    std::string(version_ == 4.1 ? "4 or 8" : "8") + " bytes, found " +
                                    std::to_string(type) + " and " + std::to_string(size));
    text_.end_line("the header");
    text_.skip_line();
    if (!binary_)
        return;
    at_ = text_.position();
    const auto one = raw<std::uint32_t>("the number 1 that marks the byte order");
    swapped_ = one == 0x01000000U;
    if (one != 1 && !swapped_)
        fail_at(at_ - sizeof one, "expected the number 1 that marks the byte order");
    text_.seek(at_);
}

void GmshScanner::find_sections()
{
    text_.skip_white();
    if (!text_.rest().starts_with("$EndMeshFormat"))
        text_.fail_expected("$EndMeshFormat");
    text_.skip_line();
    std::size_t junk = std::string_view::npos;
    while (text_.skip_white())
        if (text_.rest().starts_with('$'))
            find_section();
        else {
            junk = std::min(junk, text_.position());
            text_.skip_line();
        }
    if (junk != std::string_view::npos)
        file_.warn("line " + std::to_string(text_.line_of(junk)) +
                   ": what stands outside of the sections was passed over");
}

void GmshScanner::find_section()
{
    GmshSection section;
    section.key = text_.position();
    section.name = text_.word("the name of a section").substr(1);
    text_.skip_line();
    section.start = text_.position();
    section.end = find_word(bytes_, "$End" + section.name, section.start);
    if (section.end == std::string_view::npos || section.name.empty()) {
        text_.seek(section.key);
        text_.fail(text_.found() + " has no end" +
                   (section.name.size() > kLongestName ? "" : ": expected $End" + section.name) +
                   " behind it");
    }
    text_.seek(section.end);
    text_.skip_line();
    sections_.push_back(std::move(section));
}

void GmshScanner::enter(const GmshSection& section)
{
    end_ = section.end;
    text_.seek(section.start);
    in_bytes_ = false;
}

void GmshScanner::begin_numbers()
{
    if (!binary_)
        return;
    at_ = text_.position();
    in_bytes_ = true;
}

bool GmshScanner::at_end()
{
    if (!in_bytes_) {
        text_.skip_white();
        return text_.position() >= end_;
    }
    const std::string_view left = bytes_.substr(at_, end_ - at_);
    return std::all_of(left.begin(), left.end(), is_blank);
}

void GmshScanner::leave()
{
    if (at_end())
        return;
    if (!in_bytes_)
        text_.fail_expected("the end of the section");
    fail_at(at_, "expected the end of the section, found " + std::to_string(end_ - at_) + " more bytes");
}

std::int64_t GmshScanner::text_integer(std::string_view what)
{
    std::int64_t value = 0;
    text_.skip_white();
    if (!text_.try_integer(value))
        text_.fail_expected(what);
    return value;
}

double GmshScanner::text_real(std::string_view what)
{
    double value = 0;
    if (text_.at_line_end())
        text_.skip_white();
    if (!text_.try_real(value))
        text_.fail_expected(what);
    return value;
}

Index GmshScanner::checked_count(std::int64_t number, std::size_t position, std::string_view what,
                                 std::size_t record_bytes) const
{
    const std::size_t left = end_ - std::min(end_, this->position());
    if (number < 0 || static_cast<std::size_t>(number) > left / record_bytes || number > INT32_MAX)
        fail_at(position, "expected " + std::string(what) + ", found " + std::to_string(number) +
                              ", for which the section is too short");
    return static_cast<Index>(number);
}

Index GmshScanner::count(std::string_view what, std::size_t text_bytes, std::size_t binary_bytes)
{
    if (!in_bytes_)
        text_.skip_white();
    const std::size_t start = position();
    const std::int64_t number = size(what);
    return checked_count(number, start, what, in_bytes_ ? binary_bytes : text_bytes);
}

Index GmshScanner::first_count(std::string_view what, std::size_t text_bytes, std::size_t binary_bytes)
{
    if (!is_version_2()) {
        begin_numbers();
        return count(what, text_bytes, binary_bytes);
    }
    text_.skip_white();
    const std::size_t start = text_.position();
    const std::int64_t number = text_integer(what);
    text_.skip_line();
    begin_numbers();
    return checked_count(number, start, what, binary_ ? binary_bytes : text_bytes);
}

void GmshScanner::fail_short(std::string_view what) const
{
    fail_at(at_, "expected " + std::string(what) + ", found the end of the section");
}

void GmshScanner::fail_at(std::size_t position, const std::string& message) const
{
    if (!binary_)
        text_.fail_at(position, message);
    throw InputError(file_.path + ": byte " + std::to_string(position) + ": " + message);
}

} // namespace morph
