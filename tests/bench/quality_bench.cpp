// The full quality report and the safe step: time per mesh, against one pass of plain signed areas over the
// same elements.
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/full_quality.h"
#include "libmorph/quality/quality.h"
#include "libmorph/quality/safe_step.h"
#include "libmorph/quality/wall.h"
#include "tests/bench/bench_meshes.h"

#include <benchmark/benchmark.h>

namespace morph::bench {
namespace {

const Mesh& mesh_of(Index vertices)
{
    static Mesh mesh;
    static Index built = 0;
    if (built != vertices) {
        mesh = build_mesh(triangulated_square(vertices, Order::shuffled));
        built = vertices;
    }
    return mesh;
}

void BM_QualityReport(benchmark::State& state)
{
    const Mesh& mesh = mesh_of(static_cast<Index>(state.range(0)));
    set_thread_count(static_cast<int>(state.range(1)));
    for (auto _ : state)
        benchmark::DoNotOptimize(quality_report(mesh));
    set_thread_count(0);
    state.SetItemsProcessed(state.iterations() * element_count(mesh));
}

void BM_QualityReportWithReference(benchmark::State& state)
{
    const Mesh& mesh = mesh_of(static_cast<Index>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(quality_report(mesh, points(mesh), points(mesh)));
    state.SetItemsProcessed(state.iterations() * element_count(mesh));
}

/// All that morph-quality reports: the worst elements' places and the cells next to the walls too.
void BM_FullReportWithReference(benchmark::State& state)
{
    const Mesh& mesh = mesh_of(static_cast<Index>(state.range(0)));
    const PositionsView reference = points(mesh);
    for (auto _ : state) {
        const QualityReport report = quality_report(mesh, points(mesh), reference);
        for (const WorstElement& worst : report.worst)
            benchmark::DoNotOptimize(element_place(mesh, points(mesh), worst.face));
        benchmark::DoNotOptimize(wall_quality(mesh, points(mesh), &reference));
    }
    state.SetItemsProcessed(state.iterations() * element_count(mesh));
}

/// 0 a smooth move that turns nothing over, 1 a reflection that turns over two thirds of the elements, 2 half
/// a turn, where all elements collapse at about the same time and rounding decides which is the first.
Points moved(const Mesh& mesh, int move)
{
    Points after = points(mesh);
    for (Index v = 0; v < after.rows(); ++v) {
        const double x = after(v, 0), y = after(v, 1);
        if (move == 0)
            after.row(v) << x + 0.1 * x * y, y + 0.1, 0;
        else if (move == 1)
            after.row(v) << y, x * (1 - 1.5 * y), 0;
        else
            after.row(v) << 0.7 - x, 0.3 - y, 0;
    }
    return after;
}

void BM_SafeStep(benchmark::State& state)
{
    const Mesh& mesh = mesh_of(static_cast<Index>(state.range(0)));
    const Points after = moved(mesh, static_cast<int>(state.range(2)));
    set_thread_count(static_cast<int>(state.range(1)));
    for (auto _ : state)
        benchmark::DoNotOptimize(safe_step(mesh, points(mesh), after));
    set_thread_count(0);
    state.SetItemsProcessed(state.iterations() * element_count(mesh));
}

/// The peer: only the signed areas, which is what a check that cannot see dented quads computes.
void BM_SignedAreas(benchmark::State& state)
{
    const Mesh& mesh = mesh_of(static_cast<Index>(state.range(0)));
    const auto position = points(mesh);
    for (auto _ : state) {
        double sum = 0;
        for (Index f = 0; f < element_count(mesh); ++f) {
            const Element e = element_corners(mesh, f);
            sum += (position(e[1], 0) - position(e[0], 0)) * (position(e[2], 1) - position(e[0], 1)) -
                   (position(e[1], 1) - position(e[0], 1)) * (position(e[2], 0) - position(e[0], 0));
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * element_count(mesh));
}

// 500k vertices are one million triangles.
BENCHMARK(BM_QualityReport)
    ->Args({500000, 1})
    ->Args({500000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_QualityReportWithReference)->Args({500000})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_FullReportWithReference)->Args({500000})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_SafeStep)
    ->Args({500000, 1, 0})
    ->Args({500000, 2, 0})
    ->Args({500000, 2, 1})
    ->Args({500000, 2, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_SignedAreas)->Args({500000})->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace morph::bench
