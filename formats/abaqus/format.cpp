// Abaqus input files: "Abaqus Keywords Reference Guide" and "Abaqus Elements Guide".
#include "formats/abaqus/model.h"
#include "formats/abaqus/write.h"

namespace morph {

namespace {

/// Triangles, quads and lines, the surface of linear cells.
///
/// A set of elements is a group of its triangles and quads and a marker of its lines; a surface is a marker
/// of edges (S1 of CPS4, E1 of S4) or a group of faces; a set of nodes is a marker where boundary edges make
/// it up.
MeshData read_abaqus(const InputBytes& input)
{
    return abaqus_mesh(read_abaqus_model(input), input);
}

} // namespace

extern const Format abaqus_format;
const Format abaqus_format{.name = "abaqus",
                           .extensions = {".inp"},
                           .description = "Abaqus input file",
                           .holds = {.surface = true, .markers = true, .groups = true, .volume = true},
                           .read = read_abaqus,
                           .write = write_abaqus};

} // namespace morph
