#include "libmorph/remap/integral.h"

#include "libmorph/core/parallel.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192;

/// Integral of each corner's basis function over an element; the fourth of a triangle is 0.
///
/// The Jacobian of a quad's bilinear map is itself bilinear between its values J_j at the corners, so that
/// the integral of corner i's function is the sum of J_j times the mass matrix of the unit square.
std::array<double, 4> basis_integrals(const Mesh& mesh, const Element& element)
{
    std::array<Eigen::Vector3d, 4> p;
    for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(element)); ++k)
        p[k] = points(mesh).row(element[k]).transpose();
    if (corner_count(element) == 3) {
        const double third = (p[1] - p[0]).cross(p[2] - p[0]).norm() / 6;
        return {third, third, third, 0};
    }
    const Eigen::Vector3d normal = (p[2] - p[0]).cross(p[3] - p[1]).normalized();
    std::array<double, 4> integral{};
    constexpr std::array<double, 4> kMass{4.0 / 36, 2.0 / 36, 1.0 / 36, 2.0 / 36}; // by steps around the quad
    for (std::size_t j = 0; j < 4; ++j) {
        const double jacobian = normal.dot((p[(j + 1) % 4] - p[j]).cross(p[(j + 3) % 4] - p[j]));
        for (std::size_t i = 0; i < 4; ++i)
            integral[i] += kMass[(i + 4 - j) % 4] * jacobian;
    }
    return integral;
}

Eigen::RowVectorXd element_integral(const Mesh& mesh, Index face, const Field& field)
{
    const Element element = element_corners(mesh, face);
    const std::array<double, 4> basis = basis_integrals(mesh, element);
    if (field.location == FieldLocation::element)
        return (basis[0] + basis[1] + basis[2] + basis[3]) * field.values.row(face);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(field.values.cols());
    for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(element)); ++k)
        sum += basis[k] * field.values.row(element[k]);
    return sum;
}

Eigen::RowVectorXd integral(const Mesh& mesh, const Field& field)
{
    const auto faces = static_cast<std::size_t>(element_count(mesh));
    std::vector<Eigen::RowVectorXd> sums((faces + kRowsPerBlock - 1) / kRowsPerBlock,
                                         Eigen::RowVectorXd::Zero(field.values.cols()));
    parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            sums[begin / kRowsPerBlock] += element_integral(mesh, static_cast<Index>(f), field);
    });
    Eigen::RowVectorXd total = Eigen::RowVectorXd::Zero(field.values.cols());
    for (const Eigen::RowVectorXd& sum : sums)
        total += sum;
    return total;
}

} // namespace

FieldTotals field_totals(const Mesh& mesh, const Field& field)
{
    FieldTotals totals{field.values.colwise().minCoeff(), field.values.colwise().maxCoeff(), {}};
    if (element_count(mesh) > 0)
        totals.integral = integral(mesh, field);
    return totals;
}

} // namespace morph
