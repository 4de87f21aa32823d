#include "formats/binary/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace morph {

namespace {

constexpr std::uint8_t kSpace = 64;
constexpr std::uint8_t kPadding = 65;
constexpr std::uint8_t kBad = 66;

constexpr std::array<std::uint8_t, 256> make_values()
{
    std::array<std::uint8_t, 256> values{};
    values.fill(kBad);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
    for (const unsigned char space : {' ', '\t', '\n', '\r'})
        values[space] = kSpace;
    values['='] = kPadding;
    return values;
}

constexpr std::array<std::uint8_t, 256> kValues = make_values();

} // namespace

std::optional<std::string> decode_base64(std::string_view text, std::size_t wanted)
{
    std::string bytes;
    bytes.reserve(std::min(wanted, text.size() / 4 * 3) + 3);
    std::uint32_t group = 0;
    int digits = 0;
    int padding = 0;
    for (const char c : text) {
        const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
        if (value == kSpace)
            continue;
        if (value == kBad || (value == kPadding && digits < 2) || (value != kPadding && padding > 0))
            return std::nullopt;
        padding += value == kPadding ? 1 : 0;
        group = group << 6 | (value == kPadding ? 0U : value);
        if (++digits < 4)
            continue;
        for (int i = 0; i < 3 - padding; ++i)
            bytes += static_cast<char>(group >> (16 - 8 * i) & 0xff);
        if (bytes.size() >= wanted)
            return bytes;
        group = 0;
        digits = padding = 0;
    }
    if (digits != 0)
        return std::nullopt;
    return bytes;
}

} // namespace morph
