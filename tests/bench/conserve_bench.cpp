// Conservative remap between two different meshes of the unit square, end to end.
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/conserve_cells.h"
#include "libmorph/remap/conserve_nodes.h"
#include "libmorph/remap/supermesh.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace morph::bench {
namespace {

/// Source and target: triangles, about @p elements in each, in grids that do not match: the source's has
/// fewer rows, and its vertices are pushed aside.
std::pair<Mesh, Mesh> two_squares(Index elements)
{
    MeshData source = triangulated_square(elements / 2 - elements / 50, Order::shuffled);
    for (Index v = 0; v < source.points.rows(); ++v) {
        double &x = source.points(v, 0), &y = source.points(v, 1);
        const double bump = 0.05 * std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y);
        x += bump;
        y -= bump;
    }
    return {build_mesh(std::move(source)), build_mesh(triangulated_square(elements / 2, Order::shuffled))};
}

using Conserve = Transfer (*)(const Locator&, const Mesh&, const Matrix&);

/// A scalar field, as many elements in the target as in the source; the locator is made each time.
void measure(benchmark::State& state, Conserve conserve, FieldLocation location)
{
    const auto elements = static_cast<Index>(state.range(0));
    const auto [source, target] = two_squares(elements);
    const Index rows = location == FieldLocation::vertex ? vertex_count(source) : element_count(source);
    const Matrix values = Matrix::Random(rows, 1);
    std::size_t peak = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        benchmark::DoNotOptimize(conserve(Locator(source), target, values));
        peak = memory.bytes();
    }
    state.counters["ns/element"] = benchmark::Counter(
        elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["B/element"] = static_cast<double>(peak) / elements;
}

void BM_ConserveCells(benchmark::State& state)
{
    measure(state, conserve_cells, FieldLocation::element);
}

void BM_ConserveNodes(benchmark::State& state)
{
    measure(state, conserve_nodes, FieldLocation::vertex);
}

/// Finding and clipping what overlaps, without doing anything with it.
void BM_OverlapsOnly(benchmark::State& state)
{
    const auto [source, target] = two_squares(static_cast<Index>(state.range(0)));
    std::size_t pairs = 0;
    for (auto _ : state) {
        const Locator locator(source);
        const Supermesh overlaps(locator, target, Cut::triangles);
        pairs = 0;
        overlaps.visit(0, static_cast<std::size_t>(element_count(target)),
                       [&](const SupermeshCell& piece) { pairs += piece.covers.size(); });
    }
    state.counters["pairs/element"] = static_cast<double>(pairs) / static_cast<double>(state.range(0));
}

void sizes(benchmark::internal::Benchmark* bench)
{
    for (const int elements : {16000, 100000, 1000000, 4000000})
        bench->Arg(elements);
    bench->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(BM_ConserveCells)->Apply(sizes);
BENCHMARK(BM_ConserveNodes)->Apply(sizes);
BENCHMARK(BM_OverlapsOnly)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace morph::bench
