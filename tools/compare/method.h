#pragma once

#include "tools/deform/moved_case.h"

#include <string>
#include <vector>

namespace morph::tools {

/// A mesh that some method has moved, and what that took.
struct MovedMesh {
    Points positions;              ///< n x 3
    Index control_variables = 0;   ///< numbers that an optimiser would set
    double weights_seconds = 0;    ///< once for a mesh
    double move_seconds = 0;       ///< for every move
    std::size_t weights_bytes = 0; ///< what is kept between moves
};

/// One way of making the boundary move of a case.
struct CompareMethod {
    std::string name;
    std::string description; ///< a few words for --help
    MovedMesh (*move)(const Mesh& mesh, const PlacedCase& placed, const CaseFile& file);
};

/// Every method, in the order of the table in the source; a new one is one more row there.
const std::vector<CompareMethod>& compare_methods();

/// @throws InputError  no such method; names the nearest
const CompareMethod& compare_method(const std::string& name);

} // namespace morph::tools
