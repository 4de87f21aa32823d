// SU2's restart file as text: https://su2code.github.io/docs_v7/Restart-Files/. SU2 takes its columns by
// their order and passes over further ones at the end.
#include "formats/csv_fields.h"
#include "formats/format.h"
#include "libmorph/core/error.h"

namespace morph {

namespace {

MeshData read_su2_restart(const InputBytes& file)
{
    CsvNodes nodes = csv_nodes(parse_csv_table(file.bytes, file.path));
    if (!nodes.has_ids)
        throw InputError(file.path + ":1: has no column PointID, which every SU2 restart file has");
    return mesh_of(std::move(nodes), file.path);
}

void write_su2_restart(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    write_csv_nodes(mesh, true, out);
}

} // namespace

extern const Format su2_restart_format;
const Format su2_restart_format{.name = "su2_restart",
                                .extensions = {}, // .csv is any table
                                .description = "SU2 restart file as text",
                                .holds = {.surface = true, .vertex_fields = true, .elements = false},
                                .read = read_su2_restart,
                                .write = write_su2_restart};

} // namespace morph
