#include "formats/binary/number_array.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace morph {

namespace {

struct TypeInfo {
    std::string_view name;
    std::size_t size;
};

constexpr std::array<TypeInfo, 10> kTypes{{{"Int8", 1},
                                           {"UInt8", 1},
                                           {"Int16", 2},
                                           {"UInt16", 2},
                                           {"Int32", 4},
                                           {"UInt32", 4},
                                           {"Int64", 8},
                                           {"UInt64", 8},
                                           {"Float32", 4},
                                           {"Float64", 8}}};

template <class T>
T load(const char* from, bool swapped)
{
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), from, sizeof(T));
    if (swapped)
        std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

/// Call use(T{}) with the C++ type of the array's numbers.
template <class Use>
void with_type(NumberType type, const Use& use)
{
    switch (type) {
    case NumberType::int8:
        return use(std::int8_t{});
    case NumberType::uint8:
        return use(std::uint8_t{});
    case NumberType::int16:
        return use(std::int16_t{});
    case NumberType::uint16:
        return use(std::uint16_t{});
    case NumberType::int32:
        return use(std::int32_t{});
    case NumberType::uint32:
        return use(std::uint32_t{});
    case NumberType::int64:
        return use(std::int64_t{});
    case NumberType::uint64:
        return use(std::uint64_t{});
    case NumberType::float32:
        return use(float{});
    case NumberType::float64:
        return use(double{});
    }
}

template <class Integer, class T>
Integer whole_number(T value)
{
    constexpr auto bad = static_cast<Integer>(-1);
    if constexpr (std::is_floating_point_v<T>) {
        constexpr double limit = 9007199254740992.0; // 2^53: beyond it a double no longer names one integer
        if (!(value >= 0 && value <= limit) || std::floor(value) != value)
            return bad;
        return whole_number<Integer>(static_cast<std::int64_t>(value));
    } else {
        return std::cmp_less(value, 0) || std::cmp_greater(value, std::numeric_limits<Integer>::max())
                   ? bad
                   : static_cast<Integer>(value);
    }
}

template <class T>
void append_number(std::string& text, T value)
{
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

} // namespace

std::size_t size_of(NumberType type)
{
    return kTypes[static_cast<std::size_t>(type)].size;
}

std::optional<NumberType> number_type(std::string_view name)
{
    for (std::size_t i = 0; i < kTypes.size(); ++i)
        if (kTypes[i].name == name)
            return static_cast<NumberType>(i);
    return std::nullopt;
}

std::string_view name_of(NumberType type)
{
    return kTypes[static_cast<std::size_t>(type)].name;
}

void copy_numbers(const NumberArray& array, double* out)
{
    if (array.type == NumberType::float64 && !array.swapped) {
        if (!array.bytes.empty())
            std::memcpy(out, array.bytes.data(), array.bytes.size());
        return;
    }
    with_type(array.type, [&](auto zero) {
        using T = decltype(zero);
        const std::size_t count = array.size();
        for (std::size_t i = 0; i < count; ++i)
            out[i] = static_cast<double>(load<T>(array.bytes.data() + i * sizeof(T), array.swapped));
    });
}

template <class Integer>
std::vector<Integer> whole_numbers(const NumberArray& array)
{
    std::vector<Integer> numbers(array.size());
    with_type(array.type, [&](auto zero) {
        using T = decltype(zero);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = whole_number<Integer>(load<T>(array.bytes.data() + i * sizeof(T), array.swapped));
    });
    return numbers;
}

template std::vector<std::uint8_t> whole_numbers<std::uint8_t>(const NumberArray& array);
template std::vector<std::int32_t> whole_numbers<std::int32_t>(const NumberArray& array);
template std::vector<std::int64_t> whole_numbers<std::int64_t>(const NumberArray& array);

std::string text_of(const NumberArray& array, std::size_t position)
{
    std::string text;
    const std::size_t size = size_of(array.type);
    append_text(text, {array.type, array.bytes.substr(position * size, size), array.swapped}, 2);
    return text;
}

void append_text(std::string& text, const NumberArray& array, std::size_t per_line)
{
    with_type(array.type, [&](auto zero) {
        using T = decltype(zero);
        const std::size_t count = array.size();
        for (std::size_t i = 0; i < count; ++i) {
            append_number(text, load<T>(array.bytes.data() + i * sizeof(T), array.swapped));
            if (i + 1 < count)
                text += (i + 1) % per_line == 0 ? '\n' : ' ';
        }
    });
}

std::string swapped_bytes(const NumberArray& array)
{
    std::string bytes(array.bytes);
    const std::size_t size = size_of(array.type);
    for (std::size_t at = 0; at + size <= bytes.size(); at += size)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    return bytes;
}

} // namespace morph
