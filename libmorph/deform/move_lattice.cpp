#include "libmorph/deform/move_lattice.h"

#include "libmorph/basis/tensor_sum.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <array>
#include <optional>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // points

/// What a point moves by, from the sums at its parameters.
enum class Move {
    sum,        ///< A: the sums of displacements
    quotient,   ///< A / w: the sums of (w D, w)
    difference, ///< A / w - B / z: the sums of (A, w, B, z), of the lattice moved to and of the one before
};

template <Move move, int dimension>
constexpr int kComponents = move == Move::sum        ? dimension
                            : move == Move::quotient ? dimension + 1
                                                     : 2 * (dimension + 1);

template <Move move, int dimension, typename Sum>
Eigen::Matrix<double, dimension, 1> moved_by(const Sum& sum)
{
    if constexpr (move == Move::sum)
        return sum;
    else if constexpr (move == Move::quotient)
        return sum.template head<dimension>() / sum[dimension];
    else
        return sum.template head<dimension>() / sum[dimension] -
               sum.template segment<dimension>(dimension + 1) / sum[2 * dimension + 1];
}

/// Moves runs of points: four at once where they lie in one span, as neighbours mostly do.
template <Move move, int dimension, int degree>
class Mover {
public:
    Mover(const Lattice& lattice, const TensorNet& net, const Embedding& embedding,
          Eigen::Map<Points>& positions)
        : sum_(lattice, net), embedding_(embedding), positions_(positions)
    {
    }

    [[gnu::always_inline]] void move_run(std::size_t begin, std::size_t end) const
    {
        std::size_t i = begin;
        for (; i + kPack <= end; i += kPack)
            if (const auto span = common_span(i))
                move_four(i, *span);
            else
                for (std::size_t l = 0; l < kPack; ++l)
                    move_one(i + l);
        for (; i < end; ++i)
            move_one(i);
    }

#if defined(__x86_64__)
    /// The same for processors with registers of four numbers. Products and sums are rounded one by one here
    /// too, so that the bytes are the same.
    [[gnu::target("avx2")]] void move_run_wide(std::size_t begin, std::size_t end) const
    {
        move_run(begin, end);
    }
#endif

private:
    static constexpr int kSums = kComponents<move, dimension>;
    using Sum = Eigen::Matrix<double, kSums, 1>;

    const double* parameters(std::size_t i) const
    {
        return embedding_.parameters.data() + 3 * i;
    }

    std::optional<std::array<int, 3>> common_span(std::size_t first) const
    {
        for (std::size_t l = 0; l < kPack; ++l)
            if (embedding_.inside[first + l] == 0)
                return std::nullopt;
        const std::array<int, 3> span = sum_.span(parameters(first));
        for (std::size_t l = 1; l < kPack; ++l)
            if (sum_.span(parameters(first + l)) != span)
                return std::nullopt;
        return span;
    }

    void add(std::size_t i, const Sum& sum) const
    {
        Eigen::Map<Eigen::Matrix<double, dimension, 1>>(positions_.data() + 3 * i) +=
            moved_by<move, dimension>(sum);
    }

    [[gnu::always_inline]] void move_four(std::size_t first, const std::array<int, 3>& span) const
    {
        std::array<Pack, kSums> sums;
        sum_.values(span, parameters(first), sums);
        for (std::size_t l = 0; l < kPack; ++l) {
            Sum sum;
            for (int c = 0; c < kSums; ++c)
                sum[c] = sums[static_cast<std::size_t>(c)][l];
            add(first + l, sum);
        }
    }

    void move_one(std::size_t i) const
    {
        if (embedding_.inside[i] == 0)
            return;
        TensorPoint at;
        sum_.template functions<false>(parameters(i), at);
        add(i, sum_.value(at));
    }

    TensorSum<dimension, kSums, degree> sum_;
    const Embedding& embedding_;
    Eigen::Map<Points>& positions_;
};

using Run = void (*)(const Lattice&, const TensorNet&, const Embedding&, Eigen::Map<Points>&);

template <Move move, int dimension, int degree>
void run(const Lattice& lattice, const TensorNet& net, const Embedding& embedding,
         Eigen::Map<Points>& positions)
{
    const Mover<move, dimension, degree> mover(lattice, net, embedding, positions);
    parallel_for(embedding.inside.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2") != 0)
            return mover.move_run_wide(begin, end);
#endif
        mover.move_run(begin, end);
    });
}

template <Move move, int dimension>
Run compiled_for(int degree)
{
    switch (degree) {
    case 1:
        return run<move, dimension, 1>;
    case 2:
        return run<move, dimension, 2>;
    case 3:
        return run<move, dimension, 3>;
    default:
        return run<move, dimension, SplineAxis::kAnyDegree>;
    }
}

template <Move move>
void move_points(const Lattice& lattice, const Matrix& values, const Embedding& embedding,
                 Eigen::Map<Points>& positions)
{
    const int degree = common_degree(lattice);
    const Run run = lattice.dimension() == 2 ? compiled_for<move, 2>(degree) : compiled_for<move, 3>(degree);
    run(lattice, tensor_net(lattice, values), embedding, positions);
}

void require_fit(const Embedding& embedding, Eigen::Index points)
{
    if (embedding.parameters.rows() != points || std::ssize(embedding.inside) != points)
        throw InputError("the parameters are those of " + std::to_string(embedding.parameters.rows()) +
                         " points, but there are " + std::to_string(points));
}

void require_same_basis(const Lattice& from, const Lattice& to)
{
    if (from.dimension() != to.dimension())
        throw InputError("a lattice of dimension " + std::to_string(from.dimension()) +
                         " cannot become one of dimension " + std::to_string(to.dimension()));
    for (int d = 0; d < from.dimension(); ++d)
        if (from.axis(d).degree() != to.axis(d).degree() || from.axis(d).knots() != to.axis(d).knots())
            throw InputError("the lattices differ in degree, number of control points or knots along " +
                             std::string(1, "ijk"[d]) + "; only control points and weights may");
}

/// (w (P - origin), w), with w = 1 where the lattice has no weights.
Matrix with_weights(const Lattice& lattice, const Eigen::Vector3d& origin)
{
    Matrix A = homogeneous_points(lattice, origin);
    if (lattice.rational())
        return A;
    Matrix with_ones(A.rows(), A.cols() + 1);
    with_ones << A, Eigen::VectorXd::Ones(A.rows());
    return with_ones;
}

} // namespace

void move_by_lattice(const Lattice& lattice, const Embedding& embedding, const Matrix& displacements,
                     Eigen::Map<Points> positions)
{
    require_fit(embedding, positions.rows());
    if (displacements.rows() != lattice.control_point_count() || displacements.cols() != lattice.dimension())
        throw InputError("the displacements are " + std::to_string(displacements.rows()) + " x " +
                         std::to_string(displacements.cols()) + ", but the lattice has " +
                         std::to_string(lattice.control_point_count()) + " control points in " +
                         std::to_string(lattice.dimension()) + " dimensions");
    if (!lattice.rational())
        return move_points<Move::sum>(lattice, displacements, embedding, positions);
    const Eigen::Map<const Eigen::VectorXd> w(lattice.definition().weights.data(), displacements.rows());
    Matrix weighted(displacements.rows(), displacements.cols() + 1);
    weighted << w.asDiagonal() * displacements, w;
    move_points<Move::quotient>(lattice, weighted, embedding, positions);
}

void move_by_lattice(const Lattice& from, const Lattice& to, const Embedding& embedding,
                     Eigen::Map<Points> positions)
{
    require_fit(embedding, positions.rows());
    require_same_basis(from, to);
    // Far from the origin rounding is that of the lattice's size, not of the coordinates.
    const Eigen::Vector3d origin = from.definition().control_points.row(0).transpose();
    const Matrix after = with_weights(to, origin);
    const Matrix before = with_weights(from, origin);
    Matrix both(after.rows(), 2 * after.cols());
    both << after, before;
    move_points<Move::difference>(from, both, embedding, positions);
}

} // namespace morph
