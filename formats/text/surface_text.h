#pragma once

#include "formats/output_file.h"
#include "formats/text/text_scanner.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// What the formats that hold nothing but a surface share (OFF, OBJ, PLY, STL).
///
/// They are read and written here and not by OpenMesh's own modules, because those (9.0) pass every
/// coordinate through single precision, skip what they do not understand without a word, know no line
/// numbers, and take counts in a header on trust.

/// Points from x, y, z, one after another, with the dimension they have.
void set_points(MeshData& mesh, const std::vector<double>& xyz);

/// The corners of a face; @p position in the file is for the message.
/// @throws InputError  "path:line: …": another number of corners than 3 or 4
Element face_element(const TextScanner& scanner, std::size_t position, const std::vector<Index>& corners);

/// Append "v0 v1 v2" or "v0 v1 v2 v3" and a line end, each vertex raised by @p base.
void append_corners(OutputFile& out, const Element& element, Index base);

/// Append "x y z" and a line end as text that reads back to the same numbers.
void append_point(OutputFile& out, const Points& points, Eigen::Index vertex);

} // namespace morph
