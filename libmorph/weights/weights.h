#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph {

/// The control point that a column of the weights belongs to.
struct ControlPoint {
    std::string boundary; ///< name of the boundary or lattice
    Index number = 0;     ///< from 0 within it

    bool operator==(const ControlPoint&) const = default;
};

/// The one idea: every linear method is a matrix of weights from control points to mesh vertices,
/// new positions = old positions + values * displacements. Methods differ in how they fill it.
struct Weights {
    std::vector<ControlPoint> columns; ///< K
    Matrix values;                     ///< n x K, row = vertex of the mesh
};

} // namespace morph
