#pragma once

#include "libmorph/basis/lattice.h"
#include "libmorph/geometry/box_tree.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace morph {

/// A cell of the net of control points in which the map of a lattice turns over: its Jacobian changes sign.
struct FoldedCell {
    std::array<Index, 3>
        cell; ///< (i, j, k) of its first control point; the cell reaches to (i + 1, j + 1, k + 1)
    Eigen::Vector3d
        parameters; ///< a place in it where the Jacobian has the sign that most of the lattice has not
};

/// The image of a lattice cut into parts on which Newton's method cannot fail, and a tree of their boxes.
///
/// Each span of the lattice is halved in every direction, as in the quadtree of the thesis [Tavla 2021, 2.2],
/// until its Jacobian differs little from that in its middle. The difference is bounded by the Bernstein
/// coefficients of the part, so that nothing is missed between samples.
class LatticeTree {
public:
    /// ||J(middle)^-1 J(u) - I|| is at most this throughout a sure part (largest sum of a row, the part's
    /// sides as units). Then S is one-to-one there, and Newton's iteration, kept within the part, approaches
    /// the solution in every step: with the factor 2 q / (1 - q) < 1 to begin with, and soon quadratically.
    static constexpr double kVariation = 0.3;

    struct Part {
        std::array<int, 3> span{}; ///< of each direction
        Eigen::Vector3d low, high; ///< parameters
        Eigen::Vector3d middle;    ///< S in the middle of them
        Eigen::Matrix3d inverse;   ///< of the Jacobian in the middle
        bool sure = false;         ///< false: the map is folded or nearly singular here
    };

    explicit LatticeTree(const Lattice& lattice);

    const Lattice& lattice() const { return lattice_; }
    const std::vector<Part>& parts() const { return parts_; }

    /// Where the lattice is folded, ordered by the rows of the control points. Empty: S is one-to-one near
    /// every point (parts of the image far apart in the parameters may still overlap).
    const std::vector<FoldedCell>& folded_cells() const { return folded_; }

    /// How far outside the box of a part a point may be and still count as on its boundary: rounding, and
    /// 1e-14 of the size of the lattice.
    double margin() const { return margin_; }

    bool may_hold(Index part, const Eigen::Vector3d& x) const
    {
        return boxes_[static_cast<std::size_t>(part)].contains(x);
    }

    /// Call try_part(number) for the parts whose boxes hold @p x until it returns true.
    template <typename TryPart>
    bool find(const Eigen::Vector3d& x, const TryPart& try_part) const
    {
        return tree_.find(x, try_part);
    }

private:
    class Builder;

    Lattice lattice_;
    double margin_ = 0;
    std::vector<Part> parts_;         ///< those of a halved part one after another
    std::vector<BoxTree::Box> boxes_; ///< of the parts
    BoxTree tree_;
    std::vector<FoldedCell> folded_;
};

} // namespace morph
