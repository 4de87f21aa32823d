#include "tests/support/lattices.h"

#include <Eigen/Geometry>

#include <random>
#include <utility>

namespace morph::test {

namespace {

/// Numbers in [low, high), the same everywhere, unlike those of the distributions.
class Numbers {
public:
    explicit Numbers(std::uint32_t seed) : bits_(seed) {}
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0);
    }

private:
    std::mt19937 bits_;
};

/// Clamped knots over [0, 1] whose spans differ by up to a factor of three.
std::vector<double> uneven_knots(int degree, Index points, Numbers& random)
{
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    for (Index s = 0; s < points - degree; ++s)
        knots.push_back(knots.back() + random.between(0.5, 1.5));
    for (double& knot : knots)
        knot /= knots.back();
    knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
    return knots;
}

/// A lattice whose lines of control points along one direction are to be replaced by longer ones.
class Refined {
public:
    using Line = std::vector<Eigen::Vector4d>; ///< (w x, w y, w z, w)

    Refined(const Lattice& lattice, int direction) : lattice_(lattice), direction_(direction) {}

    template <typename Refine>
    Lattice with(LatticeDefinition shape, const Refine& refine) const
    {
        const auto d = static_cast<std::size_t>(direction_);
        const Index count = shape.points[0] * shape.points[1] * shape.points[2];
        shape.control_points.resize(count, 3);
        shape.weights.assign(static_cast<std::size_t>(count), 1.0);
        std::array<Index, 3> at{};
        std::array<Index, 3> ends = shape.points;
        ends[d] = 1;
        for (at[2] = 0; at[2] < ends[2]; ++at[2])
            for (at[1] = 0; at[1] < ends[1]; ++at[1])
                for (at[0] = 0; at[0] < ends[0]; ++at[0])
                    put(shape, at, refine(line(at)));
        if (!lattice_.rational())
            shape.weights.clear();
        return Lattice(std::move(shape));
    }

private:
    Line line(std::array<Index, 3> at) const
    {
        const LatticeDefinition& old = lattice_.definition();
        const auto d = static_cast<std::size_t>(direction_);
        Line line;
        for (at[d] = 0; at[d] < old.points[d]; ++at[d]) {
            const Index row = lattice_.row_of(at[0], at[1], at[2]);
            const double w = lattice_.rational() ? old.weights[static_cast<std::size_t>(row)] : 1;
            line.emplace_back();
            line.back() << w * old.control_points.row(row).transpose(), w;
        }
        return line;
    }

    void put(LatticeDefinition& shape, std::array<Index, 3> at, const Line& line) const
    {
        const auto d = static_cast<std::size_t>(direction_);
        for (at[d] = 0; at[d] < shape.points[d]; ++at[d]) {
            const Index row = at[0] + shape.points[0] * (at[1] + shape.points[1] * at[2]);
            const Eigen::Vector4d& A = line[static_cast<std::size_t>(at[d])];
            shape.control_points.row(row) = A.head<3>().transpose() / A[3];
            shape.weights[static_cast<std::size_t>(row)] = A[3];
        }
    }

    const Lattice& lattice_;
    int direction_;
};

} // namespace

LatticeDefinition uneven_shape(int dimension, LatticeBasis basis, int degree, Index points, bool rational,
                               std::uint32_t seed)
{
    Numbers random(seed);
    LatticeDefinition shape;
    shape.dimension = dimension;
    shape.basis = basis;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
        const bool bernstein = basis == LatticeBasis::bernstein;
        shape.degree[d] = degree;
        shape.points[d] = bernstein ? degree + 1 : points + static_cast<Index>(d);
        if (!bernstein)
            shape.knots[d] = uneven_knots(degree, shape.points[d], random);
    }
    if (dimension == 2)
        shape.points[2] = 1;
    if (rational)
        for (Index row = 0; row < shape.points[0] * shape.points[1] * shape.points[2]; ++row)
            shape.weights.push_back(random.between(0.5, 2));
    return shape;
}

Lattice deformed_lattice(const LatticeDefinition& shape, double amount, std::uint32_t seed)
{
    const Eigen::AngleAxisd turn(0.7, shape.dimension == 2 ? Eigen::Vector3d::UnitZ().eval()
                                                           : Eigen::Vector3d(1, 2, 3).normalized());
    const Eigen::Matrix3d axes = turn.toRotationMatrix() * Eigen::Vector3d(2, 1.5, 1).asDiagonal();
    const Lattice box = lattice_on_axes({10, -20, 5}, axes, shape);
    Numbers random(seed);
    Points P = box.definition().control_points;
    for (Index row = 0; row < box.control_point_count(); ++row) {
        Eigen::Vector3d shift = Eigen::Vector3d::Zero();
        for (int d = 0; d < shape.dimension; ++d)
            shift +=
                random.between(-amount, amount) / shape.points[static_cast<std::size_t>(d)] * axes.col(d);
        P.row(row) += shift.transpose();
    }
    return box.with_control_points(P);
}

std::vector<Lattice> all_kinds_of_lattices()
{
    std::vector<Lattice> lattices;
    for (const int dimension : {2, 3})
        for (const bool rational : {false, true}) {
            // Embedding in rational lattices of high degree in space takes seconds.
            const int highest = dimension == 3 && rational ? 2 : 9;
            for (const int degree : {1, 2, 3, 5})
                if (degree <= highest)
                    lattices.push_back(deformed_lattice(
                        uneven_shape(dimension, LatticeBasis::bspline, degree, degree + 3, rational), 0.2));
            for (const int degree : {1, 2, 3, 9})
                if (degree <= highest)
                    lattices.push_back(deformed_lattice(
                        uneven_shape(dimension, LatticeBasis::bernstein, degree, 0, rational), 0.2));
        }
    return lattices;
}

std::string kind(const Lattice& lattice)
{
    return std::to_string(lattice.dimension()) + "D " +
           (lattice.definition().basis == LatticeBasis::bspline ? "B-splines" : "Bernstein polynomials") +
           " of degree " + std::to_string(lattice.definition().degree[0]) +
           (lattice.rational() ? ", rational" : "");
}

Embedded random_embedded(const Lattice& lattice, Index count, std::uint32_t seed)
{
    Numbers random(seed);
    Embedded embedded{Points::Zero(count, 3), Points(count, 3)};
    for (Index i = 0; i < count; ++i) {
        for (int d = 0; d < lattice.dimension(); ++d)
            embedded.parameters(i, d) = random.between(0, 1);
        embedded.positions.row(i) = lattice.point(embedded.parameters.row(i).transpose()).transpose();
    }
    return embedded;
}

Lattice with_knot(const Lattice& lattice, int direction, double u)
{
    const SplineAxis& axis = lattice.axis(direction);
    const int p = axis.degree();
    const int span = axis.span(u);
    const auto d = static_cast<std::size_t>(direction);
    LatticeDefinition shape = lattice.definition();
    shape.knots[d] = axis.knots();
    shape.knots[d].insert(shape.knots[d].begin() + span + 1, u);
    ++shape.points[d];
    return Refined(lattice, direction).with(std::move(shape), [&](const Refined::Line& old) {
        Refined::Line line(old.begin(), old.begin() + (span - p + 1));
        for (int i = span - p + 1; i <= span; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const double low = axis.knots()[at];
            const double share = (u - low) / (axis.knots()[at + static_cast<std::size_t>(p)] - low);
            line.push_back(share * old[at] + (1 - share) * old[at - 1]);
        }
        line.insert(line.end(), old.begin() + span, old.end());
        return line;
    });
}

Lattice with_degree_elevated(const Lattice& lattice, int direction)
{
    const auto d = static_cast<std::size_t>(direction);
    LatticeDefinition shape = lattice.definition();
    ++shape.degree[d];
    ++shape.points[d];
    return Refined(lattice, direction).with(std::move(shape), [](const Refined::Line& old) {
        Refined::Line line{old.front()};
        const auto n = static_cast<double>(old.size());
        for (std::size_t i = 1; i < old.size(); ++i)
            line.push_back(static_cast<double>(i) / n * old[i - 1] +
                           (1 - static_cast<double>(i) / n) * old[i]);
        line.push_back(old.back());
        return line;
    });
}

} // namespace morph::test
