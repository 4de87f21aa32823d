#include "libmorph/weights/lattice_piece.h"

#include "libmorph/basis/bezier.h"

#include <Eigen/LU>

#include <algorithm>
#include <span>

namespace morph {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Bernstein coefficients over [0, 1] to those over [begin, end], by de Casteljau's algorithm twice.
void cut(std::span<Eigen::Vector4d> line, double begin, double end)
{
    const std::size_t count = line.size();
    for (std::size_t level = 1; level < count; ++level)
        for (std::size_t k = 0; k + level < count; ++k)
            line[k] = (1 - begin) * line[k] + begin * line[k + 1];
    const double share = (end - begin) / (1 - begin);
    for (std::size_t level = 1; level < count; ++level)
        for (std::size_t k = count; k-- > level;)
            line[k] = (1 - share) * line[k - 1] + share * line[k];
}

/// B-spline coefficients of a span to the Bernstein coefficients over [begin, end].
void to_bernstein(const SplineAxis& axis, int span, double begin, double end, std::span<Eigen::Vector4d> line)
{
    std::array<Eigen::Vector4d, kMaxDegree + 1> local;
    std::array<Eigen::Vector4d, kMaxDegree + 1> whole;
    for (std::size_t lasts = 0; lasts < line.size(); ++lasts) {
        std::copy(line.begin(), line.end(), local.begin());
        whole[lasts] = bernstein_coefficient(axis.knots(), span, begin, end, static_cast<int>(lasts),
                                             std::span(local).first(line.size()));
    }
    std::copy_n(whole.begin(), line.size(), line.begin());
}

} // namespace

LatticePiece::LatticePiece(const Lattice& lattice, const std::array<int, 3>& span, const Eigen::Vector3d& low,
                           const Eigen::Vector3d& high)
    : dimension_(lattice.dimension()), sides_(high - low)
{
    take_window(lattice, span);
    for (int d = 0; d < dimension_; ++d) {
        const SplineAxis& axis = lattice.axis(d);
        if (axis.point_count() == axis.degree() + 1)
            along_lines(d, [&](std::span<Coefficient> line) { cut(line, low[d], high[d]); });
        else
            along_lines(d, [&](std::span<Coefficient> line) {
                to_bernstein(axis, span[index(d)], low[d], high[d], line);
            });
    }
}

/// The control points that the span depends on.
void LatticePiece::take_window(const Lattice& lattice, const std::array<int, 3>& span)
{
    std::array<int, 3> first{};
    for (int d = 0; d < 3; ++d) {
        counts_[index(d)] = lattice.axis(d).degree() + 1;
        first[index(d)] = span[index(d)] - lattice.axis(d).degree();
    }
    const LatticeDefinition& given = lattice.definition();
    net_.reserve(index(counts_[0] * counts_[1] * counts_[2]));
    for (int k = 0; k < counts_[2]; ++k)
        for (int j = 0; j < counts_[1]; ++j)
            for (int i = 0; i < counts_[0]; ++i) {
                const Index row = lattice.row_of(first[0] + i, first[1] + j, first[2] + k);
                const double w = lattice.rational() ? given.weights[index(row)] : 1;
                net_.emplace_back();
                net_.back() << w * given.control_points.row(row).transpose(), w;
            }
}

/// Call work(line) for the lines of coefficients along a direction; what it leaves in the line is put back.
template <typename Work>
void LatticePiece::along_lines(int direction, const Work& work)
{
    std::array<Coefficient, kMaxLatticeDegree + 1> line;
    const std::size_t count = index(counts_[index(direction)]);
    std::size_t step = 1;
    for (int d = 0; d < direction; ++d)
        step *= index(counts_[index(d)]);
    for (std::size_t block = 0; block < net_.size(); block += step * count)
        for (std::size_t first = block; first < block + step; ++first) {
            for (std::size_t i = 0; i < count; ++i)
                line[i] = net_[first + i * step];
            work(std::span(line).first(count));
            for (std::size_t i = 0; i < count; ++i)
                net_[first + i * step] = line[i];
        }
}

const LatticePiece::Coefficient& LatticePiece::coefficient(int i, int j, int k) const
{
    return net_[index(i + counts_[0] * (j + counts_[1] * k))];
}

Eigen::AlignedBox3d LatticePiece::box() const
{
    Eigen::AlignedBox3d box;
    for (const Coefficient& A : net_)
        box.extend(Eigen::Vector3d(A.head<3>() / A[3]));
    return box;
}

double LatticePiece::variation(const Eigen::Vector3d& middle, const Eigen::Matrix3d& inverse) const
{
    // S_a = (B_a - (S - middle) w_a) / w with B = A - middle w, a subscript meaning the derivative: each
    // factor lies between the least and the greatest of its coefficients.
    const Eigen::Matrix3d M = sides_.cwiseInverse().asDiagonal() * inverse;
    double least = net_[0][3];
    double most = least;
    for (const Coefficient& A : net_) {
        least = std::min(least, A[3]);
        most = std::max(most, A[3]);
    }
    const Eigen::AlignedBox3d image = box();
    const Eigen::Vector3d reach =
        M.cwiseAbs() * (image.max() - middle).cwiseAbs().cwiseMax((image.min() - middle).cwiseAbs());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int a = 0; a < dimension_; ++a) {
        const std::array<int, 3> to{a == 0, a == 1, a == 2};
        Eigen::Vector3d bound = Eigen::Vector3d::Zero();
        double steepest = 0;
        for (int k = 0; k + to[2] < counts_[2]; ++k)
            for (int j = 0; j + to[1] < counts_[1]; ++j)
                for (int i = 0; i + to[0] < counts_[0]; ++i) {
                    const Coefficient slope =
                        (counts_[index(a)] - 1) *
                        (coefficient(i + to[0], j + to[1], k + to[2]) - coefficient(i, j, k));
                    const Eigen::Vector3d B = M * (slope.head<3>() - slope[3] * middle);
                    for (const double w : {least, most})
                        bound = bound.cwiseMax((B / w - Eigen::Vector3d::Unit(a)).cwiseAbs());
                    steepest = std::max(steepest, std::abs(slope[3]));
                }
        sum += bound + reach * (steepest / least);
    }
    return sum.head(dimension_).maxCoeff();
}

Eigen::Matrix3d LatticePiece::corner_jacobian(const std::array<int, 3>& at) const
{
    const Coefficient& A = coefficient(at[0], at[1], at[2]);
    Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
    for (int a = 0; a < dimension_; ++a) {
        std::array<int, 3> next = at;
        const int inward = at[index(a)] == 0 ? 1 : -1;
        next[index(a)] += inward;
        const Coefficient slope =
            inward * (counts_[index(a)] - 1) * (coefficient(next[0], next[1], next[2]) - A);
        J.col(a) = (slope.head<3>() - slope[3] / A[3] * A.head<3>()) / A[3];
    }
    return J;
}

std::vector<Eigen::Matrix3d> LatticePiece::corner_jacobians() const
{
    std::vector<Eigen::Matrix3d> jacobians;
    for (int corner = 0; corner < 1 << dimension_; ++corner) {
        std::array<int, 3> at{};
        for (int d = 0; d < dimension_; ++d)
            at[index(d)] = (corner >> d) % 2 == 0 ? 0 : counts_[index(d)] - 1;
        jacobians.push_back(corner_jacobian(at));
    }
    return jacobians;
}

} // namespace morph
