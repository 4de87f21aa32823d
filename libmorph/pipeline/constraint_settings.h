#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// The name that control points of the lattice have in the place of a boundary's.
inline constexpr const char* kLatticeName = "lattice";

/// Control points of a boundary or lattice that get the same displacement.
struct TieSettings {
    std::string where = {};                        ///< in front of messages about it: "case.toml:12: "
    std::string boundary = {};                     ///< or kLatticeName
    std::vector<std::array<Index, 3>> points = {}; ///< boundary: {number, 0, 0}, from 0; lattice: {i, j, k}
};

/// Control points of a boundary or lattice that mirror each other in a line, or a plane in space.
struct MirrorSettings {
    std::string where = {};
    std::string boundary = {};                    ///< or kLatticeName
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< a point of the mirror
    Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
};

/// Thickness of a closed boundary along the lines x = at.
struct ThicknessSettings {
    std::string where = {};
    std::string boundary = {};
    std::vector<double> at = {}; ///< x of the stations, length unit of the mesh
    bool at_least = false;       ///< else equal
    double value = 0;            ///< above 0
    bool relative = false;       ///< value is a part of the thickness before the move; else a length
};

/// What the move must keep.
struct ConstraintSettings {
    std::string where = {};
    std::vector<std::string> area = {};     ///< boundaries whose inside keeps its area
    std::vector<Index> fixed_vertices = {}; ///< file numbers
    Matrix fixed_points = {};               ///< m x 3: the vertices nearest to them stay; may be empty
    std::vector<ThicknessSettings> thicknesses = {};
    std::vector<TieSettings> ties = {};
    std::vector<MirrorSettings> mirrors = {};
};

} // namespace morph
