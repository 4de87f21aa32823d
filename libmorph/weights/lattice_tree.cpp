#include "libmorph/weights/lattice_tree.h"

#include "libmorph/core/parallel.h"
#include "libmorph/weights/lattice_piece.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace morph {

namespace {

// Halvings of a span after which a part is left unsure, and parts in all: along a fold there are as many as a
// curve or a surface takes that is cut as finely.
constexpr int kDeepestInPlane = 12;
constexpr int kDeepestInSpace = 8;
constexpr std::size_t kMostParts = 200'000;

constexpr std::size_t kRowsPerBlock = 64; // parts

// Relative to the sides of the Jacobian: determinants that rounding decides on.
constexpr double kFlat = 1e-12;

constexpr double kOnBoundary = 1e-14;

/// The determinant as a part of what the sides could hold, in [-1, 1].
double relative_determinant(const Eigen::Matrix3d& J)
{
    const double sides = J.colwise().norm().prod();
    return sides > 0 ? J.determinant() / sides : 0;
}

/// Last control point of a direction, but one, whose Greville abscissa is at most u.
Index cell_along(const SplineAxis& axis, double u)
{
    Index i = 0;
    while (i + 2 < axis.point_count() && axis.greville(i + 1) <= u)
        ++i;
    return i;
}

} // namespace

/// Cuts the lattice level by level, so that what there is room for goes to all of it alike.
class LatticeTree::Builder {
public:
    explicit Builder(LatticeTree& tree) : tree_(tree), lattice_(tree.lattice_)
    {
        for (int d = 0; d < 3; ++d)
            spans_[static_cast<std::size_t>(d)] = lattice_.axis(d).spans();
    }

    void build()
    {
        tree_.nodes_.emplace_back();
        add_spans(0, {Range{0, spans_[0].size()}, Range{0, spans_[1].size()}, Range{0, spans_[2].size()}});
        const int deepest = lattice_.dimension() == 2 ? kDeepestInPlane : kDeepestInSpace;
        for (int depth = 0; !tasks_.empty(); ++depth)
            cut_level(depth < deepest);
        enclose_children();
        name_folds();
    }

private:
    using Range = std::pair<std::size_t, std::size_t>; ///< first and behind the last of some spans

    /// A part to look at, and the node it will be.
    struct Task {
        Index node = 0;
        std::array<int, 3> span{};
        Eigen::Vector3d low, high;
    };

    /// A place of a part and the relative determinant there.
    struct Sample {
        Eigen::Vector3d parameters;
        double determinant;
    };

    struct Found {
        Part part;
        Eigen::AlignedBox3d box;
        double determinant = 0;
        std::vector<Sample> samples; ///< what tells whether it is folded
    };

    void add_spans(Index node, const std::array<Range, 3>& range)
    {
        std::vector<std::array<Range, 3>> parts{range};
        for (std::size_t d = 0; d < 3; ++d) {
            if (range[d].second - range[d].first < 2)
                continue;
            const std::size_t middle = (range[d].first + range[d].second) / 2;
            const std::size_t count = parts.size();
            for (std::size_t i = 0; i < count; ++i) {
                parts.push_back(parts[i]);
                parts[i][d].second = middle;
                parts.back()[d].first = middle;
            }
        }
        if (parts.size() == 1) {
            tasks_.push_back(whole_span(node, range));
            return;
        }
        const Index first = make_children(node, parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            add_spans(first + static_cast<Index>(i), parts[i]);
    }

    Task whole_span(Index node, const std::array<Range, 3>& range) const
    {
        Task task;
        task.node = node;
        for (std::size_t d = 0; d < 3; ++d) {
            task.span[d] = spans_[d][range[d].first];
            const auto knot = lattice_.axis(static_cast<int>(d)).knots().begin() + task.span[d];
            task.low[static_cast<int>(d)] = knot[0];
            task.high[static_cast<int>(d)] = knot[1];
        }
        return task;
    }

    void cut_level(bool may_cut)
    {
        std::vector<Found> found(tasks_.size());
        parallel_for(tasks_.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                found[i] = look_at(tasks_[i]);
        });
        const auto unsure = static_cast<std::size_t>(
            std::count_if(found.begin(), found.end(), [](const Found& f) { return !f.part.sure; }));
        const std::size_t halves = std::size_t{1} << lattice_.dimension();
        may_cut = may_cut && tree_.parts_.size() + unsure * halves <= kMostParts;
        std::vector<Task> finer;
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            if (may_cut && !found[i].part.sure)
                add_halves(tasks_[i], halves, finer);
            else
                add_part(tasks_[i].node, std::move(found[i]));
        }
        tasks_ = std::move(finer);
    }

    Found look_at(const Task& task) const
    {
        const LatticePiece piece(lattice_, task.span, task.low, task.high);
        const Eigen::Vector3d u = 0.5 * (task.low + task.high);
        const Eigen::Matrix3d J = lattice_.jacobian(u);
        Found found;
        found.part = {task.span, task.low, task.high, lattice_.point(u), J.inverse(), false};
        found.part.sure = piece.variation(found.part.middle, found.part.inverse) <= kVariation;
        found.box = piece.box();
        found.determinant = J.determinant();
        found.samples.push_back({u, relative_determinant(J)});
        if (!found.part.sure)
            add_corners(piece, task, found.samples);
        return found;
    }

    static void add_corners(const LatticePiece& piece, const Task& task, std::vector<Sample>& samples)
    {
        const std::vector<Eigen::Matrix3d> corners = piece.corner_jacobians();
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            Eigen::Vector3d u = task.low;
            for (int d = 0; d < 3; ++d)
                if ((corner >> d) % 2 == 1)
                    u[d] = task.high[d];
            samples.push_back({u, relative_determinant(corners[corner])});
        }
    }

    void add_halves(const Task& whole, std::size_t count, std::vector<Task>& finer)
    {
        const Index first = make_children(whole.node, count);
        for (std::size_t half = 0; half < count; ++half) {
            Task task = whole;
            task.node = first + static_cast<Index>(half);
            for (int d = 0; d < lattice_.dimension(); ++d)
                ((half >> d) % 2 == 0 ? task.high : task.low)[d] = 0.5 * (whole.low[d] + whole.high[d]);
            finer.push_back(task);
        }
    }

    void add_part(Index node, Found found)
    {
        found.box.min().array() -= tree_.margin_;
        found.box.max().array() += tree_.margin_;
        volume_ += (found.part.high - found.part.low).prod() * found.determinant;
        Node& leaf = tree_.nodes_[static_cast<std::size_t>(node)];
        leaf.box = found.box;
        leaf.first = static_cast<Index>(tree_.parts_.size());
        tree_.parts_.push_back(found.part);
        tree_.boxes_.push_back(found.box);
        samples_.insert(samples_.end(), found.samples.begin(), found.samples.end());
    }

    Index make_children(Index node, std::size_t count)
    {
        const auto first = static_cast<Index>(tree_.nodes_.size());
        tree_.nodes_.resize(tree_.nodes_.size() + count);
        tree_.nodes_[static_cast<std::size_t>(node)].first = first;
        tree_.nodes_[static_cast<std::size_t>(node)].children = static_cast<Index>(count);
        return first;
    }

    /// Children come behind their parents.
    void enclose_children()
    {
        for (auto node = tree_.nodes_.rbegin(); node != tree_.nodes_.rend(); ++node)
            for (Index child = 0; child < node->children; ++child)
                node->box.extend(tree_.nodes_[static_cast<std::size_t>(node->first + child)].box);
    }

    void name_folds()
    {
        std::map<Index, FoldedCell> found;
        for (const auto& [u, determinant] : samples_) {
            if ((volume_ < 0 ? -determinant : determinant) >= -kFlat)
                continue;
            const std::array<Index, 3> cell = {cell_along(lattice_.axis(0), u[0]),
                                               cell_along(lattice_.axis(1), u[1]),
                                               cell_along(lattice_.axis(2), u[2])};
            found.try_emplace(lattice_.row_of(cell[0], cell[1], cell[2]), FoldedCell{cell, u});
        }
        for (const auto& [row, cell] : found)
            tree_.folded_.push_back(cell);
    }

    LatticeTree& tree_;
    const Lattice& lattice_;
    std::array<std::vector<int>, 3> spans_; ///< along i, j, k
    std::vector<Task> tasks_;               ///< of the level that is next
    std::vector<Sample> samples_;
    double volume_ = 0; ///< of the image, to a sign
};

LatticeTree::LatticeTree(const Lattice& lattice) : lattice_(lattice)
{
    const double farthest = lattice.definition().control_points.cwiseAbs().maxCoeff();
    margin_ = kOnBoundary * lattice.size() + 4 * std::numeric_limits<double>::epsilon() * farthest;
    Builder(*this).build();
}

} // namespace morph
