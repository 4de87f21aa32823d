// Carrying fields from one mesh to another: locating and interpolating, sorting and any index included.
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/interpolate.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/remap_inputs.h"

#include <benchmark/benchmark.h>

namespace morph::bench {
namespace {

/// As many random targets as the source has vertices; a scalar and a vector field.
void BM_LocateAndInterpolate(benchmark::State& state)
{
    const auto size = static_cast<Index>(state.range(0));
    const Mesh source = source_mesh(size);
    const Points targets = random_points(size);
    const std::vector<const Field*> fields{&source.fields[0], &source.fields[1]};
    std::size_t peak = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        const ContainingElements found = Locator(source).locate(targets);
        benchmark::DoNotOptimize(interpolate(source, found, targets, fields, QuadRule::bilinear));
        peak = memory.bytes();
    }
    state.counters["ns/target"] =
        benchmark::Counter(size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["B/target"] = static_cast<double>(peak) / size;
}

/// From the arrays of a file: the halfedge structure and its numbering along the curve included.
void BM_BuildLocateAndInterpolate(benchmark::State& state)
{
    const auto size = static_cast<Index>(state.range(0));
    const MeshData data = source_data(size);
    const Points targets = random_points(size);
    for (auto _ : state) {
        state.PauseTiming();
        MeshData copy = data;
        state.ResumeTiming();
        const Mesh source = build_mesh(std::move(copy));
        const std::vector<const Field*> fields{&source.fields[0], &source.fields[1]};
        const ContainingElements found = Locator(source).locate(targets);
        benchmark::DoNotOptimize(interpolate(source, found, targets, fields, QuadRule::bilinear));
    }
}

void BM_LocateOnly(benchmark::State& state)
{
    const auto size = static_cast<Index>(state.range(0));
    const Mesh source = source_mesh(size);
    const Points targets = random_points(size);
    for (auto _ : state)
        benchmark::DoNotOptimize(Locator(source).locate(targets));
}

void BM_BuildElementTree(benchmark::State& state)
{
    const Mesh source = source_mesh(static_cast<Index>(state.range(0)));
    std::size_t peak = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        benchmark::DoNotOptimize(ElementTree(source).containing(0.5, 0.5));
        peak = memory.bytes();
    }
    state.counters["B/vertex"] = static_cast<double>(peak) / static_cast<double>(state.range(0));
}

void BM_AskElementTree(benchmark::State& state)
{
    const Mesh source = source_mesh(static_cast<Index>(state.range(0)));
    const Points targets = random_points(1000000);
    const ElementTree tree(source);
    Index i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(tree.containing(targets(i, 0), targets(i, 1)));
        i = (i + 1) % static_cast<Index>(targets.rows());
    }
}

BENCHMARK(BM_LocateAndInterpolate)
    ->Arg(16000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(4000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_BuildLocateAndInterpolate)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_LocateOnly)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_BuildElementTree)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_AskElementTree)->Arg(1000000);

} // namespace
} // namespace morph::bench
