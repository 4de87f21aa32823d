// Any bytes become a mesh and flat arrays again, or an InputError. Compiled once for each format,
// named by MORPH_FUZZ_FORMAT.
#include "formats/format.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const morph::Format& format = morph::find_format("", MORPH_FUZZ_FORMAT);
    try {
        morph::MeshData data = format.read({"fuzz", {reinterpret_cast<const char*>(bytes), size}});
        morph::to_mesh_data(morph::build_mesh(std::move(data)));
    } catch (const morph::InputError&) { // what broken files deserve
    }
    return 0;
}
