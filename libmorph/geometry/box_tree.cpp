#include "libmorph/geometry/box_tree.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

namespace morph {

/// Halves the items from the root down, and encloses them from the leaves up.
class BoxTree::Builder {
public:
    Builder(BoxTree& tree, const std::vector<Box>& boxes, Index leaf_size, int axes)
        : tree_(tree), boxes_(boxes), leaf_size_(leaf_size), axes_(axes)
    {
    }

    void build(std::size_t node, Index begin, Index end)
    {
        if (end - begin <= leaf_size_) {
            tree_.nodes_[node] = {box_of(begin, end), begin, end, 0};
            return;
        }
        const Index middle = axes_ == 0 ? middle_of_run(begin, end) : halve_by_median(begin, end);
        const std::size_t left = tree_.nodes_.size();
        tree_.nodes_.resize(left + 2);
        build(left, begin, middle);
        build(left + 1, middle, end);
        const Box both = tree_.nodes_[left].box.merged(tree_.nodes_[left + 1].box);
        tree_.nodes_[node] = {both, begin, end, static_cast<Index>(left)};
    }

private:
    const Box& box_at(Index rank) const
    {
        return boxes_[static_cast<std::size_t>(tree_.order_[static_cast<std::size_t>(rank)])];
    }

    Box box_of(Index begin, Index end) const
    {
        Box around = box_at(begin);
        for (Index rank = begin + 1; rank < end; ++rank)
            around.extend(box_at(rank));
        return around;
    }

    /// Runs begin at multiples of powers of two, as the cells of a space-filling curve do.
    static Index middle_of_run(Index begin, Index end)
    {
        return begin + static_cast<Index>(std::bit_floor(static_cast<std::uint32_t>(end - begin - 1)));
    }

    Index halve_by_median(Index begin, Index end)
    {
        Eigen::Index axis = 0;
        box_of(begin, end).sizes().head(axes_).maxCoeff(&axis);
        const auto twice_the_middle = [&](Index item) {
            const Box& of_item = boxes_[static_cast<std::size_t>(item)];
            return of_item.min()[axis] + of_item.max()[axis];
        };
        const Index middle = begin + (end - begin) / 2;
        const auto order = tree_.order_.begin();
        std::nth_element(order + begin, order + middle, order + end,
                         [&](Index a, Index b) { return twice_the_middle(a) < twice_the_middle(b); });
        return middle;
    }

    BoxTree& tree_;
    const std::vector<Box>& boxes_;
    Index leaf_size_;
    int axes_;
};

BoxTree::BoxTree(const std::vector<Box>& boxes, Index leaf_size, int axes) : order_(boxes.size())
{
    if (boxes.empty())
        return;
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.resize(1);
    Builder(*this, boxes, leaf_size, axes).build(0, 0, static_cast<Index>(boxes.size()));
}

} // namespace morph
