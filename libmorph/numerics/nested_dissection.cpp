#include "libmorph/numerics/nested_dissection.h"

#include "libmorph/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace morph {

namespace {

constexpr Index kLeaf = 16;            // sets of at most so many rows are not cut
constexpr Index kSamples = 1024;       // points that the median of a large set is taken from
constexpr Index kLeastPart = 8;        // a side must have this part of its set: the recursion stays shallow
constexpr Index kSmallestTask = 10000; // sets of fewer rows are not worth a thread

enum Side : unsigned char { left = 0, right = 1, eliminated = 2 };

/// Points whose coordinate is less than @p at are on the left.
struct Cut {
    Eigen::Index axis = 0; ///< which coordinate
    double at = 0;
    Side separator = left;  ///< vertices of this side that see the other are the separator
    double cost = HUGE_VAL; ///< size of the separator for each vertex of the smaller side
};

class Dissector {
public:
    using Node = Dissection::Node;

    Dissector(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where)
        : A_(A), where_(where), side_(where.rows(), left)
    {
        result_.order.resize(side_.size());
        std::iota(result_.order.begin(), result_.order.end(), 0);
    }

    Dissection run()
    {
        std::vector<Set> sets{{0, A_.rows()}};
        for (std::size_t level_begin = 0; level_begin < sets.size();)
            level_begin = cut_level(sets, level_begin);
        parallel_for(sets.size(), 1, [&](std::size_t i, std::size_t) {
            if (sets[i].left < 0)
                dissect(sets[i].begin, sets[i].end, sets[i].nodes);
        });
        emit(sets, 0);
        set_parents();
        return std::move(result_);
    }

private:
    /// Rows order[begin, end), cut in two around a separator [separator, end) or left to one thread.
    struct Set {
        Index begin, end;
        Index separator = 0;
        Index left = -1; // number of the left part in the list, the right one follows it
        std::vector<Node> nodes{};
    };

    /// Cut the large ones of sets[level_begin...] and append their parts; returns where those begin.
    std::size_t cut_level(std::vector<Set>& sets, std::size_t level_begin)
    {
        const std::size_t level_end = sets.size();
        std::vector<std::array<Index, 2>> middles(level_end - level_begin);
        parallel_for(middles.size(), 1, [&](std::size_t i, std::size_t) {
            const Set& set = sets[level_begin + i];
            if (set.end - set.begin > std::max(kSmallestTask, A_.rows() / 32))
                middles[i] = split(set.begin, set.end);
        });
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const Set set = sets[level_begin + i];
            if (middles[i][1] == 0)
                continue;
            sets[level_begin + i].left = static_cast<Index>(sets.size());
            sets[level_begin + i].separator = middles[i][1];
            sets.push_back({set.begin, middles[i][0]});
            sets.push_back({middles[i][0], middles[i][1]});
        }
        return level_end;
    }

    /// Append the nodes of sets[i] to the result, and return the number of the last.
    Index emit(std::vector<Set>& sets, std::size_t i)
    {
        std::vector<Node>& out = result_.nodes;
        Set& set = sets[i];
        if (set.left < 0) {
            const auto offset = static_cast<Index>(out.size());
            for (Node node : set.nodes) {
                for (Index& child : node.children)
                    child += child < 0 ? 0 : offset;
                out.push_back(node);
            }
        } else {
            const Index first = emit(sets, static_cast<std::size_t>(set.left));
            const Index second = emit(sets, static_cast<std::size_t>(set.left) + 1);
            out.push_back({set.separator, set.end, -1, {first, second}});
        }
        return static_cast<Index>(out.size()) - 1;
    }

    void set_parents()
    {
        for (std::size_t i = 0; i < result_.nodes.size(); ++i)
            for (const Index child : result_.nodes[i].children)
                if (child >= 0)
                    result_.nodes[static_cast<std::size_t>(child)].parent = static_cast<Index>(i);
    }

    /// Append the nodes of order[begin, end), and return the number of the last.
    Index dissect(Index begin, Index end, std::vector<Node>& nodes)
    {
        if (end - begin <= kLeaf) {
            nodes.push_back({begin, end});
        } else {
            const auto [middle, separator] = split(begin, end);
            const Index first = dissect(begin, middle, nodes);
            const Index second = dissect(middle, separator, nodes);
            nodes.push_back({separator, end, -1, {first, second}});
        }
        return static_cast<Index>(nodes.size()) - 1;
    }

    /// Arrange order[begin, end) as left part, right part, separator; returns where the last two begin.
    std::array<Index, 2> split(Index begin, Index end)
    {
        Cut best;
        for (Eigen::Index axis = 0; axis < where_.cols(); ++axis) {
            const Cut cut = try_cut(begin, end, axis);
            if (axis == 0 || cut.cost < best.cost)
                best = cut;
        }
        if (best.cost < HUGE_VAL)
            apply(best, begin, end);
        else
            halve(begin, end);
        return arrange(best.separator, begin, end);
    }

    void apply(const Cut& cut, Index begin, Index end)
    {
        for (Index i = begin; i < end; ++i) {
            const Index v = row(i);
            side_[static_cast<std::size_t>(v)] = where_(v, cut.axis) < cut.at ? left : right;
        }
    }

    /// For points that lie on top of each other.
    void halve(Index begin, Index end)
    {
        for (Index i = begin; i < end; ++i)
            side_[static_cast<std::size_t>(row(i))] = i < begin + (end - begin) / 2 ? left : right;
    }

    bool sees(Index v, Side side) const
    {
        const auto r = static_cast<std::size_t>(v);
        for (std::size_t e = A_.start[r]; e < A_.start[r + 1]; ++e)
            if (side_[static_cast<std::size_t>(A_.column[e])] == side)
                return true;
        return false;
    }

    Cut try_cut(Index begin, Index end, Eigen::Index axis)
    {
        Cut cut{axis};
        const Index step = std::max(1, (end - begin) / kSamples);
        std::vector<double> samples;
        for (Index i = begin; i < end; i += step)
            samples.push_back(where_(row(i), axis));
        const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
        std::nth_element(samples.begin(), middle, samples.end());
        cut.at = *middle;
        apply(cut, begin, end);
        std::array<Index, 2> size{}, seeing{};
        for (Index i = begin; i < end; ++i) {
            const Index v = row(i);
            const Side side = side_[static_cast<std::size_t>(v)];
            ++size[static_cast<std::size_t>(side)];
            if (sees(v, side == left ? right : left))
                ++seeing[static_cast<std::size_t>(side)];
        }
        cut.separator = seeing[0] <= seeing[1] ? left : right;
        const Index smaller = std::min(size[0], size[1]);
        if (smaller >= (end - begin) / kLeastPart)
            cut.cost = static_cast<double>(std::min(seeing[0], seeing[1]) + 1) / smaller;
        return cut;
    }

    std::array<Index, 2> arrange(Side thin, Index begin, Index end)
    {
        const Side other = thin == left ? right : left;
        const auto first = result_.order.begin();
        auto separator = std::partition(first + begin, first + end, [&](Index v) {
            return side_[static_cast<std::size_t>(v)] != thin || !sees(v, other);
        });
        const auto middle = std::partition(
            first + begin, separator, [&](Index v) { return side_[static_cast<std::size_t>(v)] == left; });
        for (auto v = separator; v != first + end; ++v)
            side_[static_cast<std::size_t>(*v)] = eliminated;
        return {static_cast<Index>(middle - first), static_cast<Index>(separator - first)};
    }

    Index row(Index position) const { return result_.order[static_cast<std::size_t>(position)]; }

    const SymmetricMatrix& A_;
    const Eigen::Ref<const Matrix>& where_;
    std::vector<Side> side_;
    Dissection result_;
};

} // namespace

Dissection nested_dissection(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where)
{
    return Dissector(A, where).run();
}

} // namespace morph
