// Direct control of a mesh: gradients, pulled points, constraints.
#include "libmorph/deform/constraints.h"
#include "libmorph/deform/gradient.h"
#include "libmorph/deform/pull.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/mesh/chain.h"
#include "libmorph/weights/harmonic_curves.h"
#include "tests/bench/bench_meshes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>

namespace morph::bench {

namespace {

constexpr Index kControlPoints = 20;
constexpr Index kStations = 10;

/// A ring whose inner circle is carried by a curve of 20 control points.
struct Ring {
    Mesh mesh;
    Weights weights;
    std::vector<Index> inner;
};

Ring make_ring(Index vertices)
{
    CurveDefinition curve;
    curve.closed = true;
    curve.control_points.resize(kControlPoints, 2);
    for (Index k = 0; k < kControlPoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kControlPoints;
        curve.control_points.row(k) << std::cos(angle), std::sin(angle);
    }
    Ring ring{build_mesh(triangulated_annulus(vertices, Order::shuffled)), {}, {}};
    ring.weights = harmonic_curve_weights(ring.mesh, {{"inner", Curve(curve)}});
    ring.inner = marker_chain(marker(ring.mesh, "inner"), ring.mesh.numbering).vertices;
    return ring;
}

/// The triad of apply_bench reads and writes 24 bytes for each number: compare the bandwidths.
void BM_control_point_gradient(benchmark::State& state)
{
    constexpr Index kVertices = 1'000'000;
    const auto columns = static_cast<Index>(state.range(0));
    Weights weights;
    weights.values = Matrix::Random(kVertices, columns);
    const Matrix gradient = Matrix::Random(kVertices, 2);
    for (auto _ : state)
        benchmark::DoNotOptimize(control_point_gradient(weights, gradient));
    state.SetBytesProcessed(state.iterations() * kVertices * (columns + 2) *
                            static_cast<std::int64_t>(sizeof(double)));
}
BENCHMARK(BM_control_point_gradient)->Arg(11)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_pull_points(benchmark::State& state)
{
    const Ring ring = make_ring(100'000);
    std::vector<Index> vertices;
    for (std::size_t i = 0; i < 5; ++i)
        vertices.push_back(ring.inner[i * ring.inner.size() / 5]);
    const Matrix wanted = 0.1 * Matrix::Random(5, 2);
    for (auto _ : state) {
        const ControlledPoints pulled = controlled_vertices(ring.weights, points(ring.mesh), vertices);
        benchmark::DoNotOptimize(pull_points(pulled, wanted, Matrix::Zero(kControlPoints, 2)));
    }
}
BENCHMARK(BM_pull_points)->Unit(benchmark::kMicrosecond);

/// Area and ten stations, from the weights of the mesh to the displacements; every iteration wants another
/// move.
void satisfy(benchmark::State& state, Bound bound)
{
    const Ring ring = make_ring(static_cast<Index>(state.range(0)));
    double steps = 0;
    for (auto _ : state) {
        const Matrix wanted = 0.1 * Matrix::Random(kControlPoints, 2);
        ConstraintSet set;
        set.boundaries.push_back({"inner", controlled_vertices(ring.weights, points(ring.mesh), ring.inner)});
        set.areas.push_back({"area", 0});
        for (Index i = 0; i < kStations; ++i)
            set.thicknesses.push_back(
                {"station " + std::to_string(i), 0, {-0.8 + 1.6 * i / (kStations - 1), 0}, {0, 1}, bound});
        steps += satisfy_constraints(set, wanted).iterations;
    }
    state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
    state.counters["boundary_nodes"] = static_cast<double>(ring.inner.size());
}

void BM_area_and_thicknesses_at_least(benchmark::State& state)
{
    satisfy(state, {Bound::Kind::at_least, 1, true});
}
BENCHMARK(BM_area_and_thicknesses_at_least)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void BM_area_and_thicknesses_equal(benchmark::State& state)
{
    satisfy(state, {Bound::Kind::equal, 1, true});
}
BENCHMARK(BM_area_and_thicknesses_equal)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace

} // namespace morph::bench
