// Carrying the move of a boundary into the mesh without solving for every vertex: radial functions at centres
// chosen from 20,000 boundary vertices, inverse distance, damping, and the boundary's rotations on top of
// harmonic functions.

#include "libmorph/deform/rigid_frames.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/damping.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/idw.h"
#include "libmorph/weights/rbf_greedy.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/meshes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace morph::bench {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

/// A ring whose whole boundary is held; the inner circle turns and gets waves.
struct Ring {
    Mesh mesh;
    DirichletBoundary held;
    Matrix displacement;

    explicit Ring(MeshData data)
        : mesh(build_mesh((shuffle(data), std::move(data)))), held(test::dirichlet_boundary(mesh, {"inner"})),
          displacement(test::boundary_displacement(mesh, held, [](double x, double y) {
              const double angle = std::atan2(y, x);
              const double wave = 0.01 * std::sin(20 * angle) + 0.0005 * std::sin(400 * angle);
              return Eigen::RowVector2d(test::turn(20, {0.3, 0})(x, y) + wave * Eigen::RowVector2d(x, y));
          }))
    {
    }
};

/// 10,000 vertices around, so that 20,000 are held, and 1M in all.
Ring fine_ring()
{
    return Ring(test::annulus(1, 10, 10'000, 99));
}

Ring ring(const benchmark::State& state)
{
    return Ring(triangulated_annulus(static_cast<Index>(state.range(0)), Order::sorted));
}

/// Time, and peak memory beyond what was there before.
template <typename Run>
void measure(benchmark::State& state, const Run& run)
{
    double peak = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        const auto start = std::chrono::steady_clock::now();
        auto result = run();
        state.SetIterationTime(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        benchmark::DoNotOptimize(result);
        peak = std::max(peak, static_cast<double>(memory.bytes()));
    }
    state.counters["peak_MiB"] = peak / kMiB;
}

void every_size(benchmark::internal::Benchmark* bench)
{
    for (const Index vertices : {16'000, 100'000, 1'000'000})
        bench->Arg(vertices);
    bench->ArgName("vertices")->Unit(benchmark::kMillisecond)->UseManualTime()->MeasureProcessCPUTime();
}

/// Some 2,000 of 20,000.
std::vector<Index> centres(const Ring& ring)
{
    return greedy_centres(ring.mesh, ring.held, ring.displacement, {}, {.tolerance = 3.5e-5});
}

void BM_GreedyCentres(benchmark::State& state)
{
    const Ring ring = fine_ring();
    std::size_t count = 0;
    measure(state, [&] {
        std::vector<Index> chosen = centres(ring);
        count = chosen.size();
        return chosen;
    });
    state.counters["centres"] = static_cast<double>(count);
}
BENCHMARK(BM_GreedyCentres)->Unit(benchmark::kMillisecond)->UseManualTime()->MeasureProcessCPUTime();

void BM_RbfFromCentres(benchmark::State& state)
{
    const Ring ring = fine_ring();
    const std::vector<Index> chosen = centres(ring);
    measure(state,
            [&] { return rbf_extension(ring.mesh, ring.held, {}, chosen)->extend(ring.displacement); });
    state.counters["centres"] = static_cast<double>(chosen.size());
}
BENCHMARK(BM_RbfFromCentres)->Unit(benchmark::kMillisecond)->UseManualTime()->MeasureProcessCPUTime();

void BM_RbfAllCentres(benchmark::State& state)
{
    const Ring r = ring(state);
    measure(state, [&] { return rbf_extension(r.mesh, r.held)->extend(r.displacement); });
}
BENCHMARK(BM_RbfAllCentres)->Apply(every_size);

void BM_InverseDistanceOfTheBoundary(benchmark::State& state)
{
    const Ring r = ring(state);
    measure(state, [&] { return idw_extension(r.mesh, r.held)->extend(r.displacement); });
}
BENCHMARK(BM_InverseDistanceOfTheBoundary)->Apply(every_size);

void BM_Damping(benchmark::State& state)
{
    const Ring r = ring(state);
    measure(state, [&] { return damping_extension(r.mesh, r.held)->extend(r.displacement); });
}
BENCHMARK(BM_Damping)->Apply(every_size);

void BM_HarmonicWithRotations(benchmark::State& state)
{
    const Ring r = ring(state);
    measure(state, [&] {
        const auto extension = harmonic_extension(r.mesh, r.held, Diffusivity::inverse_distance);
        return extend_with_rotations(*extension, r.mesh, r.held, r.displacement);
    });
}
BENCHMARK(BM_HarmonicWithRotations)->Apply(every_size);

} // namespace

} // namespace morph::bench
