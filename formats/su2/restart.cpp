// SU2's restart file as text: https://su2code.github.io/docs_v7/Restart-File/. SU2 (7 and 8) passes over
// PointID and takes row i for vertex i and the columns by their order, so that further ones at the end do no
// harm; the few names it looks for it expects in quotes.
#include "formats/csv/fields.h"
#include "formats/format.h"
#include "libmorph/core/error.h"

namespace morph {

namespace {

MeshData read_su2_restart(const InputBytes& file)
{
    const CsvTable table = parse_csv_table(file.bytes, file.path);
    if (!find_csv_column(table, "PointID"))
        throw InputError(file.path + ":" + std::to_string(table.header_line) +
                         ": has no column PointID, which every SU2 restart file has");
    return csv_mesh(table);
}

void write_su2_restart(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    write_csv_nodes(mesh, true, out);
}

} // namespace

extern const Format su2_restart_format;
const Format su2_restart_format{
    .name = "su2_restart",
    .extensions = {}, // .csv is any table
    .description = "SU2 restart file as text",
    .holds = {.surface = true, .vertex_fields = true, .elements = false, .quads = false},
    .read = read_su2_restart,
    .write = write_su2_restart};

} // namespace morph
