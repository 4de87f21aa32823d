#include "libmorph/weights/idw.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/weights/boundary_segments.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRows = 256; // vertices a thread takes at a time: their sums stay in the first cache

// A distance of less than this part of L_def counts as this: at a boundary vertex that vertex's weight drowns
// all others, and no power up to the largest exponent overflows.
constexpr double kLeast = 1e-28;
constexpr double kLargestExponent = 10;

void require(bool good, const std::string& what, double value, const std::string& expected)
{
    if (good)
        return;
    std::ostringstream text;
    text << "the " << what << " of inverse distance weighting is " << value << ", but it must be "
         << expected;
    throw InputError(text.str());
}

/// The options with the reach that is meant.
IdwOptions checked(const DomainView& domain, IdwOptions options)
{
    const double a = options.far_exponent, b = options.near_exponent;
    require(a > 0 && a <= kLargestExponent, "far exponent", a, "positive and at most 10");
    require(b >= a && b <= kLargestExponent, "near exponent", b, "at least the far one and at most 10");
    require(options.stiffness >= 0 && std::isfinite(options.stiffness), "stiffness", options.stiffness,
            "zero or positive");
    require(options.reach >= 0 && std::isfinite(options.reach), "reach", options.reach,
            "positive, or 0 for the default");
    if (options.reach == 0)
        options.reach = default_reach(domain);
    require(options.reach > 0, "reach", options.reach, "positive: the mesh has no extent");
    return options;
}

/// Half the length of the edges at each held vertex; a vertex without an edge has the mean of the others.
Eigen::ArrayXd edge_shares(const DomainView& domain, const DirichletBoundary& boundary,
                           const UniqueDirichletVertices& vertices)
{
    const Points x = held_points(domain, vertices);
    Eigen::ArrayXd share = Eigen::ArrayXd::Zero(x.rows());
    const BoundarySegments edges = boundary_segments(domain, boundary, vertices);
    for (const auto& list : {edges.moving, edges.still})
        for (const auto& [a, b] : list) {
            const double half = 0.5 * (x.row(b) - x.row(a)).head<2>().norm();
            share[a] += half;
            share[b] += half;
        }
    const auto known = (share > 0).count();
    const double mean = known > 0 ? share.sum() / static_cast<double>(known) : 1;
    return (share > 0).select(share, mean);
}

/// (L / r)^exponent from s = (L / r)^2; whole exponents need no logarithm.
Eigen::ArrayXd raised(const Eigen::ArrayXd& s, double exponent)
{
    if (exponent != std::floor(exponent))
        return s.pow(0.5 * exponent);
    const int n = static_cast<int>(exponent);
    Eigen::ArrayXd power = n % 2 == 1 ? s.sqrt().eval() : Eigen::ArrayXd::Ones(s.size());
    for (int i = 0; i < n / 2; ++i)
        power *= s;
    return power;
}

class IdwExtension final : public BoundaryExtension {
public:
    IdwExtension(const DomainView& domain, const DirichletBoundary& boundary, const IdwOptions& options)
        : BoundaryExtension(domain, boundary), positions_(domain.positions()),
          options_(checked(domain, options)), boundary_(held_points(domain, held())),
          share_(edge_shares(domain, boundary, held()))
    {
        if (boundary_.rows() == 0)
            throw InputError("no vertex is held: there is nothing to weigh by inverse distance");
    }

private:
    Matrix solve(const Matrix& joined) const override
    {
        Matrix result(positions_.rows(), joined.cols());
        parallel_for(
            static_cast<std::size_t>(positions_.rows()), kRows, [&](std::size_t begin, std::size_t end) {
                const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
                result.middleRows(first, count) = means(positions_.middleRows(first, count), joined);
            });
        return result;
    }

    /// The weighted means at some points.
    Eigen::MatrixXd means(const Eigen::Ref<const Points>& at, const Matrix& values) const
    {
        const Eigen::ArrayXd x = at.col(0), y = at.col(1);
        const double reach2 = options_.reach * options_.reach, least = kLeast * kLeast * reach2;
        const double near = std::pow(options_.stiffness, options_.near_exponent);
        Eigen::ArrayXd total = Eigen::ArrayXd::Zero(at.rows());
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(at.rows(), values.cols());
        for (Index i = 0; i < static_cast<Index>(boundary_.rows()); ++i) {
            const Eigen::ArrayXd s =
                reach2 / ((x - boundary_(i, 0)).square() + (y - boundary_(i, 1)).square()).max(least);
            const Eigen::ArrayXd weight =
                share_[i] * (raised(s, options_.far_exponent) + near * raised(s, options_.near_exponent));
            total += weight;
            for (Index c = 0; c < static_cast<Index>(values.cols()); ++c)
                sum.col(c).array() += values(i, c) * weight;
        }
        return sum.array().colwise() / total;
    }

    Points positions_;
    IdwOptions options_;
    Points boundary_;      ///< h x 3
    Eigen::ArrayXd share_; ///< A_i
};

} // namespace

double default_reach(const DomainView& domain)
{
    const auto x = domain.positions().leftCols<2>();
    if (x.rows() == 0)
        return 0;
    const Eigen::RowVector2d mean = x.colwise().mean();
    return (x.rowwise() - mean).rowwise().norm().maxCoeff();
}

std::unique_ptr<BoundaryExtension> idw_extension(const DomainView& domain, const DirichletBoundary& boundary,
                                                 const IdwOptions& options)
{
    return std::make_unique<IdwExtension>(domain, boundary, options);
}

} // namespace morph
