#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morph {

/// A way of compressing a block of bytes.
struct Compressor {
    std::string_view name;
    std::string_view vtk_name; ///< in the attribute `compressor` of VTK's XML files
    std::size_t largest_ratio; ///< no block of n bytes stands for more than largest_ratio * (n + 1)

    /// Fill exactly the @p size bytes at @p out; false when @p block does not stand for that many.
    bool (*decompress)(std::string_view block, char* out, std::size_t size);
};

/// The compressor of that name, or null.
const Compressor* find_compressor(std::string_view vtk_name);

/// A block of bytes as zlib compresses it (RFC 1950), fast rather than small.
std::string zlib_compressed(std::string_view block);

} // namespace morph
