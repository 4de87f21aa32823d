#include "formats/vtk/legacy.h"

#include "formats/text/names_in_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <optional>
#include <utility>

namespace morph {

namespace {

std::string capitals(std::string_view word)
{
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

/// As written by 64-bit programs, where `long` has 8 bytes; VTK writes its own ids with 4.
std::optional<NumberType> legacy_type(const std::string& name)
{
    constexpr std::array<std::pair<std::string_view, NumberType>, 17> types{
        {{"CHAR", NumberType::int8},
         {"SIGNED_CHAR", NumberType::int8},
         {"UNSIGNED_CHAR", NumberType::uint8},
         {"SHORT", NumberType::int16},
         {"UNSIGNED_SHORT", NumberType::uint16},
         {"INT", NumberType::int32},
         {"UNSIGNED_INT", NumberType::uint32},
         {"LONG", NumberType::int64},
         {"UNSIGNED_LONG", NumberType::uint64},
         {"VTKTYPEINT64", NumberType::int64},
         {"VTKTYPEUINT64", NumberType::uint64},
         {"VTKTYPEINT32", NumberType::int32},
         {"VTKIDTYPE", NumberType::int32},
         {"LONG_LONG", NumberType::int64},
         {"UNSIGNED_LONG_LONG", NumberType::uint64},
         {"FLOAT", NumberType::float32},
         {"DOUBLE", NumberType::float64}}};
    for (const auto& [known, type] : types)
        if (known == name)
            return type;
    return std::nullopt;
}

} // namespace

std::string LegacyVtkScanner::header()
{
    constexpr std::string_view mark = "# vtk DataFile Version ";
    if (!text_.rest().starts_with(mark))
        text_.fail("expected '" + std::string(mark) + "x.y', found " + text_.found());
    text_.seek(mark.size());
    version_ = text_.word("a version such as 3.0");
    text_.seek(mark.size());
    const double version = text_.real("a version such as 3.0");
    if (!(version >= 1 && version < 6))
        text_.fail("this is version " + std::to_string(version) +
                   " of the legacy VTK format, but 1.0 to 5.1 are supported");
    major_version_ = static_cast<int>(version);
    text_.skip_line();
    text_.skip_line(); // the title
    const std::string coding = keyword();
    if (coding != "ASCII" && coding != "BINARY")
        fail_expected("ASCII or BINARY");
    binary_ = coding == "BINARY";
    if (keyword() != "DATASET")
        fail_expected("DATASET");
    return capitals(text_.word("a kind of data set such as UNSTRUCTURED_GRID"));
}

std::string LegacyVtkScanner::keyword()
{
    const bool more = text_.skip_white();
    before_keyword_ = text_.position();
    return more ? capitals(text_.word("a keyword")) : std::string();
}

void LegacyVtkScanner::fail_expected(std::string_view what)
{
    put_back();
    text_.fail_expected(what);
}

void LegacyVtkScanner::skip_lookup_table_line()
{
    constexpr std::string_view wanted = "LOOKUP_TABLE";
    const std::size_t line = text_.position();
    text_.skip_line();
    if (capitals(text_.rest().substr(0, wanted.size())) == wanted)
        text_.rest_of_line(); // the numbers start behind the end of this line
    else
        text_.seek(line);
}

std::size_t LegacyVtkScanner::count_or(std::size_t otherwise)
{
    Index value = 0;
    return text_.try_index(value) ? static_cast<std::size_t>(value) : otherwise;
}

std::string LegacyVtkScanner::name(std::string_view what)
{
    return percent_decoded(text_.word(what));
}

std::string LegacyVtkScanner::type_word()
{
    return capitals(text_.word("a type of numbers such as double"));
}

void LegacyVtkScanner::skip_metadata()
{
    do
        text_.skip_line();
    while (!text_.at_line_end());
}

std::string_view LegacyVtkScanner::bytes(std::size_t count, std::size_t size)
{
    const std::string_view rest = text_.rest();
    if (count > rest.size() / size)
        text_.fail(std::to_string(count) + " numbers of " + std::to_string(size) +
                   " bytes each were expected, but only " + std::to_string(rest.size()) +
                   " bytes follow in the file");
    text_.seek(text_.position() + count * size);
    return rest.substr(0, count * size);
}

NumberArray LegacyVtkScanner::numbers(const std::string& type, std::size_t count)
{
    const auto known = legacy_type(type);
    if (!known)
        fail("the type of the numbers is not one of those supported, such as double, float, int and long");
    if (binary_) {
        text_.skip_line();
        return {*known, bytes(count, size_of(*known)), std::endian::native == std::endian::little};
    }
    if (count > text_.rest().size() / 2 + 1)
        text_.fail(std::to_string(count) + " numbers were expected, but only " +
                   std::to_string(text_.rest().size()) + " bytes follow in the file");
    numbers_.clear();
    numbers_.reserve(count);
    read_numbers(text_, count, numbers_);
    if (numbers_.size() < count)
        text_.fail_expected("number " + std::to_string(numbers_.size() + 1) + " of " + std::to_string(count));
    return view_of(NumberType::float64, numbers_.data(), count);
}

/// The length in 1, 2, 4 or 8 bytes (the two highest bits of the first say how many: 3, 2, 1, 0), and the
/// text.
std::string LegacyVtkScanner::binary_string()
{
    const auto first = static_cast<unsigned char>(bytes(1, 1)[0]);
    const std::size_t more = (std::size_t{1} << (3 - (first >> 6))) - 1;
    std::uint64_t length = first & 63U;
    for (const char c : bytes(more, 1))
        length = length << 8 | static_cast<unsigned char>(c);
    return std::string(bytes(length, 1));
}

std::vector<std::string> LegacyVtkScanner::strings(std::size_t count)
{
    text_.skip_line();
    if (count > text_.rest().size())
        text_.fail(std::to_string(count) + " strings were expected, but only " +
                   std::to_string(text_.rest().size()) + " bytes follow in the file");
    std::vector<std::string> strings;
    for (std::size_t i = 0; i < count; ++i) {
        if (binary_) {
            strings.push_back(binary_string());
            continue;
        }
        strings.push_back(percent_decoded(text_.rest_of_line()));
        text_.skip_line();
    }
    return strings;
}

} // namespace morph
