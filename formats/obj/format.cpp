// Wavefront OBJ: vertices, faces and lines, sorted by groups, objects and materials.
// https://paulbourke.net/dataformats/obj/
#include "formats/obj/files.h"

namespace morph {

extern const Format obj_format;
const Format obj_format{.name = "obj",
                        .extensions = {".obj"},
                        .description = "Wavefront OBJ",
                        .holds = {.surface = true, .markers = true, .groups = true, .vertex_fields = true},
                        .read = read_obj,
                        .write = write_obj,
                        .losses = obj_losses};

} // namespace morph
