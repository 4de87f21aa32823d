#pragma once

#include "libmorph/basis/lattice.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// A box along the axes.
struct LatticeBox {
    Eigen::Vector3d low = Eigen::Vector3d::Zero(); ///< z does not count in the plane
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
};

/// A box turned or sheared at will.
struct LatticeAxes {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();

    /// Columns: the sides of the box along i, j, k; the third does not count in the plane.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// A lattice of free-form deformation around what is to be deformed. Control point (i, j, k) is row
/// i + points[0] (j + points[1] k) of every matrix here.
struct LatticeSettings {
    std::string where = {}; ///< in front of messages about it: "case.toml:12: "

    /// By default planar; its control points do not count when there is a box or axes.
    LatticeDefinition shape = {.dimension = 2, .degree = {3, 3, 0}, .points = {4, 4, 1}};

    std::optional<LatticeBox> box = {};
    std::optional<LatticeAxes> axes = {};
    Matrix displacements = {};              ///< N x 2 or N x 3, length unit of the mesh; empty: zero
    std::vector<double> moved_weights = {}; ///< N, of the moved lattice; empty: as before the move

    /// Order of continuity at the faces of the box, which holds control points; -1: none.
    int continuity = -1;

    /// With a method other than ffd: those that the lattice moves; empty: all not fixed.
    std::vector<std::string> markers = {};
};

/// The lattice before the move.
/// @throws InputError  as Lattice, lattice_in_box() and lattice_on_axes(); names [lattice]
Lattice make_lattice(const LatticeSettings& settings);

} // namespace morph
