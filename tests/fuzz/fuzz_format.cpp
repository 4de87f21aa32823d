// Any bytes become a mesh and flat arrays again, or an InputError. The format is that in the program's name:
// fuzz_su2 reads SU2.
#include "formats/format.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace {

const morph::Format* format = nullptr;

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments)
{
    const std::string program = std::filesystem::path((*arguments)[0]).filename().string();
    format = &morph::find_format("", program.substr(std::string_view("fuzz_").size()));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    try {
        morph::MeshData data = format->read({"fuzz", {reinterpret_cast<const char*>(bytes), size}});
        morph::to_mesh_data(morph::build_mesh(std::move(data)));
    } catch (const morph::InputError&) { // what broken files deserve
    }
    return 0;
}
