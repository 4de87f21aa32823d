#pragma once

#include "formats/format.h"

namespace morph {

/// Write Nastran bulk data: GRID in large field, CTRIA3 and CQUAD4 in small, the edges of markers as CROD.
///
/// Each group and each marker has a property of its own, whose name is in a comment. Coordinates with more
/// digits than 16 columns hold are rounded, and a comment behind them has all digits for our reader.
/// @throws InputError  the file cannot be written
void write_nastran(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// The real number in at most 16 columns, with a decimal point, rounded where it must be:
/// ".3333333333333333", "1.-300". Right-aligned in columns 0 to 15 of @p to. False when it was rounded.
bool put_nastran_real(char* to, double value);

} // namespace morph
