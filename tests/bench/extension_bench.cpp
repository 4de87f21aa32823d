// Methods that carry boundary displacements into the mesh: from the mesh to the factored system, and one
// move.

#include "libmorph/mesh/builder.h"
#include "libmorph/weights/biharmonic.h"
#include "libmorph/weights/elasticity.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/spring.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace morph::bench {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

void every_size(benchmark::internal::Benchmark* bench)
{
    for (const Index vertices : {16'000, 100'000, 1'000'000})
        bench->Arg(vertices);
    bench->ArgName("vertices")->Unit(benchmark::kMillisecond)->UseManualTime()->MinTime(0.1);
}

/// A ring as a mesh generator leaves it, both circles held and the inner one moving.
struct Ring {
    explicit Ring(const benchmark::State& state)
        : mesh(build_mesh(triangulated_annulus(static_cast<Index>(state.range(0)), Order::shuffled)))
    {
        for (const Marker& m : mesh.markers)
            for (const Index v : marker_vertices(m))
                held.vertices.push_back(v);
        held.moving_edges = marker(mesh, "inner").edges;
    }

    /// The inner circle turns by a radian.
    Points2 turn() const
    {
        Points2 move = points(mesh)(held.vertices, {1, 0});
        move.col(0) *= -1;
        for (Index i = 0; i < move.rows(); ++i)
            if (move.row(i).norm() > 2)
                move.row(i).setZero();
        return move;
    }

    Mesh mesh;
    DirichletBoundary held;
};

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

auto harmonic(const Ring& ring)
{
    return harmonic_extension(ring.mesh, ring.held, Diffusivity::inverse_distance);
}

auto spring(const Ring& ring)
{
    return spring_extension(ring.mesh, ring.held, SpringStiffness::inverse_length_squared);
}

auto torsion(const Ring& ring)
{
    return braced_spring_extension(ring.mesh, ring.held, SpringStiffness::inverse_length_squared,
                                   SpringBracing::torsion);
}

auto ball_vertex(const Ring& ring)
{
    return braced_spring_extension(ring.mesh, ring.held, SpringStiffness::inverse_length_squared,
                                   SpringBracing::ball_vertex);
}

auto elasticity(const Ring& ring)
{
    return elastic_extension(ring.mesh, ring.held, {});
}

auto biharmonic(const Ring& ring)
{
    return biharmonic_extension(ring.mesh, ring.held);
}

auto conformal_biharmonic(const Ring& ring)
{
    return conformal_biharmonic_extension(ring.mesh, ring.held);
}

template <auto Make>
void BM_Factor(benchmark::State& state)
{
    const Ring ring(state);
    measure(state, [&] { return Make(ring); });
}

template <auto Make>
void BM_Move(benchmark::State& state)
{
    const Ring ring(state);
    const auto extension = Make(ring);
    const Points2 turn = ring.turn();
    measure(state, [&] { return extension->extend(turn); });
}

BENCHMARK(BM_Factor<harmonic>)->Apply(every_size);
BENCHMARK(BM_Factor<spring>)->Apply(every_size);
BENCHMARK(BM_Factor<torsion>)->Apply(every_size);
BENCHMARK(BM_Factor<ball_vertex>)->Apply(every_size);
BENCHMARK(BM_Factor<elasticity>)->Apply(every_size);
BENCHMARK(BM_Factor<biharmonic>)->Apply(every_size);
BENCHMARK(BM_Factor<conformal_biharmonic>)->Apply(every_size);
BENCHMARK(BM_Move<harmonic>)->Apply(every_size);
BENCHMARK(BM_Move<spring>)->Apply(every_size);
BENCHMARK(BM_Move<torsion>)->Apply(every_size);
BENCHMARK(BM_Move<ball_vertex>)->Apply(every_size);
BENCHMARK(BM_Move<elasticity>)->Apply(every_size);
BENCHMARK(BM_Move<biharmonic>)->Apply(every_size);
BENCHMARK(BM_Move<conformal_biharmonic>)->Apply(every_size);

} // namespace

} // namespace morph::bench
