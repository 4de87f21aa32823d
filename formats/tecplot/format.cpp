// Tecplot's ASCII data files: "Data Format Guide", Tecplot, Inc.
#include "formats/tecplot/mesh.h"
#include "formats/tecplot/read.h"
#include "formats/tecplot/write.h"

namespace morph {

namespace {

MeshData read_tecplot(const InputBytes& input)
{
    TecplotFile file = read_tecplot_file(input);
    input.set_version("ASCII, " + std::to_string(file.zones.size()) + " zone(s)");
    return tecplot_mesh(std::move(file), input);
}

} // namespace

extern const Format tecplot_format;
const Format tecplot_format{.name = "tecplot",
                            .extensions = {".dat", ".plt", ".tec"},
                            .description = "Tecplot ASCII data",
                            .holds = {.surface = true,
                                      .markers = true,
                                      .groups = true,
                                      .vertex_fields = true,
                                      .element_fields = true,
                                      .volume = true},
                            .read = read_tecplot,
                            .write = write_tecplot};

} // namespace morph
