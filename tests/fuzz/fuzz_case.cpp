// Any bytes become a checked case, or an InputError.
#include "formats/case/case_file.h"
#include "libmorph/core/error.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    try {
        morph::parse_case_file({reinterpret_cast<const char*>(bytes), size}, "fuzz.toml");
    } catch (const morph::InputError&) { // what broken files deserve
    }
    return 0;
}
