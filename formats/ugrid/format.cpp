// UGRID, the format of AFLR and FUN3D:
// https://www.simcenter.msstate.edu/software/documentation/ug_io/3d_grid_file_type_ugrid.html
#include "formats/ugrid/names.h"
#include "formats/ugrid/read.h"
#include "formats/ugrid/write.h"

namespace morph {

extern const Format ugrid_format;
const Format ugrid_format{.name = "ugrid",
                          .extensions = {".ugrid"},
                          .description = "UGRID, of AFLR and FUN3D",
                          .holds = {.surface = true, .groups = true, .binary = true, .volume = true},
                          .read = read_ugrid,
                          .write = write_ugrid,
                          .losses = ugrid_losses,
                          .companions = ugrid_names};

} // namespace morph
