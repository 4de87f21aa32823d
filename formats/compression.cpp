#include "formats/compression.h"

#include <array>

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

// Deflate cannot do better than 1032:1 (zlib's own documentation of its maximum compression factor).
constexpr std::array<Compressor, 1> kCompressors{{{"vtkZLibDataCompressor", 1032, decompress_zlib}}};

} // namespace

const Compressor* find_compressor(std::string_view vtk_name)
{
    for (const Compressor& compressor : kCompressors)
        if (compressor.vtk_name == vtk_name)
            return &compressor;
    return nullptr;
}

} // namespace morph
