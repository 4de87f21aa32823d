// Any bytes become a table of finite numbers, or an InputError.
#include "formats/csv/table.h"
#include "libmorph/core/error.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    try {
        const morph::CsvTable table =
            morph::parse_csv_table({reinterpret_cast<const char*>(bytes), size}, "fuzz.csv");
        if (!table.rows.allFinite())
            std::abort();
    } catch (const morph::InputError&) { // what broken files deserve
    }
    return 0;
}
