// OpenMesh's own binary format: https://www.graphics.rwth-aachen.de/media/openmesh_static/Documentations/
#include "formats/om_files.h"

namespace morph {

extern const Format om_format;
const Format om_format{.name = "om",
                       .extensions = {".om"},
                       .description = "OpenMesh",
                       .holds = {.surface = true,
                                 .markers = true,
                                 .groups = true,
                                 .vertex_fields = true,
                                 .element_fields = true,
                                 .ascii = false,
                                 .binary = true},
                       .read = read_om,
                       .write = write_om};

} // namespace morph
