// VTK XML poly data: elements as polygons, markers as lines.
#include "formats/vtk/xml.h"

namespace morph {

extern const Format vtp_format;
const Format vtp_format{"vtp",
                        {".vtp"},
                        "VTK XML poly data",
                        {.surface = true,
                         .markers = true,
                         .groups = true,
                         .vertex_fields = true,
                         .element_fields = true,
                         .binary = true,
                         .compressed = true},
                        [](const InputBytes& file) { return read_vtk_xml(file, VtkXmlKind::poly_data); },
                        [](const MeshData& mesh, const WriteOptions& options, OutputFile& file) {
                            write_vtk_xml(mesh, VtkXmlKind::poly_data, options, file);
                        }};

} // namespace morph
