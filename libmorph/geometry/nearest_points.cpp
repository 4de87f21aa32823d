#include "libmorph/geometry/nearest_points.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 256; // queries
constexpr int kLeaf = 10;                  // points; by measurement

// FLANN passes over what is no nearer than the given limit, and its distance to a box, added up on
// the way down the tree, may round by a unit in the last place a level. Given a slightly larger limit, it lets pass
// whatever is equally far.
constexpr double kWidening = 1 + 1e-12;
constexpr double kLeastWidening = std::numeric_limits<double>::min();

using FlannTree = flann::KDTreeSingleIndex<flann::L2_Simple<double>>;

/// The exponent of the largest coordinate. Divided by 2 to that power, which is exact, no squared distance
/// of the points can overflow.
int scale_exponent(const Eigen::Ref<const Points>& points)
{
    int exponent = 0;
    std::frexp(points.cwiseAbs().maxCoeff(), &exponent);
    return exponent;
}

struct Candidate {
    double distance2;
    Index point;

    bool operator<(const Candidate& other) const
    {
        return distance2 != other.distance2 ? distance2 < other.distance2 : point < other.point;
    }
};

/// Keeps the first k candidates by distance and row; FLANN's own result sets keep, of those equally far at
/// the k-th place, what its tree comes upon first. Takes in up to 2 k before it drops the last of them.
class FirstCandidates final : public flann::ResultSet<double> {
public:
    explicit FirstCandidates(std::size_t k) : k_(k) { candidates_.reserve(2 * k); }

    /// Start over; all of the first k are known to lie @p within a distance.
    void clear(double within)
    {
        candidates_.clear();
        reach_ = widened(within * within);
    }

    bool full() const override { return candidates_.size() >= k_; }
    double worstDist() const override { return reach_; }

    void addPoint(double distance2, std::size_t point) override
    {
        candidates_.push_back({distance2, static_cast<Index>(point)});
        if (candidates_.size() == 2 * k_)
            drop_last();
    }

    const std::vector<Candidate>& sorted()
    {
        if (candidates_.size() > k_)
            drop_last();
        std::sort(candidates_.begin(), candidates_.end());
        return candidates_;
    }

private:
    void drop_last()
    {
        const auto kth = candidates_.begin() + static_cast<std::ptrdiff_t>(k_) - 1;
        std::nth_element(candidates_.begin(), kth, candidates_.end());
        candidates_.resize(k_);
        reach_ = widened(candidates_.back().distance2);
    }

    static double widened(double distance2) { return distance2 * kWidening + kLeastWidening; }

    std::size_t k_;
    double reach_ = 0;
    std::vector<Candidate> candidates_;
};

} // namespace

class NearestPoints::Tree {
public:
    explicit Tree(const Eigen::Ref<const Points>& points)
        : exponent_(scale_exponent(points)), dimension_(points.col(2).isZero(0) ? 2 : 3),
          coordinates_(points.rows(), dimension_),
          index_(table(coordinates_), flann::KDTreeSingleIndexParams(kLeaf))
    {
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (Eigen::Index c = 0; c < dimension_; ++c)
                coordinates_(i, c) = scaled(points(i, c));
        index_.buildIndex();
    }

    /// The neighbours of queries [begin, end).
    void visit_block(const Eigen::Ref<const Points>& queries, std::size_t begin, std::size_t end,
                     std::size_t k, const Visit& visit) const
    {
        const flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED);
        FirstCandidates first(std::min(k, static_cast<std::size_t>(coordinates_.rows())));
        std::vector<Neighbor> neighbors;
        // As many points lie within the farthest's distance of the query before, so within that and the way
        // from there of this one: a bound from the start for queries that follow a curve.
        Eigen::RowVector3d before = Eigen::RowVector3d::Zero();
        double farthest = std::numeric_limits<double>::infinity();
        for (std::size_t q = begin; q < end; ++q) {
            const Eigen::RowVector3d query = queries.row(static_cast<Eigen::Index>(q));
            const Eigen::RowVector3d at = query.unaryExpr([&](double c) { return scaled(c); });
            first.clear(farthest + (at - before).norm());
            index_.findNeighbors(first, at.data(), exact);
            const double height = dimension_ == 2 ? query.z() : 0;
            neighbors.clear();
            for (const Candidate& found : first.sorted()) {
                farthest = std::sqrt(found.distance2);
                neighbors.push_back({found.point, std::hypot(std::ldexp(farthest, exponent_), height)});
            }
            before = at;
            visit(static_cast<Index>(q), neighbors);
        }
    }

    bool reaches(const Eigen::RowVector3d& query) const
    {
        constexpr double kFarthest = 1e150; // its square is still a number
        return query.allFinite() && std::ldexp(query.cwiseAbs().maxCoeff(), -exponent_) < kFarthest;
    }

private:
    double scaled(double coordinate) const { return std::ldexp(coordinate, -exponent_); }

    /// FLANN's view of a matrix, which it takes as one it could write to but does not.
    static flann::Matrix<double> table(const Matrix& matrix)
    {
        return {const_cast<double*>(matrix.data()), static_cast<std::size_t>(matrix.rows()),
                static_cast<std::size_t>(matrix.cols())};
    }

    int exponent_;
    Eigen::Index dimension_;
    Matrix coordinates_; ///< n x 2 or n x 3, scaled
    FlannTree index_;
};

NearestPoints::NearestPoints(const Eigen::Ref<const Points>& points)
{
    if (points.rows() == 0)
        throw InputError("the nearest of no points is asked for");
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (!points.row(i).allFinite())
            throw InputError("point " + std::to_string(i) + " has a coordinate that is not finite");
    tree_ = std::make_unique<Tree>(points);
}

NearestPoints::~NearestPoints() = default;

void NearestPoints::nearest(const Eigen::Ref<const Points>& queries, int k, const Visit& visit) const
{
    if (k < 1)
        throw InputError("the number of neighbours is " + std::to_string(k) +
                         ", but at least 1 was expected");
    for (Eigen::Index q = 0; q < queries.rows(); ++q)
        if (!tree_->reaches(queries.row(q)))
            throw InputError("point " + std::to_string(q) +
                             " is not finite, or too far from the others to decide which are near");
    parallel_for(static_cast<std::size_t>(queries.rows()), kRowsPerBlock,
                 [&](std::size_t begin, std::size_t end) {
                     tree_->visit_block(queries, begin, end, static_cast<std::size_t>(k), visit);
                 });
}

} // namespace morph
