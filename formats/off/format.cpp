// Geomview's Object File Format: a header, counts, a line for each vertex and for each face.
// http://www.geomview.org/docs/html/OFF.html
#include "formats/off/files.h"

namespace morph {

extern const Format off_format;
const Format off_format{.name = "off",
                        .extensions = {".off"},
                        .description = "Geomview Object File Format",
                        .holds = {.surface = true, .vertex_fields = true},
                        .read = read_off,
                        .write = write_off,
                        .losses = off_losses};

} // namespace morph
