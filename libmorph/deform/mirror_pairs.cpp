#include "libmorph/deform/mirror_pairs.h"

#include "libmorph/core/error.h"

#include <string>

namespace morph {

namespace {

constexpr double kSamePlace = 1e-6; ///< of the size of the control points

Index nearest_row(const Matrix& points, const Eigen::RowVectorXd& place)
{
    Eigen::Index nearest = 0;
    (points.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<Index>(nearest);
}

} // namespace

std::vector<std::array<Index, 2>> mirror_pairs(const Matrix& control_points, const Eigen::Vector3d& at,
                                               const Eigen::Vector3d& normal)
{
    const Eigen::Index c = control_points.cols();
    const Eigen::VectorXd unit = normal.head(c).normalized();
    if (!(unit.norm() > 0))
        throw InputError("the normal of a mirror has no direction");
    std::vector<std::array<Index, 2>> pairs;
    if (control_points.rows() == 0)
        return pairs;
    const Eigen::RowVectorXd low = control_points.colwise().minCoeff();
    const Eigen::RowVectorXd high = control_points.colwise().maxCoeff();
    const Eigen::VectorXd heights = (control_points.rowwise() - at.head(c).transpose()) * unit;
    const Matrix images = control_points - 2 * heights * unit.transpose();
    for (Index k = 0; k < control_points.rows(); ++k) {
        const Index image = nearest_row(control_points, images.row(k));
        const double miss = (control_points.row(image) - images.row(k)).norm();
        if (miss > kSamePlace * (high - low).norm() || nearest_row(control_points, images.row(image)) != k)
            throw InputError("control point " + std::to_string(k) +
                             " has no image in the mirror; the nearest control point, " +
                             std::to_string(image) + ", is off by " + std::to_string(miss));
        if (k <= image)
            pairs.push_back({k, image});
    }
    return pairs;
}

} // namespace morph
