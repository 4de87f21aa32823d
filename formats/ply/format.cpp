// PLY: rows of vertices, faces and edges with the properties that a header names, as text or binary.
// https://paulbourke.net/dataformats/ply/
#include "formats/ply/files.h"

namespace morph {

extern const Format ply_format;
const Format ply_format{.name = "ply",
                        .extensions = {".ply"},
                        .description = "Polygon File Format",
                        .holds = {.surface = true,
                                  .markers = true,
                                  .groups = true,
                                  .vertex_fields = true,
                                  .element_fields = true,
                                  .binary = true},
                        .read = read_ply,
                        .write = write_ply};

} // namespace morph
