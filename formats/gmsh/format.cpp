// Gmsh's mesh format: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format
#include "formats/gmsh/read.h"
#include "formats/gmsh/write.h"

namespace morph {

extern const Format gmsh_format;

const Format gmsh_format{
    .name = "gmsh",
    .extensions = {".msh"},
    .description = "Gmsh mesh of version 4.1 (2.2 and 4.0 are read)",
    .holds = {.surface = true,
              .markers = true,
              .groups = true,
              .vertex_fields = true,
              .element_fields = true,
              .binary = true,
              .volume = true},
    .read = read_gmsh,
    .write = write_gmsh,
};

} // namespace morph
