#pragma once

#include <complex>

namespace morph {

/// Weights of the foldover-free energy of one corner.
struct EnergyWeights {
    double size = 2;       ///< of the change of area against the change of shape, theta in the paper
    double exponent = 1.3; ///< 1: the paper's energy; larger ones give the worst corners more say
};

/// The map from a corner's target to the corner, J z = a z + b conj(z) in complex numbers.
///
/// a is its conformal part, b what shears: |J|^2 = 2 (|a|^2 + |b|^2) and det J = |a|^2 - |b|^2.
struct CornerMap {
    std::complex<double> a;
    std::complex<double> b;

    double determinant() const { return std::norm(a) - std::norm(b); }
};

/// Positive stand-in for a determinant D: (D + sqrt(eps^2 + D^2)) / 2, which is D for D >> eps and never 0.
double regularized(double determinant, double eps);

/// Energy of one corner,
///     f = ((|J|^2 + theta (det J^2 + 1)) / chi(det J, eps) / (2 + 2 theta))^exponent,
/// 1 where J is a rotation and eps = 0; a barrier against det J <= 0 for eps -> 0 [Garanzha, Kaporin,
/// Kudryavtseva, Protais, Ray and Sokolov 2021, ACM Transactions on Graphics 40(4), 109; for the exponent:
/// Fu, Liu and Guo 2015, ACM Transactions on Graphics 34(4), 39].
double corner_energy(const CornerMap& map, double eps, const EnergyWeights& weights);

/// The energy to second order: f(a + da, b + db) = f + Re(conj(da_gradient) da) + Re(conj(db_gradient) db) +
/// q / 2.
///
/// f depends on |a| and |b| only. Along them q couples; across them it does not:
/// q = aa u^2 + 2 ab u s + bb s^2 + across_a v^2 + across_b t^2, with u + i v = conj(a_along) da and
/// s + i t = conj(b_along) db. Each part is positive semidefinite: what is negative of the second derivative
/// is set to 0 [Smith, de Goes and Kim 2019, ACM Transactions on Graphics 38(1), 3].
struct CornerModel {
    std::complex<double> a_gradient;
    std::complex<double> b_gradient;
    std::complex<double> a_along; ///< a / |a|
    std::complex<double> b_along; ///< b / |b|
    double aa = 0;
    double ab = 0;
    double bb = 0;
    double across_a = 0;
    double across_b = 0;
};

CornerModel corner_model(const CornerMap& map, double eps, const EnergyWeights& weights);

} // namespace morph
