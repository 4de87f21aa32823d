#include "formats/ply/rows.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace morph {

template <class T>
double PlyRows::load(const char* from) const
{
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), from, sizeof(T));
    if (swapped_)
        std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
}

double PlyRows::binary_number(NumberType type)
{
    const std::string_view rest = in_.rest();
    const std::size_t size = size_of(type);
    if (rest.size() < size)
        fail(in_.position(), "the file ends within its rows; it is cut off");
    in_.seek(in_.position() + size);
    switch (type) {
    case NumberType::int8:
        return load<std::int8_t>(rest.data());
    case NumberType::uint8:
        return load<std::uint8_t>(rest.data());
    case NumberType::int16:
        return load<std::int16_t>(rest.data());
    case NumberType::uint16:
        return load<std::uint16_t>(rest.data());
    case NumberType::int32:
        return load<std::int32_t>(rest.data());
    case NumberType::uint32:
        return load<std::uint32_t>(rest.data());
    case NumberType::int64:
        return load<std::int64_t>(rest.data());
    case NumberType::uint64:
        return load<std::uint64_t>(rest.data());
    case NumberType::float32:
        return load<float>(rest.data());
    default:
        return load<double>(rest.data());
    }
}

double PlyRows::text_number(NumberType type)
{
    in_.skip_white();
    Index index = 0; // of which most of a file consists
    if (type != NumberType::float32 && type != NumberType::float64 && in_.try_index(index))
        return index;
    double value = 0;
    if (in_.try_real(value))
        return value;
    const std::string_view rest = in_.rest();
    const auto [after, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const bool whole = after == rest.data() + rest.size() || kEndsNumber[static_cast<unsigned char>(*after)];
    if (error != std::errc{} || std::isfinite(value) || !whole) // what is left are nan and inf
        in_.fail_expected("a number");
    in_.seek(in_.position() + static_cast<std::size_t>(after - rest.data()));
    return value;
}

const std::vector<double>& PlyRows::list(const PlyProperty& property)
{
    const std::size_t at = position();
    const double length = number(*property.length_type);
    if (!(length >= 0 && length <= static_cast<double>(in_.rest().size())))
        fail(at, "a list of the property '" + property.name + "' has an impossible length");
    list_.clear();
    for (double i = 0; i < length; ++i)
        list_.push_back(number(property.type));
    return list_;
}

std::size_t PlyRows::position()
{
    if (text_)
        in_.skip_white();
    return in_.position();
}

void PlyRows::fail(std::size_t position, const std::string& what) const
{
    if (text_)
        in_.fail_at(position, what);
    throw InputError(in_.path() + ": byte " + std::to_string(position) + ": " + what);
}

} // namespace morph
