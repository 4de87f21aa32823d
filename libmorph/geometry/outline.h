#pragma once

#include "libmorph/geometry/mesh_domain.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace morph {

/// A node of a boundary loop.
struct OutlineNode {
    double u = 0;
    Eigen::Vector2d point;
};

/// A closed boundary of a domain: the curve and the nodes on it so far.
struct OutlineLoop {
    std::string name;
    double period = 1; ///< u runs over [0, period)
    std::function<Eigen::Vector2d(double)> point_at;
    std::vector<OutlineNode> nodes; ///< in order of u
    bool counter_clockwise = true;  ///< as u increases
    bool is_box = false;

    /// The node halfway in u from node @p i to the one after it.
    OutlineNode middle(std::size_t i) const;
};

/// A node at @p u, taken modulo the period.
OutlineNode node_at(const OutlineLoop& loop, double u);

/// The boundaries of a domain as polygons whose nodes lie on them, curves first, the box last.
///
/// To the nodes of the spec some are added where chord and curve are so far apart that the polygons
/// would cross or touch though the curves do not. The box has its four corners only.
///
/// @throws InputError  as mesh_domain() for everything but the number of vertices
std::vector<OutlineLoop> make_outline(const DomainSpec& spec);

} // namespace morph
