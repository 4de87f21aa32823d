#pragma once

#include "tools/case/toml_table.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// Which control points an entry speaks of.
struct ControlPointList {
    int line = 0;                             ///< in the case file, for messages
    std::string boundary;                     ///< or "lattice"
    std::vector<std::array<Index, 3>> points; ///< boundary: {number, 0, 0}, from 0; lattice: {i, j, k}
};

/// Control points of a boundary or lattice that mirror each other in a line, or a plane in space.
struct MirrorEntry {
    int line = 0;
    std::string boundary;                         ///< or "lattice"
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< a point of the mirror
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// Thickness of a closed boundary along the lines x = at.
struct ThicknessEntry {
    int line = 0;
    std::string boundary;
    std::vector<double> at; ///< x of the stations
    bool at_least = false;  ///< else equal
    double value = 0;
    bool relative = false; ///< value is a part of the thickness before the move; else a length
};

/// [constraints]: what the move must keep.
struct ConstraintsEntry {
    int line = 0;
    std::vector<std::string> area; ///< boundaries whose inside keeps its area
    std::vector<Index> fixed_vertices;
    Matrix fixed_points; ///< m x 3: the vertices nearest to them stay
    std::vector<ThicknessEntry> thicknesses;
    std::vector<ControlPointList> ties;
    std::vector<MirrorEntry> mirrors;
};

/// Read [constraints].
/// @throws InputError  "case.toml:12: what is wrong"
ConstraintsEntry constraints_entry(const TomlTable& table);

} // namespace morph::tools
