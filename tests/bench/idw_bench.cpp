// Inverse distance weighting as in the thesis: the 100 nearest known points, power 5, tree included.
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/nearest_points.h"
#include "libmorph/remap/inverse_distance.h"
#include "tests/bench/remap_inputs.h"

#include <benchmark/benchmark.h>

namespace morph::bench {

namespace {

/// Run with the threads of this benchmark, and count what one unknown point takes.
template <typename Run>
void measure(benchmark::State& state, const Cloud& points, const Run& run)
{
    set_thread_count(static_cast<int>(state.range(1)));
    for (auto _ : state)
        run();
    set_thread_count(0);
    state.counters["s/point"] =
        benchmark::Counter(static_cast<double>(points.unknown.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

Cloud input(const benchmark::State& state)
{
    return cloud(static_cast<Place>(state.range(0)));
}

/// A scalar and a vector at once: neighbours and weights are found once for all columns.
void BM_InverseDistance(benchmark::State& state)
{
    const Cloud points = input(state);
    std::vector<Matrix> values{points.values.leftCols(1), points.values.rightCols(3)};
    measure(state, points, [&] {
        fill_by_inverse_distance(points.positions, points.known, points.unknown, {}, values);
        benchmark::DoNotOptimize(values[0].data());
    });
}
BENCHMARK(BM_InverseDistance)
    ->ArgNames({"around", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The part of it that looks for neighbours.
void BM_HundredNearest(benchmark::State& state)
{
    const Cloud points = input(state);
    const Points known = points.positions(points.known, Eigen::all);
    const Points unknown = points.positions(points.unknown, Eigen::all);
    measure(state, points, [&] {
        NearestPoints(known).nearest(unknown, 100,
                                     [](Index, auto found) { benchmark::DoNotOptimize(found.data()); });
    });
}
BENCHMARK(BM_HundredNearest)
    ->ArgNames({"around", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_BuildNearestPoints(benchmark::State& state)
{
    const Points points = random_points(static_cast<Index>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(NearestPoints(points));
}
BENCHMARK(BM_BuildNearestPoints)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace

} // namespace morph::bench
