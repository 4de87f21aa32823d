// Points and nodal fields as comma-separated numbers below a line of names.
#include "formats/format.h"
#include "formats/csv/fields.h"

namespace morph {

namespace {

MeshData read_csv(const InputBytes& file)
{
    return csv_mesh(parse_csv_table(file.bytes, file.path));
}

void write_csv(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    write_csv_nodes(mesh, false, out);
}

} // namespace

extern const Format csv_format;
const Format csv_format{.name = "csv",
                        .extensions = {".csv"},
                        .description = "comma-separated points and nodal fields",
                        .holds = {.surface = true, .vertex_fields = true, .elements = false, .quads = false},
                        .read = read_csv,
                        .write = write_csv};

} // namespace morph
