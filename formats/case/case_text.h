#pragma once

#include "libmorph/basis/curve.h"

#include <string>
#include <utility>
#include <vector>

namespace morph {

/// One [[boundary]] of a case file to be written, with what a reader should know of it.
struct BoundaryText {
    std::string name;
    CurveDefinition curve;
    std::string note; ///< one line on how the curve came about

    /// A few words next to single control points: {row, words}.
    std::vector<std::pair<Index, std::string>> point_notes;
};

/// A case file in TOML, its control points in place and its displacements all zero, ready to edit.
///
/// Each choice has a comment; numbers read back as the same bits.
/// @param tool         that made it, for the first line
/// @param mesh_file    relative to the case file
/// @param output_mesh  relative to the case file
std::string case_text(const std::string& tool, const std::string& mesh_file, const std::string& output_mesh,
                      const std::vector<BoundaryText>& boundaries);

/// A TOML string with its quotes.
std::string toml_string(const std::string& text);

} // namespace morph
