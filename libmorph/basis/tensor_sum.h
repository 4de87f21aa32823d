#pragma once

#include "libmorph/basis/lattice.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace morph {

/// The control points of a lattice as one run of numbers: component c of the point (i, j, k) is
/// values[c + components * i + line * j + layer * k].
struct TensorNet {
    int components = 0;
    std::ptrdiff_t line = 0;
    std::ptrdiff_t layer = 0;
    std::vector<double> values;
};

/// @param values  N x components, rows as the control points
TensorNet tensor_net(const Lattice& lattice, const Matrix& values);

/// (w (P - origin), w) of each control point: N x dimension + 1; without weights P - origin alone.
Matrix homogeneous_points(const Lattice& lattice, const Eigen::Vector3d& origin);

/// 1, 2 or 3 where all directions have that degree, else SplineAxis::kAnyDegree: what TensorSum is compiled
/// for.
int common_degree(const Lattice& lattice);

/// The functions of the three directions at one point.
struct TensorPoint {
    std::array<int, 3> first{}; ///< the first control point along i, j, k that they belong to
    std::array<AxisValues, 3> value;
    std::array<AxisValues, 3> slope; ///< filled where derivatives are asked for
};

/// A number for each of four points, for processors that compute with four at a time.
using Pack = double __attribute__((vector_size(4 * sizeof(double))));
inline constexpr int kPack = 4;

/// Sums over the control points around a point, one direction after the other (sum factorisation): j and k
/// act on whole lines of control points along i, which lie together in memory and fill the registers.
///
/// @tparam dimension   2 or 3
/// @tparam components  numbers per control point
/// @tparam degree      of every direction where it is known when this is compiled; SplineAxis::kAnyDegree
template <int dimension, int components, int degree>
class TensorSum {
public:
    using Sum = Eigen::Matrix<double, components, 1>;

    /// @param lattice, net  outlive this
    TensorSum(const Lattice& lattice, const TensorNet& net) : lattice_(lattice), net_(net)
    {
        for (int d = 0; d < 3; ++d)
            counts_[index(d)] = lattice.axis(d).degree() + 1;
    }

    /// Fill @p at for the parameters @p u; with @p slopes also the derivatives.
    /// @param u  in [0, 1]
    template <bool slopes>
    void functions(const double* u, TensorPoint& at) const
    {
        for (int d = 0; d < dimension; ++d)
            functions<slopes>(d, lattice_.axis(d).span(u[d]), u[d], at);
    }

    /// The same on the polynomials of a given span, also outside it.
    template <bool slopes>
    void functions(const std::array<int, 3>& span, const double* u, TensorPoint& at) const
    {
        for (int d = 0; d < dimension; ++d)
            functions<slopes>(d, span[index(d)], u[d], at);
    }

    Sum value(const TensorPoint& at) const
    {
        const double* line = first(at);
        Line sum = zero();
        for (int k = 0; k < count(2); ++k, line += net_.layer) {
            Line along = zero();
            for (int j = 0; j < count(1); ++j)
                along += at.value[1][index(j)] * map(line + j * net_.line);
            add(sum, at.value[2][index(k)], along);
        }
        return dot(sum, at.value[0]);
    }

    /// The values at four points of one span, each as value() but for the order of the sums.
    /// @param span        of all four
    /// @param parameters  of four points, three numbers each
    [[gnu::always_inline]] void values(const std::array<int, 3>& span, const double* parameters,
                                       std::array<Pack, components>& total) const
    {
        std::array<std::array<Pack, kFunctions>, dimension> functions;
        const double* layer = net_.values.data();
        for (int d = 0; d < dimension; ++d) {
            const double* u = parameters + d;
            lattice_.axis(d).template evaluate<degree, false, Pack>(
                span[index(d)], Pack{u[0], u[3], u[6], u[9]}, functions[index(d)].data());
            layer += (span[index(d)] - (count(d) - 1)) * (d == 0   ? components
                                                          : d == 1 ? net_.line
                                                                   : net_.layer);
        }
        total = {};
        for (int k = 0; k < count(2); ++k, layer += net_.layer) {
            std::array<Pack, components> of_layer{};
            for (int j = 0; j < count(1); ++j) {
                std::array<Pack, components> of_line{};
                const double* value = layer + j * net_.line;
                for (int i = 0; i < count(0); ++i)
                    for (std::size_t c = 0; c < components; ++c)
                        of_line[c] += functions[0][index(i)] * *value++;
                for (std::size_t c = 0; c < components; ++c)
                    of_layer[c] += functions[1][index(j)] * of_line[c];
            }
            for (std::size_t c = 0; c < components; ++c)
                if constexpr (dimension == 2)
                    total[c] = of_layer[c];
                else
                    total[c] += functions[2][index(k)] * of_layer[c];
        }
    }

    /// The spans of a point.
    std::array<int, 3> span(const double* u) const
    {
        std::array<int, 3> at{};
        for (int d = 0; d < dimension; ++d)
            at[index(d)] = lattice_.axis(d).span(u[d]);
        return at;
    }

    /// The value and its derivatives along i, j and (in space) k.
    void derivatives(const TensorPoint& at, Sum& value, std::array<Sum, dimension>& slopes) const
    {
        const double* line = first(at);
        Line sum = zero();
        Line slope_j = zero();
        Line slope_k = zero();
        for (int k = 0; k < count(2); ++k, line += net_.layer) {
            Line along = zero();
            Line along_j = zero();
            for (int j = 0; j < count(1); ++j) {
                along += at.value[1][index(j)] * map(line + j * net_.line);
                along_j += at.slope[1][index(j)] * map(line + j * net_.line);
            }
            add(sum, at.value[2][index(k)], along);
            add(slope_j, at.value[2][index(k)], along_j);
            if constexpr (dimension == 3)
                slope_k += at.slope[2][index(k)] * along;
        }
        value = dot(sum, at.value[0]);
        slopes[0] = dot(sum, at.slope[0]);
        slopes[1] = dot(slope_j, at.value[0]);
        if constexpr (dimension == 3)
            slopes[2] = dot(slope_k, at.value[0]);
    }

private:
    static constexpr bool kFixed = degree != SplineAxis::kAnyDegree;
    static constexpr std::size_t kFunctions =
        static_cast<std::size_t>(kFixed ? degree : kMaxLatticeDegree) + 1;
    static constexpr int kLength = kFixed ? components * (degree + 1) : Eigen::Dynamic;
    static constexpr int kLongest = kFixed ? kLength : components * (kMaxLatticeDegree + 1);
    using Line = Eigen::Array<double, kLength, 1, 0, kLongest, 1>;

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    template <bool slopes>
    void functions(int d, int span, double u, TensorPoint& at) const
    {
        at.first[index(d)] = span - (count(d) - 1);
        lattice_.axis(d).template evaluate<degree, slopes>(span, u, at.value[index(d)].data(),
                                                           at.slope[index(d)].data());
    }

    int count(int d) const
    {
        if (d == 2 && dimension == 2)
            return 1;
        return kFixed ? degree + 1 : counts_[index(d)];
    }

    Line zero() const { return Line::Zero(components * count(0)); }

    Eigen::Map<const Line> map(const double* line) const
    {
        return Eigen::Map<const Line>(line, components * count(0));
    }

    const double* first(const TensorPoint& at) const
    {
        return net_.values.data() + std::ptrdiff_t{at.first[0]} * components + at.first[1] * net_.line +
               at.first[2] * net_.layer;
    }

    /// In the plane there is one layer, with the factor 1.
    static void add(Line& sum, double factor, const Line& line)
    {
        if constexpr (dimension == 2)
            sum = line;
        else
            sum += factor * line;
    }

    Sum dot(const Line& line, const AxisValues& factors) const
    {
        Sum sum = Sum::Zero();
        for (int i = 0; i < count(0); ++i)
            sum += factors[index(i)] * line.template segment<components>(i * components).matrix();
        return sum;
    }

    const Lattice& lattice_;
    const TensorNet& net_;
    std::array<int, 3> counts_{};
};

} // namespace morph
