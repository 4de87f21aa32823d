// Any bytes become a sound mesh, or an InputError: what a child process left that read a damaged file.
#include "formats/binary/mesh_bytes.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    morph::ReadNotes notes;
    try {
        const morph::MeshData mesh =
            morph::mesh_from_bytes({reinterpret_cast<const char*>(bytes), size}, "fuzz", notes).mesh;
        for (const morph::Element& element : mesh.elements)
            if (*std::max_element(element.begin(), element.end()) >= mesh.points.rows())
                std::abort();
    } catch (const morph::InputError&) { // what broken bytes deserve
    }
    return 0;
}
