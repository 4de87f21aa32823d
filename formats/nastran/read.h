#pragma once

#include "formats/format.h"

namespace morph {

/// Read Nastran bulk data: GRID, CTRIA3, CQUAD4 (also CTRIAR, CQUADR), lines (CBAR, CBEAM, CROD, CONROD,
/// CTUBE, PLOTEL) and cells (CTETRA, CPYRAM, CPENTA, CHEXA).
///
/// Elements of each property are a group, and lines of each a marker, by the names of NastranNames; a single
/// property without a name is no group. Other cards are left out and named in a warning.
/// @throws InputError  "path:line: …": a grid point in a coordinate system, an element of higher order, an id
///                     that is unknown or there twice; as surface_of()
MeshData read_nastran(const InputBytes& input);

} // namespace morph
