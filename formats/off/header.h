#pragma once

#include "formats/text/text_scanner.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// The first word of an OFF file: what stands behind the coordinates of a vertex, in this order.
struct OffHeader {
    bool normal = false;  ///< N: 3 numbers
    bool color = false;   ///< C: red, green, blue, mostly alpha; in text also a number of a table
    bool texture = false; ///< ST: 2 numbers
    bool binary = false;  ///< " BINARY" behind the word
};

/// The scanner then stands behind the header.
/// @throws InputError  "path:line: …": another word
OffHeader read_off_header(TextScanner& in);

/// Make the fields that @p header announces from @p width numbers of each vertex; false, and no fields, when
/// the numbers are not as many.
bool add_off_fields(const OffHeader& header, const std::vector<double>& numbers, std::size_t width,
                    MeshData& mesh);

} // namespace morph
