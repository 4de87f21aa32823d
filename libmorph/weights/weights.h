#pragma once

#include "libmorph/mesh/mesh.h"

#include <Eigen/SparseCore>

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

/// The same where a vertex follows few of the control points, as in a lattice of B-splines: only weights that
/// are not zero are stored.
struct SparseWeights {
    std::vector<ControlPoint> columns;                          ///< K
    Eigen::SparseMatrix<double, Eigen::RowMajor, Index> values; ///< n x K, row = vertex of the mesh
};

} // namespace morph
