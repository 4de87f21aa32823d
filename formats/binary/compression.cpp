#include "formats/binary/compression.h"

#include <array>
#include <limits>
#include <stdexcept>

#include <lz4.h>
#include <zlib.h>

namespace morph {

namespace {

bool decompress_zlib(std::string_view block, char* out, std::size_t size)
{
    uLongf written = size;
    const int status =
        uncompress(reinterpret_cast<Bytef*>(out), &written, reinterpret_cast<const Bytef*>(block.data()),
                   static_cast<uLong>(block.size()));
    return status == Z_OK && written == size;
}

bool decompress_lz4(std::string_view block, char* out, std::size_t size)
{
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (block.size() > most || size > most)
        return false;
    const int written =
        LZ4_decompress_safe(block.data(), out, static_cast<int>(block.size()), static_cast<int>(size));
    return written >= 0 && static_cast<std::size_t>(written) == size;
}

// Deflate cannot do better than 1032:1 (zlib's own documentation of its maximum compression factor); a
// byte of LZ4 lengthens a match by 255 at most (its block format).
constexpr std::array<Compressor, 2> kCompressors{{{"zlib", "vtkZLibDataCompressor", 1032, decompress_zlib},
                                                  {"lz4", "vtkLZ4DataCompressor", 255, decompress_lz4}}};

} // namespace

const Compressor* find_compressor(std::string_view vtk_name)
{
    for (const Compressor& compressor : kCompressors)
        if (compressor.vtk_name == vtk_name)
            return &compressor;
    return nullptr;
}

std::string zlib_compressed(std::string_view block)
{
    std::string out(compressBound(static_cast<uLong>(block.size())), '\0');
    uLongf written = out.size();
    const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &written,
                                 reinterpret_cast<const Bytef*>(block.data()),
                                 static_cast<uLong>(block.size()), Z_BEST_SPEED);
    if (status != Z_OK)
        throw std::runtime_error("zlib could not compress a block"); // it had room for the worst case
    out.resize(written);
    return out;
}

} // namespace morph
