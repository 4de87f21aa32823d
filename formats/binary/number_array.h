#pragma once

#include "libmorph/core/types.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// The number types of VTK's and PLY's files.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one number of that type.
std::size_t size_of(NumberType type);

/// The type called @p name in VTK's XML files ("Float64"), or nothing.
std::optional<NumberType> number_type(std::string_view name);

/// Its name in VTK's XML files.
std::string_view name_of(NumberType type);

/// Numbers of one type as bytes that somebody else keeps; they need not be aligned.
struct NumberArray {
    NumberType type = NumberType::float64;
    std::string_view bytes;
    bool swapped = false; ///< in the byte order that is not this machine's

    std::size_t size() const { return bytes.size() / size_of(type); }
};

/// The numbers of a vector as an array that views them.
template <class T>
NumberArray view_of(NumberType type, const T* numbers, std::size_t count)
{
    return {type, {reinterpret_cast<const char*>(numbers), count * sizeof(T)}, false};
}

/// Write the array's size() numbers at @p out; 64-bit integers are rounded to the nearest double.
void copy_numbers(const NumberArray& array, double* out);

/// The numbers as integers of another type (Index, std::int64_t or std::uint8_t); -1 (of unsigned
/// types the largest) for each that is negative, not whole, or too large.
template <class Integer>
std::vector<Integer> whole_numbers(const NumberArray& array);

/// Number @p position in the array, as text for a message.
std::string text_of(const NumberArray& array, std::size_t position);

/// Append the numbers to @p text, @p per_line to a line; real numbers as the shortest text that
/// reads back to the same double.
void append_text(std::string& text, const NumberArray& array, std::size_t per_line);

/// The bytes of the array with those of each number in the opposite order.
std::string swapped_bytes(const NumberArray& array);

} // namespace morph
