// SU2's native mesh format: https://su2code.github.io/docs_v7/Mesh-File/
#include "formats/su2/read.h"
#include "formats/su2/write.h"

namespace morph {

extern const Format su2_format;

const Format su2_format{
    .name = "su2",
    .extensions = {".su2"},
    .description = "SU2 mesh",
    .holds = {.surface = true, .markers = true, .groups = true, .volume = true},
    .read = read_su2,
    .write = write_su2,
};

} // namespace morph
