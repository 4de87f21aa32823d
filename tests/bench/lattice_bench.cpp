// Free-form deformation: finding the parameters of points in a lattice and moving them with it.
#include "libmorph/core/parallel.h"
#include "libmorph/core/space_curve.h"
#include "libmorph/deform/move_lattice.h"
#include "libmorph/weights/embed.h"
#include "libmorph/weights/lattice_weights.h"

#include <benchmark/benchmark.h>

#include <array>

namespace {

using namespace morph;

constexpr Index kPoints = 1'000'000;

enum class Order { along_a_curve, random };

/// Points in the unit square or cube, numbered at random or as the vertices of a Mesh are.
Points unit_points(int dimension, Order order)
{
    Points points = 0.5 * (Points::Random(kPoints, 3).array() + 1).matrix();
    if (dimension == 2)
        points.col(2).setZero();
    if (order == Order::random)
        return points;
    return points(hilbert_order(points, dimension), Eigen::all);
}

/// Cubic B-splines or Bernstein polynomials in the unit square or cube, each control point moved by up to 0.3
/// of the mean distance.
Lattice unit_lattice(int dimension, LatticeBasis basis, Index points, double moved)
{
    LatticeDefinition shape;
    shape.dimension = dimension;
    shape.basis = basis;
    shape.points = {points, points, dimension == 2 ? 1 : points};
    const Lattice box = lattice_in_box({0, 0, 0}, {1, 1, 1}, shape);
    Points shift = moved / points * Points::Random(box.control_point_count(), 3);
    return box.with_control_points(box.definition().control_points + shift);
}

/// u^i (1 - u)^(3 - i) times the binomial coefficient, for all points at once.
std::array<Eigen::ArrayXd, 4> cubic_bernstein(const Eigen::ArrayXd& u)
{
    return {(1 - u).cube(), 3 * u * (1 - u).square(), 3 * u.square() * (1 - u), u.cube()};
}

/// The passes of PyGeM's FFD (pygem/ffd.py): for each control point a product of full-length arrays, and for
/// each component another one and its sum, every one of them a pass over memory as in NumPy.
void full_length_passes(const Points& u, const Matrix& D, Points& X)
{
    const std::array<std::array<Eigen::ArrayXd, 4>, 3> B = {
        cubic_bernstein(u.col(0)), cubic_bernstein(u.col(1)), cubic_bernstein(u.col(2))};
    std::array<Eigen::ArrayXd, 3> shift;
    shift.fill(Eigen::ArrayXd::Zero(u.rows()));
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < 4; ++k) {
            const Eigen::ArrayXd of_jk = B[1][j] * B[2][k];
            for (std::size_t i = 0; i < 4; ++i) {
                const Eigen::ArrayXd of_ijk = B[0][i] * of_jk;
                for (int c = 0; c < 3; ++c) {
                    const Eigen::ArrayXd part = of_ijk * D(static_cast<Index>(i + 4 * (j + 4 * k)), c);
                    shift[static_cast<std::size_t>(c)] += part;
                }
            }
        }
    for (int c = 0; c < 3; ++c)
        X.col(c).array() += shift[static_cast<std::size_t>(c)];
}

void BM_FullLengthPasses(benchmark::State& state)
{
    const Points u = unit_points(3, Order::along_a_curve);
    const Matrix D = Matrix::Random(64, 3);
    Points X = u;
    for (auto _ : state)
        full_length_passes(u, D, X);
}
BENCHMARK(BM_FullLengthPasses)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_MoveByLattice(benchmark::State& state)
{
    const auto basis = static_cast<LatticeBasis>(state.range(0));
    const auto points = static_cast<Index>(state.range(1));
    const Lattice lattice = unit_lattice(3, basis, points, 0);
    Points X = unit_points(3, static_cast<Order>(state.range(2)));
    const Embedding embedding = embed(lattice, X);
    const Matrix D = Matrix::Random(lattice.control_point_count(), 3);
    set_thread_count(static_cast<int>(state.range(3)));
    for (auto _ : state)
        move_by_lattice(lattice, embedding, D, {X.data(), X.rows(), 3});
    set_thread_count(0);
}
BENCHMARK(BM_MoveByLattice)
    ->ArgNames({"bernstein", "points", "random", "threads"})
    ->ArgsProduct({{1}, {4}, {0, 1}, {1, 2}})
    ->ArgsProduct({{0}, {4, 10, 40}, {0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_Embed(benchmark::State& state)
{
    const auto dimension = static_cast<int>(state.range(0));
    const auto points = static_cast<Index>(state.range(1));
    const Lattice lattice = unit_lattice(dimension, LatticeBasis::bspline, points, 0.3);
    const Points X = unit_points(dimension, static_cast<Order>(state.range(2)));
    set_thread_count(static_cast<int>(state.range(3)));
    Index inside = 0;
    for (auto _ : state)
        inside = embed(lattice, X).inside_count;
    set_thread_count(0);
    state.counters["inside"] = inside;
    state.counters["parts"] = static_cast<double>(LatticeTree(lattice).parts().size());
}
BENCHMARK(BM_Embed)
    ->ArgNames({"dimension", "points", "random", "threads"})
    ->ArgsProduct({{2, 3}, {4, 10}, {0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_LatticeWeights(benchmark::State& state)
{
    const auto dimension = static_cast<int>(state.range(0));
    const Lattice lattice =
        unit_lattice(dimension, LatticeBasis::bspline, static_cast<Index>(state.range(1)), 0);
    const Points X = unit_points(dimension, Order::along_a_curve);
    const Embedding embedding = embed(lattice, X);
    SparseWeights weights;
    for (auto _ : state)
        weights = lattice_weights(lattice, embedding);
    constexpr double kEntry = sizeof(double) + sizeof(Index);
    state.counters["bytes_a_vertex"] = kEntry * static_cast<double>(weights.values.nonZeros()) / kPoints;
    state.counters["dense_bytes"] = sizeof(double) * static_cast<double>(lattice.control_point_count());
}
BENCHMARK(BM_LatticeWeights)
    ->ArgNames({"dimension", "points"})
    ->ArgsProduct({{2, 3}, {4, 10, 20}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_LatticeTree(benchmark::State& state)
{
    const Lattice lattice = unit_lattice(static_cast<int>(state.range(0)), LatticeBasis::bspline, 10, 0.3);
    for (auto _ : state)
        benchmark::DoNotOptimize(LatticeTree(lattice));
}
BENCHMARK(BM_LatticeTree)->ArgName("dimension")->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
