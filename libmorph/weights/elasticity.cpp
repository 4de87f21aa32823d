#include "libmorph/weights/elasticity.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/segment_tree.h"
#include "libmorph/weights/energy_extension.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192; // elements a thread takes at a time

using Gradients = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 4, 2>;    // of the corners' functions
using StrainMatrix = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 8>; // xx, yy, 2 xy of each unknown
using CornerMatrix = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 4>; // where the corners are

void require_valid(const Elasticity& elasticity)
{
    if (!(elasticity.poisson_ratio > -1 && elasticity.poisson_ratio < 0.5))
        throw InputError("Poisson's ratio is " + std::to_string(elasticity.poisson_ratio) +
                         ", but must be between -1 and 0.5");
}

/// Stress for each strain in plane strain, Young's modulus 1.
Eigen::Matrix3d stress_matrix(double poisson_ratio)
{
    const double mu = 0.5 / (1 + poisson_ratio);
    const double lambda = poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
    D.topLeftCorner<2, 2>().setConstant(lambda);
    D.diagonal() += Eigen::Vector3d(2 * mu, 2 * mu, mu);
    return D;
}

/// Derivatives of the corners' functions on the reference element: the triangle of area 1/2, the square of
/// side 2.
Gradients reference_gradients(int corners, double s, double t)
{
    Gradients g(corners, 2);
    if (corners == 3)
        g << -1, -1, 1, 0, 0, 1;
    else
        g << -(1 - t), -(1 - s), 1 - t, -(1 + s), 1 + t, 1 + s, -(1 + t), 1 - s;
    return corners == 3 ? g : Gradients(0.25 * g);
}

CornerMatrix corner_matrix(const ElementPoints& element)
{
    CornerMatrix x(2, element.corners);
    for (int i = 0; i < element.corners; ++i)
        x.col(i) = element.at[static_cast<std::size_t>(i)];
    return x;
}

class Solid {
public:
    Solid(const DomainView& domain, const DirichletBoundary& boundary, const Elasticity& elasticity)
        : domain_(domain), D_(stress_matrix(elasticity.poisson_ratio)),
          modulus_(moduli(boundary, elasticity.modulus))
    {
    }

    void add_energy(const ElementPoints& element, ElementMatrix& Q) const
    {
        if (element.corners == 3)
            return add_point(element, 1.0 / 3, 1.0 / 3, 0.5, Q);
        constexpr double kGauss = std::numbers::inv_sqrt3;
        for (const double s : {-kGauss, kGauss})
            for (const double t : {-kGauss, kGauss})
                add_point(element, s, t, 1, Q);
    }

private:
    /// Add what one integration point contributes.
    void add_point(const ElementPoints& element, double s, double t, double weight, ElementMatrix& Q) const
    {
        const Gradients reference = reference_gradients(element.corners, s, t);
        const Eigen::Matrix2d jacobian = corner_matrix(element) * reference;
        const double area = jacobian.determinant();
        if (!(area > 0))
            throw InputError("element " + std::to_string(file_number(element.element)) +
                             " is inverted: an elastic solid cannot begin like that");
        const Gradients gradients = reference * jacobian.inverse();
        const Eigen::Index corners = element.corners;
        StrainMatrix B(3, 2 * corners);
        for (Eigen::Index i = 0; i < corners; ++i)
            B.middleCols<2>(2 * i) << gradients(i, 0), 0, 0, gradients(i, 1), gradients(i, 1),
                gradients(i, 0);
        const double modulus = modulus_[static_cast<std::size_t>(element.element)];
        Q += (modulus * weight * area) * (B.transpose() * D_ * B);
    }

    std::vector<double> moduli(const DirichletBoundary& boundary, YoungsModulus modulus) const
    {
        const std::vector<Element> elements = domain_.elements();
        std::vector<double> result(elements.size(), 1.0);
        if (modulus == YoungsModulus::inverse_area)
            for (std::size_t e = 0; e < elements.size(); ++e)
                result[e] = 1 / area_of(elements[e]);
        if (modulus == YoungsModulus::inverse_distance)
            divide_by_distance(elements, SegmentTree(domain_.positions(), boundary.moving_edges), result);
        return result;
    }

    void divide_by_distance(const std::vector<Element>& elements, const SegmentTree& moving,
                            std::vector<double>& result) const
    {
        parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            SegmentTree::Nearest nearest; // neighbours in the numbering are neighbours in the plane
            for (std::size_t e = begin; e < end; ++e) {
                Eigen::Vector2d centre = Eigen::Vector2d::Zero();
                for (int i = 0; i < corner_count(elements[e]); ++i)
                    centre += corner(elements[e], i) / corner_count(elements[e]);
                nearest = moving.nearest(centre.x(), centre.y(), nearest.segment);
                result[e] /= nearest.distance;
            }
        });
    }

    double area_of(const Element& element) const
    {
        double twice = 0;
        const int n = corner_count(element);
        for (int i = 1; i + 1 < n; ++i) {
            const Eigen::Vector2d u = corner(element, i) - corner(element, 0);
            const Eigen::Vector2d v = corner(element, i + 1) - corner(element, 0);
            twice += u.x() * v.y() - u.y() * v.x();
        }
        return 0.5 * twice;
    }

    Eigen::Vector2d corner(const Element& element, int i) const
    {
        return domain_.positions().row(element[static_cast<std::size_t>(i)]).head<2>();
    }

    Index file_number(Index element) const { return domain_.file_element(element); }

    DomainView domain_;
    Eigen::Matrix3d D_;
    std::vector<double> modulus_;
};

} // namespace

std::unique_ptr<BoundaryExtension>
elastic_extension(const DomainView& domain, const DirichletBoundary& boundary, const Elasticity& elasticity)
{
    require_valid(elasticity);
    const Solid solid(domain, boundary, elasticity);
    return std::make_unique<EnergyExtension>(
        domain, boundary,
        [&](const ElementPoints& element, ElementMatrix& Q) { solid.add_energy(element, Q); });
}

} // namespace morph
