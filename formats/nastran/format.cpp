// Nastran bulk data: "MSC Nastran Quick Reference Guide", Bulk Data Entries.
#include "formats/mesh/element_groups.h"
#include "formats/nastran/read.h"
#include "formats/nastran/write.h"

namespace morph {

extern const Format nastran_format;
const Format nastran_format{
    .name = "nastran",
    .extensions = {".bdf", ".nas"},
    .description = "Nastran bulk data",
    .holds = {.surface = true, .markers = true, .groups = true, .volume = true},
    .read = read_nastran,
    .write = write_nastran,
    .losses = [](const MeshData& mesh, const WriteOptions&) { return overlap_losses(mesh); },
};

} // namespace morph
