#include "formats/ugrid/layout.h"

#include "formats/binary/gzip.h"
#include "formats/ugrid/counts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>

namespace morph {

namespace {

constexpr std::array<UgridLayout, 10> kBinary{{
    {".lb8", true, true, false, 8, 4},
    {".b8", true, false, false, 8, 4},
    {".lb4", true, true, false, 4, 4},
    {".b4", true, false, false, 4, 4},
    {".lr8", true, true, true, 8, 4},
    {".r8", true, false, true, 8, 4},
    {".lr4", true, true, true, 4, 4},
    {".r4", true, false, true, 4, 4},
    {".lb8l", true, true, false, 8, 8},
    {".b8l", true, false, false, 8, 8},
}};

bool is_text(std::string_view bytes)
{
    constexpr std::size_t enough = 256;
    const std::string_view start = bytes.substr(0, enough);
    return std::all_of(start.begin(), start.end(),
                       [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\r' || c == '\n'; });
}

/// Whole number at a place of a file that is long enough.
std::int64_t number_at(std::string_view bytes, std::size_t at, const UgridLayout& layout)
{
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes.data() + at, layout.number_size);
    if (layout.little_endian != (std::endian::native == std::endian::little))
        std::reverse(raw.data(), raw.data() + layout.number_size);
    if (layout.number_size == 8)
        return std::bit_cast<std::int64_t>(raw);
    std::int32_t number = 0;
    std::memcpy(&number, raw.data(), sizeof number);
    return number;
}

bool fits(std::string_view bytes, const UgridLayout& layout)
{
    const std::size_t head = layout.records ? 4 : 0;
    if (bytes.size() < 7 * layout.number_size + head)
        return false;
    UgridCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts.at(i) = number_at(bytes, head + i * layout.number_size, layout);
        if (counts.at(i) < 0 || counts.at(i) > INT32_MAX)
            return false;
    }
    const std::uint64_t size = 4 * head + 3 * static_cast<std::uint64_t>(counts[0]) * layout.real_size +
                               (7 + ugrid_whole_numbers(counts)) * layout.number_size;
    return size == bytes.size();
}

} // namespace

UgridLayout ugrid_layout_of_name(const std::string& path)
{
    const std::filesystem::path name = without_gz(path);
    const std::string extension = name.stem().extension().string();
    const auto* const found = std::find_if(kBinary.begin(), kBinary.end(), [&](const UgridLayout& layout) {
        return layout.extension == extension;
    });
    return found == kBinary.end() ? UgridLayout{} : *found;
}

std::optional<UgridLayout> ugrid_layout_of_bytes(std::string_view bytes)
{
    if (is_text(bytes))
        return UgridLayout{};
    const auto* const found = std::find_if(kBinary.begin(), kBinary.end(),
                                           [&](const UgridLayout& layout) { return fits(bytes, layout); });
    return found == kBinary.end() ? std::nullopt : std::optional(*found);
}

std::string ugrid_stem(const std::string& path)
{
    const std::filesystem::path name = without_gz(path);
    const std::string stem = std::filesystem::path(name).replace_extension().string();
    return stem.substr(0, stem.size() - ugrid_layout_of_name(path).extension.size());
}

} // namespace morph
