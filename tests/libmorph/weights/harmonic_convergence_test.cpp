// Harmonic weights against closed forms: the error falls as theory says.
#include "libmorph/mesh/builder.h"
#include "tests/support/harmonic.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace morph;
using test::BoundaryValues;
using test::harmonic_functions;
using test::prescribe_boundary;
using test::uneven_annulus;
using test::x_of;
using test::y_of;

template <typename Function>
double worst_error(const Mesh& mesh, const Matrix& h, const Function& exact)
{
    double worst = 0;
    for (Index v = 0; v < h.rows(); ++v)
        worst = std::max(worst, std::abs(h(v, 0) - exact(x_of(mesh, v), y_of(mesh, v))));
    return worst;
}

constexpr double kInner = 0.5;
constexpr double kOuter = 3;

double one_inside(double x, double y)
{
    return std::hypot(x, y) < 0.5 * (kInner + kOuter) ? 1 : 0;
}

template <typename Function>
double annulus_error(const MeshData& data, Diffusivity diffusivity, const Function& exact)
{
    const Mesh mesh = build_mesh(data);
    const auto values = [](double x, double y) { return Eigen::Matrix<double, 1, 1>(one_inside(x, y)); };
    const Matrix h = harmonic_functions(mesh, prescribe_boundary(mesh, "inner", values), diffusivity);
    return worst_error(mesh, h, [&](double x, double y) { return exact(std::hypot(x, y)); });
}

/// The error falls with the square of the cell size over three refinements: 4 times each, at least 3.4.
template <typename MakeMesh, typename Function>
void expect_second_order(Diffusivity diffusivity, const MakeMesh& mesh, const Function& exact)
{
    double coarse = annulus_error(mesh(48), diffusivity, exact);
    for (const Index around : {96, 192, 384}) {
        const double fine = annulus_error(mesh(around), diffusivity, exact);
        EXPECT_GT(coarse / fine, 3.4) << around << " around: " << fine;
        coarse = fine;
    }
}

MeshData uneven(Index around)
{
    return uneven_annulus(kInner, kOuter, around);
}

TEST(HarmonicWeights, ConvergeToTheLogarithmInAnAnnulus)
{
    expect_second_order(Diffusivity::uniform, uneven,
                        [](double r) { return std::log(kOuter / r) / std::log(kOuter / kInner); });
}

// With g = 1 / (r - R1) the equation is (r h' / (r - R1))' = 0, so h falls like r - R1 - R1 ln(r / R1).
TEST(HarmonicWeights, ConvergeForInverseDistanceInAnAnnulus)
{
    const auto fallen = [](double r) { return r - kInner - kInner * std::log(r / kInner); };
    expect_second_order(Diffusivity::inverse_distance, uneven,
                        [&](double r) { return 1 - fallen(r) / fallen(kOuter); });
}

// The cells of this annulus have areas that grow as r^2: g = 1 / r^2 and r h' / r^2 is constant.
TEST(HarmonicWeights, ConvergeForInverseAreaInAGradedAnnulus)
{
    const auto graded = [](Index around) { return test::annulus(kInner, kOuter, around, around / 4); };
    expect_second_order(Diffusivity::inverse_area, graded, [](double r) {
        return (kOuter * kOuter - r * r) / (kOuter * kOuter - kInner * kInner);
    });
}

double mean_value_error(Index around)
{
    MeshData disc = uneven_annulus(0.02, 1, around);
    const Index centre = static_cast<Index>(disc.points.rows());
    disc.points.conservativeResize(centre + 1, 3);
    disc.points.row(centre).setZero();
    for (Index i = 0; i < around; ++i)
        disc.elements.push_back({centre, i, (i + 1) % around, -1});
    disc.markers.erase(disc.markers.begin());
    const Mesh mesh = build_mesh(disc);
    const auto values = [](double x, double y) { return Eigen::Matrix<double, 1, 1>(std::exp(x) * x + y); };
    const BoundaryValues problem = prescribe_boundary(mesh, "outer", values);
    const Matrix h = harmonic_functions(mesh, problem, Diffusivity::uniform);
    const auto& file = mesh.numbering.vertex;
    const auto inside = std::find(file.begin(), file.end(), centre) - file.begin();
    return std::abs(h(inside, 0) - problem.values.mean()); // the circle's vertices are evenly spaced
}

TEST(HarmonicWeights, AtTheCentreOfADiscAreTheMeanOnTheCircle)
{
    const double coarse = mean_value_error(24);
    const double fine = mean_value_error(96);
    EXPECT_LT(coarse, 0.02); // the values range from -0.4 to 2.7
    EXPECT_LT(fine, coarse / 8);
}

} // namespace
