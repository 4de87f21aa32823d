#pragma once

#include "formats/binary/number_array.h"
#include "formats/text/text_scanner.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// One value of each row of an element: a number, or a list of them after its length.
struct PlyProperty {
    std::string name;
    NumberType type = NumberType::float32;
    std::optional<NumberType> length_type; ///< of a list
};

/// A table of rows: "vertex", "face" or something else.
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyCoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyCoding coding = PlyCoding::ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments; ///< each without the word "comment"
};

/// Read the header; the scanner then stands at the first byte behind its last line.
/// @throws InputError  "path:line: …"; also when an element has more rows than the rest of the file
///                     has bytes for
PlyHeader read_ply_header(TextScanner& in);

} // namespace morph
