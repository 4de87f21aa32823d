#pragma once

#include "tools/case/toml_table.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// [lattice]: a box of control points around what is to be deformed. Control point (i, j, k) is row
/// i + n (j + m k) of every matrix here.
struct LatticeEntry {
    int line = 0;                             ///< in the case file, for messages
    int dimension = 2;                        ///< 2 or 3: how many numbers `points` has
    std::string basis = "bspline";            ///< or "bernstein"
    std::array<int, 3> degree{3, 3, 3};       ///< in the plane the third is 0
    std::array<Index, 3> points{4, 4, 4};     ///< control points along i, j, k; in the plane the third is 1
    std::array<std::vector<double>, 3> knots; ///< empty: uniform clamped

    /// Where the control points are: one of these.
    std::optional<Matrix> corners;        ///< box: 2 x 3, low and high
    std::optional<Matrix> axes;           ///< origin and the edges from it, (1 + dimension) x 3
    std::optional<Matrix> control_points; ///< N x 3
    std::string su2_box;                  ///< tag of an FFD box in the SU2 mesh file

    std::vector<double> weights;       ///< N, empty: all 1
    std::vector<double> moved_weights; ///< N, empty: as before
    Matrix displacements;              ///< N x 3; with su2_box 0 rows until the box is known
    Matrix sparse_displacements;       ///< i, j, k, dx, dy, dz as given
    int continuity = -1;               ///< order of continuity at the faces of the box; -1: none asked for
    std::vector<std::string> markers;  ///< with another method: the markers it moves; empty: all not fixed

    Index count() const { return points[0] * points[1] * points[2]; }
};

/// Read [lattice].
/// @throws InputError  "case.toml:12: what is wrong"
LatticeEntry lattice_entry(const TomlTable& table);

/// Rows i, j, k, dx, dy, dz as a matrix of all control points.
/// @throws InputError  a number beyond the lattice; names the entry
Matrix spread_displacements(const Matrix& sparse, const std::array<Index, 3>& points,
                            const std::string& place);

} // namespace morph::tools
