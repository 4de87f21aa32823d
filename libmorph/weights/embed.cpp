#include "libmorph/weights/embed.h"

#include "libmorph/basis/tensor_sum.h"
#include "libmorph/core/parallel.h"

#include <Eigen/LU>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 2048; // points that look in the part of the one before
constexpr int kMostSteps = 40;              // those on a sure part need four or five

// Relative to the lattice, what rounding leaves of S(u) - x; relative to the sides of a part, of a step.
constexpr double kRoundOff = 1e-15;

// Relative to the sides of the part. Of a step this small Newton's method leaves the square.
constexpr double kLastStep = 1e-9;

// Relative to the sides of the part: a step along the boundary this small does not bring the point nearer.
constexpr double kStuck = 1e-12;

constexpr Index kNone = -1;

/// Newton's method on the parts of a lattice.
template <int dimension, bool rational, int degree>
class Finder {
public:
    using Vector = Eigen::Matrix<double, dimension, 1>;
    using Square = Eigen::Matrix<double, dimension, dimension>;

    Finder(const LatticeTree& tree, const TensorNet& net, const Eigen::Vector3d& origin)
        : tree_(tree), sum_(tree.lattice(), net), origin_(origin), close_(kRoundOff * tree.lattice().size()),
          margin_(tree.margin())
    {
    }

    /// The parameters of @p x; false: it is outside.
    bool find(Eigen::Vector3d x, Vector& u)
    {
        if (dimension == 2)
            x[2] = 0;
        if (part_ != kNone && tree_.may_hold(part_, x) && solve(part_, x, u))
            return true;
        const Index tried = part_;
        return tree_.find(x, [&](Index part) {
            if (part == tried || !solve(part, x, u))
                return false;
            part_ = part;
            return true;
        });
    }

private:
    bool solve(Index number, const Eigen::Vector3d& x, Vector& u)
    {
        const LatticeTree::Part& part = tree_.parts()[static_cast<std::size_t>(number)];
        const Vector low = part.low.template head<dimension>();
        const Vector sides = part.high.template head<dimension>() - low;
        const Vector target = (x - origin_).template head<dimension>();
        u = low + 0.5 * sides;
        if (!part.sure)
            return iterate(part, target, u) || solve_from_quarters(part, target, u);
        const Vector to_start = part.inverse.template topLeftCorner<dimension, dimension>() *
                                (x - part.middle).template head<dimension>();
        if (!(to_start.cwiseQuotient(sides).cwiseAbs().maxCoeff() <= kFarthestStart))
            return false;
        u = within(part, u + to_start);
        return iterate(part, target, u);
    }

    /// Where the map is nearly singular a start can fail and another one not.
    bool solve_from_quarters(const LatticeTree::Part& part, const Vector& target, Vector& u)
    {
        const Vector low = part.low.template head<dimension>();
        const Vector sides = part.high.template head<dimension>() - low;
        for (int quarter = 0; quarter < 1 << dimension; ++quarter) {
            u = low;
            for (int d = 0; d < dimension; ++d)
                u[d] += ((quarter >> d) % 2 == 0 ? 0.25 : 0.75) * sides[d];
            if (iterate(part, target, u))
                return true;
        }
        return false;
    }

    static Vector within(const LatticeTree::Part& part, const Vector& u)
    {
        return u.cwiseMax(part.low.template head<dimension>()).cwiseMin(part.high.template head<dimension>());
    }

    /// Newton's iteration from @p u on, kept within the part.
    bool iterate(const LatticeTree::Part& part, const Vector& target, Vector& u)
    {
        const Vector sides = (part.high - part.low).template head<dimension>();
        for (int step = 0; step < kMostSteps; ++step) {
            const Vector rest = residual(part.span, u, target);
            if (rest.squaredNorm() <= close_ * close_)
                return true;
            const Vector next = u - jacobian_.inverse() * rest;
            const Vector kept = within(part, next);
            const double moved = (kept - u).cwiseQuotient(sides).cwiseAbs().maxCoeff();
            const bool stays = !(moved > (kept == next ? kRoundOff : kStuck));
            if (stays)
                return rest.squaredNorm() <= margin_ * margin_;
            u = kept;
            if (part.sure && kept == next && moved <= kLastStep)
                return true;
        }
        return residual(part.span, u, target).squaredNorm() <= margin_ * margin_;
    }

    /// S(u) - target, and the Jacobian.
    Vector residual(const std::array<int, 3>& span, const Vector& u, const Vector& target)
    {
        sum_.template functions<true>(span, u.data(), at_);
        typename Sum::Sum A;
        std::array<typename Sum::Sum, dimension> slopes;
        sum_.derivatives(at_, A, slopes);
        Vector S = A.template head<dimension>();
        for (int d = 0; d < dimension; ++d)
            jacobian_.col(d) = slopes[static_cast<std::size_t>(d)].template head<dimension>();
        if constexpr (rational) {
            S /= A[dimension];
            for (int d = 0; d < dimension; ++d)
                jacobian_.col(d) =
                    (jacobian_.col(d) - slopes[static_cast<std::size_t>(d)][dimension] * S) / A[dimension];
        }
        return S - target;
    }

    using Sum = TensorSum<dimension, dimension + (rational ? 1 : 0), degree>;

    // A start for a point of a sure part is within kVariation of it, and the part reaches 1/2 from its
    // middle.
    static constexpr double kFarthestStart = 0.5 * (1 + LatticeTree::kVariation) + 1e-9;

    const LatticeTree& tree_;
    Sum sum_;
    Eigen::Vector3d origin_;
    double close_;
    double margin_;
    Index part_ = kNone;
    TensorPoint at_;
    Square jacobian_;
};

template <int dimension, bool rational, int degree>
Index embed_all(const LatticeTree& tree, const Eigen::Ref<const Points>& points, Embedding& result)
{
    const Eigen::Vector3d origin = tree.lattice().definition().control_points.colwise().mean();
    const TensorNet net = tensor_net(tree.lattice(), homogeneous_points(tree.lattice(), origin));
    const auto count = static_cast<std::size_t>(points.rows());
    std::vector<Index> found((count + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(count, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        Finder<dimension, rational, degree> finder(tree, net, origin);
        for (std::size_t i = begin; i < end; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            Eigen::Matrix<double, dimension, 1> u;
            if (!finder.find(points.row(row).transpose(), u))
                continue;
            result.parameters.row(row).template head<dimension>() = u.transpose();
            result.inside[i] = 1;
            ++found[begin / kRowsPerBlock];
        }
    });
    Index inside = 0;
    for (const Index of_block : found)
        inside += of_block;
    return inside;
}

template <int dimension, bool rational>
auto compiled_for(int degree)
{
    switch (degree) {
    case 1:
        return embed_all<dimension, rational, 1>;
    case 2:
        return embed_all<dimension, rational, 2>;
    case 3:
        return embed_all<dimension, rational, 3>;
    default:
        return embed_all<dimension, rational, SplineAxis::kAnyDegree>;
    }
}

} // namespace

Embedding embed(const LatticeTree& tree, const Eigen::Ref<const Points>& points)
{
    Embedding result;
    result.parameters = Points::Zero(points.rows(), 3);
    result.inside.assign(static_cast<std::size_t>(points.rows()), 0);
    const int degree = common_degree(tree.lattice());
    const bool rational = tree.lattice().rational();
    const auto run = tree.lattice().dimension() == 2
                         ? (rational ? compiled_for<2, true>(degree) : compiled_for<2, false>(degree))
                         : (rational ? compiled_for<3, true>(degree) : compiled_for<3, false>(degree));
    result.inside_count = run(tree, points, result);
    return result;
}

Embedding embed(const Lattice& lattice, const Eigen::Ref<const Points>& points)
{
    return embed(LatticeTree(lattice), points);
}

} // namespace morph
