#include "libmorph/deform/pull.h"

#include "libmorph/core/error.h"

#include <Eigen/QR>

namespace morph {

namespace {

// Far above round-off of the decomposition, and small enough that what is given up stays below 1e-10 of the
// change even when the change is a hundred times the size of the requested displacements.
constexpr double kOutOfReach = 1e-12;

std::string size_of(const Matrix& matrix)
{
    return std::to_string(matrix.rows()) + " x " + std::to_string(matrix.cols());
}

void require_valid(const ControlledPoints& points, const Matrix& wanted, const Matrix& given)
{
    if (given.rows() != points.weights.cols() || (given.cols() != 2 && given.cols() != 3))
        throw InputError("the displacements are " + size_of(given) + ", but the weights are for " +
                         std::to_string(points.weights.cols()) + " control points in 2 or 3 dimensions");
    if (wanted.rows() != points.weights.rows() || wanted.cols() != given.cols())
        throw InputError("the requested displacements are " + size_of(wanted) + ", but there are " +
                         std::to_string(points.weights.rows()) + " points in " +
                         std::to_string(given.cols()) + " dimensions");
    if (!wanted.allFinite() || !given.allFinite())
        throw InputError("the displacements are not all finite");
}

/// The control points that may move and that move any of the points.
std::vector<Index> movers(const ControlledPoints& points, const std::vector<Index>& held)
{
    const auto count = static_cast<Index>(points.weights.cols());
    std::vector<bool> moves(static_cast<std::size_t>(count), false);
    for (Index entry = 0; entry < points.weights.nonZeros(); ++entry)
        moves[static_cast<std::size_t>(points.weights.innerIndexPtr()[entry])] = true;
    for (const Index k : held) {
        if (k < 0 || k >= count)
            throw InputError("control point " + std::to_string(k) + " is held, but there are " +
                             std::to_string(count));
        moves[static_cast<std::size_t>(k)] = false;
    }
    std::vector<Index> result;
    for (Index k = 0; k < count; ++k)
        if (moves[static_cast<std::size_t>(k)])
            result.push_back(k);
    return result;
}

} // namespace

Pulled pull_points(const ControlledPoints& points, const Matrix& wanted, const Matrix& given,
                   const std::vector<Index>& held)
{
    require_valid(points, wanted, given);
    const std::vector<Index> columns = movers(points, held);
    Pulled result{given, wanted - points.weights * given, 0};
    if (columns.empty() || wanted.rows() == 0)
        return result;
    const Matrix W = Matrix(points.weights)(Eigen::all, columns);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(kOutOfReach);
    decomposition.compute(W);
    result.rank = static_cast<Index>(decomposition.rank());
    const Matrix change = decomposition.solve(result.residual);
    result.displacements(columns, Eigen::all) += change;
    result.residual = wanted - points.weights * result.displacements;
    return result;
}

} // namespace morph
