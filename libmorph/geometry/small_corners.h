#pragma once

#include "libmorph/geometry/outline.h"

#include <vector>

namespace morph {

/// Where a vertex lies among the original nodes of its loop: 2i is node i, 2i + 1 the edge after it.
struct BoundaryPlace {
    Index value = -1; ///< -1: on no loop

    static BoundaryPlace at_node(std::size_t i) { return {static_cast<Index>(2 * i)}; }

    /// Place of a vertex put between two that are neighbours, the first one earlier on the loop.
    static BoundaryPlace between(BoundaryPlace from, BoundaryPlace to)
    {
        if (from.value % 2 == 1)
            return from;
        return {to.value % 2 == 1 ? to.value : from.value + 1};
    }
};

/// The nodes of loops where the domain has an angle below kSmallCorner.
class SmallCorners {
public:
    explicit SmallCorners(const std::vector<OutlineLoop>& loops);

    bool is_small(Index loop, BoundaryPlace place) const;

    /// The two places lie on the two edges that meet in a small corner, one on each (ends included).
    bool between(Index loop, BoundaryPlace a, BoundaryPlace b) const;

    /// Discs within which angles may be smaller than elsewhere: around each small corner, the size of
    /// its edges.
    struct Disc {
        Eigen::Vector2d centre;
        double radius = 0;
    };
    const std::vector<Disc>& discs() const { return discs_; }

private:
    std::vector<std::vector<bool>> small_; ///< by loop and node
    std::vector<Disc> discs_;
};

} // namespace morph
