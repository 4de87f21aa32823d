#include "libmorph/untangle/corner_energy.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

/// Value and derivatives of the energy in A = |a|^2 and B = |b|^2.
struct Derivatives {
    double value = 0;
    double a = 0;
    double b = 0;
    double aa = 0;
    double ab = 0;
    double bb = 0;
};

double base_energy(double A, double B, double eps, double theta)
{
    const double D = A - B;
    return (2 * (A + B) + theta * (D * D + 1)) / regularized(D, eps) / (2 + 2 * theta);
}

/// Of the energy before it is raised to its exponent: N / chi.
Derivatives base_derivatives(double A, double B, double eps, double theta)
{
    const double D = A - B;
    const double scale = 1 / (2 + 2 * theta);
    const double N = scale * (2 * (A + B) + theta * (D * D + 1));
    const double NA = scale * (2 + 2 * theta * D), NB = scale * (2 - 2 * theta * D);
    const double NAA = scale * 2 * theta; // = NBB = -NAB
    const double root = std::hypot(eps, D);
    const double inverse = 1 / regularized(D, eps);
    const double slope = 1 / root;                                        // chi' / chi
    const double bend = eps / root * (eps / root) / (2 * root) * inverse; // chi'' / chi
    const double turn = 2 * slope * slope - bend;                         // chi (1 / chi)''
    Derivatives d;
    d.value = N * inverse;
    d.a = (NA - N * slope) * inverse;
    d.b = (NB + N * slope) * inverse;
    d.aa = (NAA - 2 * NA * slope + N * turn) * inverse;
    d.bb = (NAA + 2 * NB * slope + N * turn) * inverse;
    d.ab = (-NAA + (NA - NB) * slope - N * turn) * inverse;
    return d;
}

Derivatives raised(const Derivatives& d, double exponent)
{
    const double power = std::pow(d.value, exponent - 2);
    const double first = exponent * power * d.value, second = exponent * (exponent - 1) * power;
    return {power * d.value * d.value,
            first * d.a,
            first * d.b,
            first * d.aa + second * d.a * d.a,
            first * d.ab + second * d.a * d.b,
            first * d.bb + second * d.b * d.b};
}

std::complex<double> direction(std::complex<double> z, double length)
{
    return length > 0 ? z / length : std::complex<double>(1);
}

/// Set the negative eigenvalues of the coupled part to 0.
void project(CornerModel& model)
{
    const double mean = 0.5 * (model.aa + model.bb);
    const double half = 0.5 * (model.aa - model.bb);
    const double radius = std::hypot(half, model.ab);
    if (mean - radius >= 0)
        return;
    const double high = std::max(mean + radius, 0.0); // the other one is 0
    const double stretch = radius > 0 ? 0.5 * high / radius : 0;
    model.aa = 0.5 * high + stretch * half;
    model.bb = 0.5 * high - stretch * half;
    model.ab *= stretch;
}

} // namespace

double regularized(double determinant, double eps)
{
    const double root = std::hypot(eps, determinant);
    return determinant < 0 ? 0.5 * eps * (eps / (root - determinant)) : 0.5 * (determinant + root);
}

double corner_energy(const CornerMap& map, double eps, const EnergyWeights& weights)
{
    return std::pow(base_energy(std::norm(map.a), std::norm(map.b), eps, weights.size), weights.exponent);
}

CornerModel corner_model(const CornerMap& map, double eps, const EnergyWeights& weights)
{
    const double A = std::norm(map.a), B = std::norm(map.b);
    const double p = std::sqrt(A), q = std::sqrt(B);
    const Derivatives d = raised(base_derivatives(A, B, eps, weights.size), weights.exponent);
    CornerModel model;
    model.a_gradient = 2 * d.a * map.a;
    model.b_gradient = 2 * d.b * map.b;
    model.a_along = direction(map.a, p);
    model.b_along = direction(map.b, q);
    model.aa = 2 * d.a + 4 * A * d.aa;
    model.ab = 4 * p * q * d.ab;
    model.bb = 2 * d.b + 4 * B * d.bb;
    model.across_a = std::max(2 * d.a, 0.0);
    model.across_b = std::max(2 * d.b, 0.0);
    project(model);
    return model;
}

} // namespace morph
