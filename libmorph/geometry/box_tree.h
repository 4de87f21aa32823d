#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace morph {

/// A binary tree of bounding boxes around items that the caller keeps: finds the item of least distance, or of
/// any value with a lower bound on a box, and the items around a point. Planar items have boxes with z = 0.
///
/// The tree knows an item by its rank: its place in order(). Every search visits items in the same sequence,
/// so that the answer among equals is the same on every machine.
class BoxTree {
public:
    using Box = Eigen::AlignedBox3d;

    /// An item and its value.
    struct Candidate {
        Index rank = -1;
        double value = std::numeric_limits<double>::infinity();
    };

    BoxTree() = default;

    /// @param boxes      one for each item, none of them empty; there may be no item
    /// @param leaf_size  this many items or fewer are not halved, at least 1
    /// @param axes       items are halved at the median of their middles along the longest of the first so
    ///                   many axes; with 0 they stay in the order given and runs of them are halved, which
    ///                   suits items numbered along a space-filling curve
    BoxTree(const std::vector<Box>& boxes, Index leaf_size, int axes);

    /// The items, each by its row in the boxes given, as they follow each other in the leaves.
    const std::vector<Index>& order() const { return order_; }

    /// The item of least value, found by branch and bound, the box of lower bound first.
    /// @param bound  bound(box): no item in the box has a smaller value
    /// @param value  value(rank)
    /// @param best   what an item must be less than; returned when none is
    template <typename Bound, typename Value>
    Candidate least(const Bound& bound, const Value& value, Candidate best) const
    {
        if (!nodes_.empty() && bound(nodes_[0].box) < best.value)
            improve(nodes_[0], bound, value, best);
        return best;
    }

    /// The same of all items.
    template <typename Bound, typename Value>
    Candidate least(const Bound& bound, const Value& value) const
    {
        return least(bound, value, Candidate());
    }

    /// Call try_item(rank) for the items of the leaves whose boxes hold @p x, by rank, until it returns true.
    template <typename TryItem>
    bool find(const Eigen::Vector3d& x, const TryItem& try_item) const
    {
        return !nodes_.empty() && find_below(nodes_[0], x, try_item);
    }

private:
    /// The items of ranks [begin, end); a branch has its children at left and left + 1, a leaf 0 there.
    struct Node {
        Box box;
        Index begin = 0, end = 0;
        Index left = 0;
    };

    class Builder;

    const Node& child(const Node& branch, std::size_t k) const
    {
        return nodes_[static_cast<std::size_t>(branch.left) + k];
    }

    template <typename Bound, typename Value>
    void improve(const Node& node, const Bound& bound, const Value& value, Candidate& best) const
    {
        if (node.left == 0) {
            for (Index rank = node.begin; rank < node.end; ++rank)
                if (const double here = value(rank); here < best.value)
                    best = {rank, here};
            return;
        }
        std::pair<const Node*, double> near{&child(node, 0), bound(child(node, 0).box)};
        std::pair<const Node*, double> far{&child(node, 1), bound(child(node, 1).box)};
        if (far.second < near.second)
            std::swap(near, far);
        if (near.second < best.value)
            improve(*near.first, bound, value, best);
        if (far.second < best.value)
            improve(*far.first, bound, value, best);
    }

    template <typename TryItem>
    bool find_below(const Node& node, const Eigen::Vector3d& x, const TryItem& try_item) const
    {
        if (!node.box.contains(x))
            return false;
        if (node.left != 0)
            return find_below(child(node, 0), x, try_item) || find_below(child(node, 1), x, try_item);
        for (Index rank = node.begin; rank < node.end; ++rank)
            if (try_item(rank))
                return true;
        return false;
    }

    std::vector<Index> order_;
    std::vector<Node> nodes_;
};

} // namespace morph
