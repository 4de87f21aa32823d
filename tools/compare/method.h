#pragma once

#include "formats/case/case_file.h"
#include "libmorph/pipeline/placement.h"

#include <functional>
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
    std::function<MovedMesh(const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file)> move;
};

/// Every method, in the order of the table in the source; a new one is one more row there.
const std::vector<CompareMethod>& compare_methods();

/// The method of that name; "NAME+untangle" repairs the elements that NAME leaves inverted.
/// @throws InputError  no such method; names the nearest
CompareMethod compare_method(const std::string& name);

} // namespace morph::tools
