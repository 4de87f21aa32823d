// Untangling, and the harmonic solve to measure it against.

#include "libmorph/untangle/untangle.h"

#include "libmorph/geometry/mesh_domain.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/weights/harmonic.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace morph::bench {

namespace {

/// An airfoil of unit chord with a sharp trailing edge.
Curve airfoil_curve()
{
    CurveDefinition definition;
    definition.degree = 3;
    definition.closed = true;
    definition.control_points.resize(8, 2);
    definition.control_points << 1, 0, 0.7, 0.04, 0.35, 0.06, 0.05, 0.05, -0.02, 0, 0.05, -0.05, 0.35, -0.06,
        0.7, -0.04;
    definition.knots = {0, 0, 0, 1. / 6, 2. / 6, 3. / 6, 4. / 6, 5. / 6, 1};
    return Curve(definition);
}

/// The mesh around the airfoil, that turns by some degrees and moves by 0.03.
struct Airfoil {
    explicit Airfoil(Index vertices, double degrees = 10) : mesh(made(vertices)), moved(points(mesh))
    {
        for (const Marker& m : mesh.markers)
            for (const Index v : marker_vertices(m))
                held.push_back(v);
        const Eigen::Rotation2D<double> turn(degrees * std::numbers::pi / 180);
        const Eigen::Vector2d centre(0.5, 0);
        for (const Index v : marker_vertices(marker(mesh, "airfoil"))) {
            const Eigen::Vector2d from = moved.row(v).head<2>().transpose() - centre;
            moved.row(v).head<2>() = (centre + turn * from + Eigen::Vector2d(0.03, 0)).transpose();
        }
    }

    static Mesh made(Index vertices)
    {
        const double fineness = std::sqrt(vertices / 100'000.0);
        DomainSpec spec;
        spec.box = {-10, -10, 11, 10};
        spec.size = 0.4 / fineness;
        spec.growth = 0.02 / fineness;
        spec.curves.push_back({"airfoil", airfoil_curve(), static_cast<Index>(600 * fineness)});
        return build_mesh(mesh_domain(spec));
    }

    /// Plain harmonic displacement of the interior.
    Points after_harmonic() const
    {
        const Matrix move = (moved - points(mesh))(held, Eigen::all).leftCols<2>();
        const DirichletBoundary boundary{held, marker(mesh, "airfoil").edges, {}};
        const Matrix u = harmonic_extension(mesh, boundary, Diffusivity::uniform)->extend(move);
        Points x = points(mesh);
        x.leftCols<2>() += u;
        for (const Index v : held)
            x.row(v) = moved.row(v);
        return x;
    }

    Mesh mesh;
    std::vector<Index> held;
    Points moved; ///< the boundary moved, the interior left behind
};

void measure(benchmark::State& state, const Mesh& mesh, const std::vector<Index>& held, const Points& moved)
{
    UntangleResult result;
    double peak = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Points x = moved;
        const PeakMemory memory;
        state.ResumeTiming();
        result = untangle(mesh, points(mesh), held, x);
        peak = std::max(peak, static_cast<double>(memory.bytes()));
    }
    state.counters["vertices"] = vertex_count(mesh);
    state.counters["inverted_before"] = static_cast<double>(inverted_elements(mesh, moved).size());
    state.counters["inverted_after"] = static_cast<double>(result.inverted.size());
    state.counters["patch_vertices"] = result.patch_vertices;
    state.counters["bytes_a_vertex"] = peak / vertex_count(mesh);
}

void sizes(benchmark::internal::Benchmark* bench)
{
    bench->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

void BM_HarmonicSolve(benchmark::State& state)
{
    const Airfoil airfoil(static_cast<Index>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(airfoil.after_harmonic());
    state.counters["vertices"] = vertex_count(airfoil.mesh);
}
BENCHMARK(BM_HarmonicSolve)->Apply(sizes);

void BM_UntangleAfterHarmonic(benchmark::State& state)
{
    const Airfoil airfoil(static_cast<Index>(state.range(0)));
    measure(state, airfoil.mesh, airfoil.held, airfoil.after_harmonic());
}
BENCHMARK(BM_UntangleAfterHarmonic)->Apply(sizes);

void BM_UntangleInteriorLeftBehind(benchmark::State& state)
{
    const Airfoil airfoil(static_cast<Index>(state.range(0)));
    measure(state, airfoil.mesh, airfoil.held, airfoil.moved);
}
BENCHMARK(BM_UntangleInteriorLeftBehind)->Apply(sizes);

/// A quarter turn in one step: the whole mesh becomes one patch.
void BM_UntangleQuarterTurn(benchmark::State& state)
{
    const Airfoil airfoil(static_cast<Index>(state.range(0)), 90);
    measure(state, airfoil.mesh, airfoil.held, airfoil.after_harmonic());
}
BENCHMARK(BM_UntangleQuarterTurn)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Every vertex inside is thrown to a random place within 0.6 edges of its own.
void BM_UntangleNoise(benchmark::State& state)
{
    const Mesh mesh = build_mesh(triangulated_square(static_cast<Index>(state.range(0)), Order::shuffled));
    Points x = points(mesh);
    std::vector<Index> held;
    std::mt19937 random(1);
    const double size = 0.6 / std::sqrt(static_cast<double>(state.range(0)));
    std::uniform_real_distribution<double> part(0, 1);
    for (const VertexHandle v : mesh.kernel.vertices()) {
        if (mesh.kernel.is_boundary(v)) {
            held.push_back(v.idx());
            continue;
        }
        const double length = size * std::sqrt(part(random)), angle = 2 * std::numbers::pi * part(random);
        x.row(v.idx()).head<2>() += length * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
    }
    measure(state, mesh, held, x);
}
BENCHMARK(BM_UntangleNoise)->Apply(sizes);

} // namespace

} // namespace morph::bench
