#include "libmorph/weights/lattice_tree.h"

#include "libmorph/core/parallel.h"
#include "libmorph/weights/lattice_piece.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <type_traits>
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
        add_spans({Range{0, spans_[0].size()}, Range{0, spans_[1].size()}, Range{0, spans_[2].size()}});
        for (int halvings = deepest(); !tasks_.empty(); --halvings)
            cut_level(halvings);
        sort_parts();
        tree_.tree_ = BoxTree(tree_.boxes_, 1, 0);
        name_folds();
    }

private:
    using Range = std::pair<std::size_t, std::size_t>; ///< first and behind the last of some spans

    /// A part to look at. The finest parts that spans can be cut into are numbered so that those of a larger
    /// part follow each other: this is the number of its first one.
    struct Task {
        std::uint64_t first = 0;
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
        std::vector<Sample> samples; ///< decides whether it is folded
    };

    int deepest() const { return lattice_.dimension() == 2 ? kDeepestInPlane : kDeepestInSpace; }

    /// In a part that may be halved so many times more.
    std::uint64_t finest_parts(int halvings) const
    {
        return std::uint64_t{1} << (lattice_.dimension() * halvings);
    }

    void add_spans(const std::array<Range, 3>& range)
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
        if (parts.size() == 1)
            tasks_.push_back(whole_span(range));
        else
            for (const auto& part : parts)
                add_spans(part);
    }

    Task whole_span(const std::array<Range, 3>& range) const
    {
        Task task;
        task.first = tasks_.size() * finest_parts(deepest());
        for (std::size_t d = 0; d < 3; ++d) {
            task.span[d] = spans_[d][range[d].first];
            const auto knot = lattice_.axis(static_cast<int>(d)).knots().begin() + task.span[d];
            task.low[static_cast<int>(d)] = knot[0];
            task.high[static_cast<int>(d)] = knot[1];
        }
        return task;
    }

    void cut_level(int halvings)
    {
        std::vector<Found> found(tasks_.size());
        parallel_for(tasks_.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                found[i] = look_at(tasks_[i]);
        });
        const auto unsure = static_cast<std::size_t>(
            std::count_if(found.begin(), found.end(), [](const Found& f) { return !f.part.sure; }));
        const std::size_t halves = std::size_t{1} << lattice_.dimension();
        const bool may_cut = halvings > 0 && tree_.parts_.size() + unsure * halves <= kMostParts;
        std::vector<Task> finer;
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            if (may_cut && !found[i].part.sure)
                add_halves(tasks_[i], halves, finest_parts(halvings - 1), finer);
            else
                add_part(tasks_[i].first, std::move(found[i]));
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

    void add_halves(const Task& whole, std::size_t count, std::uint64_t step, std::vector<Task>& finer)
    {
        for (std::size_t half = 0; half < count; ++half) {
            Task task = whole;
            task.first = whole.first + half * step;
            for (int d = 0; d < lattice_.dimension(); ++d)
                ((half >> d) % 2 == 0 ? task.high : task.low)[d] = 0.5 * (whole.low[d] + whole.high[d]);
            finer.push_back(task);
        }
    }

    void add_part(std::uint64_t first, Found found)
    {
        found.box.min().array() -= tree_.margin_;
        found.box.max().array() += tree_.margin_;
        volume_ += (found.part.high - found.part.low).prod() * found.determinant;
        first_.push_back(first);
        tree_.parts_.push_back(found.part);
        tree_.boxes_.push_back(found.box);
        samples_.insert(samples_.end(), found.samples.begin(), found.samples.end());
    }

    /// Those of a larger part one after another, so that boxes around runs of them are small.
    void sort_parts()
    {
        std::vector<std::size_t> order(first_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return first_[a] < first_[b]; });
        const auto sorted = [&](const auto& items) {
            std::decay_t<decltype(items)> result;
            result.reserve(items.size());
            for (const std::size_t i : order)
                result.push_back(items[i]);
            return result;
        };
        tree_.parts_ = sorted(tree_.parts_);
        tree_.boxes_ = sorted(tree_.boxes_);
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
    std::vector<std::uint64_t> first_;      ///< Task::first of the parts so far
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
