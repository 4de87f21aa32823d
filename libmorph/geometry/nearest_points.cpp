#include "libmorph/geometry/nearest_points.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kGrain = 256; // queries
constexpr int kLeaf = 10;           // points; by measurement

using FlannTree = flann::KDTreeSingleIndex<flann::L2_Simple<double>>;

/// The exponent of the largest coordinate. Divided by 2 to that power, which is exact, no squared distance
/// of the points can overflow.
int scale_exponent(const Eigen::Ref<const Points>& points)
{
    int exponent = 0;
    std::frexp(points.cwiseAbs().maxCoeff(), &exponent);
    return exponent;
}

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
        const std::size_t found = std::min(k, static_cast<std::size_t>(coordinates_.rows()));
        Matrix block(static_cast<Eigen::Index>(end - begin), dimension_);
        for (std::size_t q = begin; q < end; ++q)
            for (Eigen::Index c = 0; c < dimension_; ++c)
                block(static_cast<Eigen::Index>(q - begin), c) =
                    scaled(queries(static_cast<Eigen::Index>(q), c));
        std::vector<std::size_t> points(found * (end - begin));
        std::vector<double> distances2(points.size());
        flann::Matrix<std::size_t> point_table(points.data(), end - begin, found);
        flann::Matrix<double> distance_table(distances2.data(), end - begin, found);
        index_.knnSearch(table(block), point_table, distance_table, found,
                         flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
        std::vector<Neighbor> neighbors(found);
        for (std::size_t q = begin; q < end; ++q) {
            const double height = dimension_ == 2 ? queries(static_cast<Eigen::Index>(q), 2) : 0;
            for (std::size_t i = 0; i < found; ++i) {
                const std::size_t at = (q - begin) * found + i;
                const double distance = std::ldexp(std::sqrt(distances2[at]), exponent_);
                neighbors[i] = {static_cast<Index>(points[at]), std::hypot(distance, height)};
            }
            std::sort(neighbors.begin(), neighbors.end(), [](const Neighbor& a, const Neighbor& b) {
                return a.distance != b.distance ? a.distance < b.distance : a.point < b.point;
            });
            visit(static_cast<Index>(q), neighbors);
        }
    }

    bool reaches(const Eigen::RowVector3d& query) const
    {
        constexpr double kFarthest = 1e150; // its square is still a number
        return std::ldexp(query.cwiseAbs().maxCoeff(), -exponent_) < kFarthest;
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
                             " is not finite, or too far from the others to tell which are near");
    parallel_for(static_cast<std::size_t>(queries.rows()), kGrain, [&](std::size_t begin, std::size_t end) {
        tree_->visit_block(queries, begin, end, static_cast<std::size_t>(k), visit);
    });
}

} // namespace morph
