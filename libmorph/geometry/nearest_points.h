#pragma once

#include "libmorph/core/types.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace morph {

/// Finds the nearest of many points: FLANN's k-d tree, which is exact [Muja & Lowe 2009, VISAPP 1, 331-340].
///
/// Built in O(n log n), a query for k points costs about O(k log n). Queries may run in several threads.
class NearestPoints {
public:
    struct Neighbor {
        Index point = 0;     ///< row in the points given
        double distance = 0; ///< length unit of the points
    };

    /// @param points  n x 3, n at least 1; copied
    /// @throws InputError  there is no point, or a coordinate is not finite (names the row)
    explicit NearestPoints(const Eigen::Ref<const Points>& points);
    ~NearestPoints();
    NearestPoints(const NearestPoints&) = delete;
    NearestPoints& operator=(const NearestPoints&) = delete;

    using Visit = std::function<void(Index query, std::span<const Neighbor> neighbors)>;

    /// Call visit with the k nearest points of each query (all of them when there are fewer), nearest first,
    /// equally near ones by their row: the first k of that order, at the k-th place too. Distances below
    /// 1e-150 of the largest coordinate count as none.
    ///
    /// Queries are handled in blocks on every core, so that no more than a block's neighbours are in memory,
    /// and visit is called from several threads, each query once.
    /// @param queries  q x 3; along a space-filling curve they are faster
    /// @param k        at least 1
    /// @throws InputError  k below 1; a query that is not finite, or 1e150 times as far out as the points
    void nearest(const Eigen::Ref<const Points>& queries, int k, const Visit& visit) const;

private:
    class Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace morph
