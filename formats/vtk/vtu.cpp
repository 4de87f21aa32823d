// VTK XML unstructured grids.
#include "formats/vtk/xml.h"

namespace morph {

extern const Format vtu_format;
const Format vtu_format{
    "vtu",
    {".vtu"},
    "VTK XML unstructured grid",
    {.surface = true,
     .markers = true,
     .groups = true,
     .vertex_fields = true,
     .element_fields = true,
     .binary = true,
     .compressed = true,
     .volume = true},
    [](const InputBytes& file) { return read_vtk_xml(file, VtkXmlKind::unstructured_grid); },
    [](const MeshData& mesh, const WriteOptions& options, OutputFile& file) {
        write_vtk_xml(mesh, VtkXmlKind::unstructured_grid, options, file);
    }};

} // namespace morph
