// STL: triangles, each with its own three corners.
// https://www.fabbers.com/tech/STL_Format
#include "formats/stl/files.h"

namespace morph {

extern const Format stl_format;
const Format stl_format{.name = "stl",
                        .extensions = {".stl"},
                        .description = "STL triangles",
                        .holds = {.surface = true, .groups = true, .quads = false, .binary = true},
                        .read = read_stl,
                        .write = write_stl,
                        .losses = stl_losses};

} // namespace morph
