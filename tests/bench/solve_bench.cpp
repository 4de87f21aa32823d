// From a mesh to solved harmonic weights: all of it, its stages, and the same system by Eigen's
// SimplicialLDLT with AMD, which is what libigl's harmonic() runs.

#include "libmorph/geometry/segment_tree.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/numerics/dirichlet_laplacian.h"
#include "libmorph/numerics/sparse_cholesky.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"
#include "tests/support/harmonic.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

namespace morph::bench {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;
constexpr Index kColumns = 11; // right-hand sides

void every_size(benchmark::internal::Benchmark* bench)
{
    for (const Index vertices : {16'000, 100'000, 1'000'000, 4'000'000})
        bench->Arg(vertices);
    bench->ArgName("vertices")->Unit(benchmark::kMillisecond)->UseManualTime();
}

/// A ring as a mesh generator leaves it.
Mesh input(const benchmark::State& state)
{
    return build_mesh(triangulated_annulus(static_cast<Index>(state.range(0)), Order::shuffled));
}

/// Bumps around the inner circle, one for each column, 0 on the outer.
test::BoundaryValues problem(const Mesh& mesh)
{
    test::BoundaryValues made;
    for (const Marker& m : mesh.markers)
        for (const Index v : marker_vertices(m))
            made.boundary.vertices.push_back(v);
    made.boundary.moving_edges = marker(mesh, "inner").edges;
    made.values.resize(static_cast<Index>(made.boundary.vertices.size()), kColumns);
    for (Index i = 0; i < made.values.rows(); ++i) {
        const auto at = points(mesh).row(made.boundary.vertices[static_cast<std::size_t>(i)]);
        const double angle = std::atan2(at[1], at[0]);
        for (Index k = 0; k < kColumns; ++k)
            made.values(i, k) =
                at.norm() > 2 ? 0 : std::pow(std::cos(0.5 * angle - std::numbers::pi * k / kColumns), 2);
    }
    return made;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time, and peak memory beyond what was there before, of one stage.
template <typename Run>
void measure(benchmark::State& state, const Run& run)
{
    double peak = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        const auto start = std::chrono::steady_clock::now();
        auto result = run();
        state.SetIterationTime(seconds_since(start));
        benchmark::DoNotOptimize(result);
        peak = std::max(peak, static_cast<double>(memory.bytes()));
    }
    state.counters["peak_MiB"] = peak / kMiB;
}

void whole(benchmark::State& state, Diffusivity diffusivity)
{
    const Mesh mesh = input(state);
    const test::BoundaryValues made = problem(mesh);
    measure(state, [&] { return test::harmonic_functions(mesh, made, diffusivity); });
}

void BM_HarmonicWeights(benchmark::State& state)
{
    whole(state, Diffusivity::uniform);
}
BENCHMARK(BM_HarmonicWeights)->Apply(every_size);

void BM_HarmonicWeightsInverseDistance(benchmark::State& state)
{
    whole(state, Diffusivity::inverse_distance);
}
BENCHMARK(BM_HarmonicWeightsInverseDistance)->Apply(every_size);

void BM_Delaunay(benchmark::State& state)
{
    const Mesh mesh = input(state);
    measure(state, [&] {
        Triangulation triangulation = triangulate(mesh);
        make_delaunay(points(mesh), triangulation);
        return triangulation;
    });
}
BENCHMARK(BM_Delaunay)->Apply(every_size);

Triangulation delaunay(const Mesh& mesh)
{
    Triangulation triangulation = triangulate(mesh);
    make_delaunay(points(mesh), triangulation);
    return triangulation;
}

void BM_StiffnessEdges(benchmark::State& state)
{
    const Mesh mesh = input(state);
    const Triangulation triangulation = delaunay(mesh);
    measure(state, [&] { return stiffness_edges(points(mesh), triangulation); });
}
BENCHMARK(BM_StiffnessEdges)->Apply(every_size);

void BM_AssembleOrderFactor(benchmark::State& state)
{
    const Mesh mesh = input(state);
    const std::vector<WeightedEdge> edges = stiffness_edges(points(mesh), delaunay(mesh));
    const test::BoundaryValues made = problem(mesh);
    measure(state, [&] { return DirichletLaplacian(points(mesh), edges, made.boundary.vertices); });
}
BENCHMARK(BM_AssembleOrderFactor)->Apply(every_size);

/// A grid of rows as a matrix of its own, to time what works on a matrix.
struct GridMatrix {
    explicit GridMatrix(Index rows)
    {
        const auto side = static_cast<Index>(std::sqrt(rows));
        A.diagonal.assign(static_cast<std::size_t>(side * side), 6.0);
        A.start.push_back(0);
        where.resize(side * side, 2);
        for (Index i = 0; i < side * side; ++i) {
            add_row(i, side);
            where.row(i) << i % side, i / side;
        }
    }

    void add_row(Index i, Index side)
    {
        const Index x = i % side, y = i / side;
        const std::array<std::array<Index, 2>, 6> steps{{{-1, -1}, {0, -1}, {-1, 0}, {1, 0}, {0, 1}, {1, 1}}};
        for (const auto& [dx, dy] : steps)
            if (x + dx >= 0 && x + dx < side && y + dy >= 0 && y + dy < side) {
                A.column.push_back(i + dx + side * dy);
                A.value.push_back(-1);
            }
        A.start.push_back(A.column.size());
    }

    SymmetricMatrix A;
    Points2 where;
};

void BM_NestedDissection(benchmark::State& state)
{
    const GridMatrix grid(static_cast<Index>(state.range(0)));
    measure(state, [&] { return nested_dissection(grid.A, grid.where); });
}
BENCHMARK(BM_NestedDissection)->Apply(every_size);

void BM_SparseCholesky(benchmark::State& state)
{
    const GridMatrix grid(static_cast<Index>(state.range(0)));
    const Dissection dissection = nested_dissection(grid.A, grid.where);
    measure(state, [&] { return SparseCholesky(grid.A, dissection); });
    state.counters["stored"] = static_cast<double>(SparseCholesky(grid.A, dissection).stored());
}
BENCHMARK(BM_SparseCholesky)->Apply(every_size);

void BM_SolveAllColumns(benchmark::State& state)
{
    const Mesh mesh = input(state);
    const test::BoundaryValues made = problem(mesh);
    const DirichletLaplacian factored(points(mesh), stiffness_edges(points(mesh), delaunay(mesh)),
                                      made.boundary.vertices);
    measure(state, [&] { return factored.solve(made.values); });
}
BENCHMARK(BM_SolveAllColumns)->Apply(every_size);

void BM_DistanceToMovingEdges(benchmark::State& state)
{
    const Mesh mesh = input(state);
    const SegmentTree tree(points(mesh), marker(mesh, "inner").edges);
    measure(state, [&] {
        double sum = 0;
        SegmentTree::Nearest nearest;
        for (Index v = 0; v < vertex_count(mesh); ++v) {
            nearest = tree.nearest(points(mesh)(v, 0), points(mesh)(v, 1), nearest.segment);
            sum += nearest.distance;
        }
        return sum;
    });
}
BENCHMARK(BM_DistanceToMovingEdges)->Apply(every_size);

/// The peer: K from the file's triangles and numbering, held rows taken out, LDL^T with AMD.
Matrix eigens_weights(const Mesh& mesh, const test::BoundaryValues& made)
{
    const Eigen::SparseMatrix<double> K =
        stiffness_matrix(vertex_count(mesh), stiffness_edges(points(mesh), triangulate(mesh)));
    std::vector<Index> row(static_cast<std::size_t>(K.rows()), 0);
    Matrix all = Matrix::Zero(K.rows(), kColumns);
    for (Index i = 0; i < made.values.rows(); ++i) {
        row[static_cast<std::size_t>(made.boundary.vertices[static_cast<std::size_t>(i)])] = -1;
        all.row(made.boundary.vertices[static_cast<std::size_t>(i)]) = made.values.row(i);
    }
    Index next = 0;
    for (Index& r : row)
        r = r < 0 ? r : next++;
    const Matrix flux = -(K * all);
    std::vector<Eigen::Triplet<double>> entries;
    for (Index j = 0; j < K.cols(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator e(K, j); e; ++e)
            if (row[static_cast<std::size_t>(e.row())] >= 0 && row[static_cast<std::size_t>(j)] >= 0)
                entries.emplace_back(row[static_cast<std::size_t>(e.row())], row[static_cast<std::size_t>(j)],
                                     e.value());
    Eigen::SparseMatrix<double> free(next, next);
    free.setFromTriplets(entries.begin(), entries.end());
    Matrix right(next, kColumns);
    for (Index v = 0; v < K.rows(); ++v)
        if (row[static_cast<std::size_t>(v)] >= 0)
            right.row(row[static_cast<std::size_t>(v)]) = flux.row(v);
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(free).solve(right);
}

void BM_EigenLdlt(benchmark::State& state)
{
    const Mesh mesh = input(state);
    const test::BoundaryValues made = problem(mesh);
    measure(state, [&] { return eigens_weights(mesh, made); });
}
BENCHMARK(BM_EigenLdlt)
    ->Arg(16'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->ArgName("vertices")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(1);

} // namespace

} // namespace morph::bench
