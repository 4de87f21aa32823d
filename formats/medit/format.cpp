// INRIA's MEDIT format, which mmg speaks: https://github.com/LoicMarechal/libMeshb.
#include "formats/medit/read.h"
#include "formats/medit/solutions.h"
#include "formats/medit/write.h"

namespace morph {

extern const Format medit_format;
const Format medit_format{.name = "medit",
                          .extensions = {".mesh", ".meshb"},
                          .description = "MEDIT, of mmg",
                          .holds = {.surface = true,
                                    .markers = true,
                                    .groups = true,
                                    .vertex_fields = true,
                                    .element_fields = true,
                                    .binary = true,
                                    .volume = true},
                          .read = read_medit,
                          .write = write_medit,
                          .losses = medit_losses,
                          .companions = medit_solutions};

} // namespace morph
