// Any bytes become fields of a small mesh, or an InputError.
#include "formats/medit/solutions.h"
#include "libmorph/core/error.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    morph::MeshData mesh;
    mesh.points = morph::Points::Zero(4, 3);
    mesh.elements = {{0, 1, 2, 3}, {0, 1, 2, -1}};
    try {
        morph::read_medit_solutions({"fuzz", {reinterpret_cast<const char*>(bytes), size}}, mesh);
    } catch (const morph::InputError&) { // what broken files deserve
    }
    return 0;
}
