#include "libmorph/basis/distance_minima.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace morph {

namespace {

// A node this close to a corner or an end, relative to the size of the curve, is meant to be there.
constexpr double kSamePlace = 1e-12;
// Minima closer than this in u are one minimum that rounding has torn apart.
constexpr double kSameParameter = 1e-9;
// Halvings of a piece after which several roots in one interval count as one.
constexpr int kMaxDepth = 30;

constexpr std::size_t kMaxCoefficients = std::size_t{3} * kMaxDegree; // of a rational piece

using Polynomial = std::vector<double>; // Bernstein coefficients over [0, 1]

double binomial(std::size_t n, std::size_t k)
{
    double value = 1;
    for (std::size_t i = 1; i <= k; ++i)
        value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
    return value;
}

Polynomial product(const Polynomial& f, const Polynomial& g)
{
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    Polynomial h(m + n + 1);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            h[i + j] += binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * f[i] * g[j];
    return h;
}

Polynomial derivative(const Polynomial& f)
{
    if (f.size() == 1)
        return {0.0};
    Polynomial d(f.size() - 1);
    for (std::size_t i = 0; i < d.size(); ++i)
        d[i] = static_cast<double>(d.size()) * (f[i + 1] - f[i]);
    return d;
}

Polynomial combine(const Polynomial& f, double factor, const Polynomial& g)
{
    assert(f.size() == g.size());
    Polynomial sum = f;
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += factor * g[i];
    return sum;
}

/// The same polynomial with more coefficients.
Polynomial raise_degree(const Polynomial& f, std::size_t count)
{
    return product(f, Polynomial(count - f.size() + 1, 1.0));
}

double largest(std::span<const double> values)
{
    double size = 0;
    for (const double value : values)
        size = std::max(size, std::abs(value));
    return size;
}

/// How often the sign changes along the coefficients, zeros left out, and the signs at both ends.
struct Signs {
    int changes = 0;
    int first = 0; ///< 0: all are zero
    int last = 0;
};

Signs signs_of(std::span<const double> coefficients)
{
    Signs signs;
    for (const double c : coefficients) {
        const int sign = c > 0 ? 1 : c < 0 ? -1 : 0;
        if (sign == 0)
            continue;
        signs.changes += signs.last * sign < 0 ? 1 : 0;
        signs.first = signs.first == 0 ? sign : signs.first;
        signs.last = sign;
    }
    return signs;
}

/// Value and derivative of a polynomial in Bernstein form.
std::array<double, 2> evaluate(std::span<const double> coefficients, double t)
{
    std::array<double, kMaxCoefficients> c{};
    std::copy(coefficients.begin(), coefficients.end(), c.begin());
    const std::size_t degree = coefficients.size() - 1;
    for (std::size_t level = degree; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i)
            c[i] += t * (c[i + 1] - c[i]);
    return {c[0] + t * (c[1] - c[0]), static_cast<double>(degree) * (c[1] - c[0])};
}

/// The one root in [0, 1] of a polynomial that passes from negative to positive there.
double rising_root(std::span<const double> coefficients)
{
    double low = 0;
    double high = 1;
    double t = coefficients.front() < 0 && coefficients.back() > 0
                   ? coefficients.front() / (coefficients.front() - coefficients.back())
                   : 0.5;
    for (int step = 0; step < 80; ++step) {
        const auto [value, slope] = evaluate(coefficients, t);
        if (value == 0)
            break;
        (value < 0 ? low : high) = t;
        const double newton = t - value / slope;
        // Every few steps halve in any case: Newton may creep along one side.
        const bool inside = newton > low && newton < high && step % 8 != 7;
        const double next = inside ? newton : 0.5 * (low + high);
        if (std::abs(next - t) <= std::numeric_limits<double>::epsilon() * 0.5)
            return next;
        t = next;
    }
    return t;
}

/// Appends the parameters, in [begin, end], where a polynomial passes from negative to positive.
///
/// @param noise  coefficients no larger than this are rounding errors: the distance is constant, and any
///               place is as close as another
void find_rising_roots(std::span<double> coefficients, double begin, double end, double noise, int depth,
                       std::vector<double>& roots)
{
    const Signs signs = signs_of(coefficients);
    if (signs.changes == 0 || (signs.changes == 1 && signs.first > 0))
        return;
    if (depth == kMaxDepth || largest(coefficients) <= noise) {
        roots.push_back(0.5 * (begin + end));
        return;
    }
    if (signs.changes == 1) {
        roots.push_back(begin + rising_root(coefficients) * (end - begin));
        return;
    }
    std::array<double, kMaxCoefficients> left{};
    const std::span<double> left_part = std::span(left).first(coefficients.size());
    split_in_half(coefficients, left_part);
    const double middle = 0.5 * (begin + end);
    // A root that is exactly the middle shows in neither half.
    const bool rises_between =
        signs_of(left_part).last < 0 && signs_of(coefficients).first > 0 && coefficients.front() == 0;
    find_rising_roots(left_part, begin, middle, noise, depth + 1, roots);
    if (rises_between)
        roots.push_back(middle);
    find_rising_roots(coefficients, middle, end, noise, depth + 1, roots);
}

} // namespace

DistanceMinima::DistanceMinima(const Curve& curve) : curve_(curve)
{
    const Points2& control = curve.definition().control_points;
    const Eigen::Vector2d low = control.colwise().minCoeff();
    const Eigen::Vector2d high = control.colwise().maxCoeff();
    origin_ = 0.5 * low + 0.5 * high;
    size_ = (high - low).norm();
    for (const BezierPiece& bezier : bezier_pieces(curve))
        pieces_.push_back(make_piece(bezier));
    for (const double u : curve.corners())
        special_.push_back({u, curve.point(u)});
    if (!curve.closed())
        for (const double u : {0.0, 1.0})
            special_.push_back({u, curve.point(u)});
}

DistanceMinima::ConvexPart DistanceMinima::make_piece(const BezierPiece& bezier) const
{
    Polynomial x;
    Polynomial y;
    Polynomial w;
    for (const Eigen::Vector3d& point : bezier.control) {
        x.push_back(point.x() - origin_.x() * point.z());
        y.push_back(point.y() - origin_.y() * point.z());
        w.push_back(point.z());
    }
    if (curve_.definition().weights.empty())
        w = {1.0};
    // C' = (A' w - A w') / w^2 with A = (x, y).
    const auto direction = [&](const Polynomial& a) {
        const Polynomial turned = product(derivative(a), w);
        return w.size() == 1 ? turned : combine(turned, -1, product(a, derivative(w)));
    };
    const Polynomial dx = direction(x);
    const Polynomial dy = direction(y);
    const Polynomial constant = combine(product(x, dx), 1, product(y, dy));
    const std::array<Polynomial, 2> slope{product(w, dx), product(w, dy)};

    ConvexPart piece{bezier.begin, bezier.end, constant.size(), {}, {}, 0, 0};
    std::copy(constant.begin(), constant.end(), piece.constant.begin());
    piece.constant_size = largest(constant);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Polynomial raised = raise_degree(slope[axis], constant.size());
        std::copy(raised.begin(), raised.end(), piece.slope[axis].begin());
        piece.slope_size = std::max(piece.slope_size, largest(raised));
    }
    return piece;
}

std::vector<double> DistanceMinima::stationary_parameters(const Eigen::Vector2d& q) const
{
    std::vector<double> found;
    int before = curve_.closed() ? 1 : -1; // sign of the distance's derivative before the breakpoint
    int first = 0;
    for (const ConvexPart& piece : pieces_) {
        Coefficients values{};
        for (std::size_t i = 0; i < piece.count; ++i)
            values[i] = piece.constant[i] - q.x() * piece.slope[0][i] - q.y() * piece.slope[1][i];
        const std::span<double> used = std::span(values).first(piece.count);
        const Signs signs = signs_of(used);
        if (&piece == &pieces_.front())
            first = signs.first;
        if (before <= 0 && signs.first >= 0)
            found.push_back(piece.begin);
        before = signs.last;
        const double noise = 8 * std::numeric_limits<double>::epsilon() *
                             (piece.constant_size + q.lpNorm<1>() * piece.slope_size);
        find_rising_roots(used, piece.begin, piece.end, noise, 0, found);
    }
    if (before <= 0 && (!curve_.closed() || first >= 0))
        found.push_back(curve_.closed() ? 0.0 : 1.0);
    return found;
}

std::vector<DistanceMinimum> DistanceMinima::at_special_points(const Eigen::Vector2d& point) const
{
    std::vector<DistanceMinimum> places;
    for (const SpecialPoint& special : special_)
        if (const double distance = (special.point - point).norm(); distance <= kSamePlace * size_)
            places.push_back({special.u, distance});
    return places;
}

std::vector<DistanceMinimum> DistanceMinima::find(const Eigen::Vector2d& point, std::size_t most) const
{
    if (!point.allFinite())
        throw InputError("a point to be placed on a curve is not finite");
    if (std::vector<DistanceMinimum> special = at_special_points(point); !special.empty())
        return special;
    std::vector<double> parameters = stationary_parameters(point - origin_);
    if (parameters.empty()) // numbers so large that the coefficients overflow
        parameters.push_back(0);
    std::vector<DistanceMinimum> minima;
    for (const double u : parameters) {
        const double wrapped = curve_.closed() && u >= 1 ? 0 : u;
        minima.push_back({wrapped, (curve_.point(wrapped) - point).norm()});
    }
    std::sort(minima.begin(), minima.end(), [](const DistanceMinimum& a, const DistanceMinimum& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.u < b.u;
    });
    std::vector<DistanceMinimum> distinct;
    for (const DistanceMinimum& minimum : minima) {
        if (distinct.size() == most)
            break;
        const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const DistanceMinimum& other) {
            const double gap = std::abs(minimum.u - other.u);
            return gap < kSameParameter || (curve_.closed() && 1 - gap < kSameParameter);
        });
        if (!known)
            distinct.push_back(minimum);
    }
    return distinct;
}

} // namespace morph
