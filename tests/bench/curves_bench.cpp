// Closest parameters of the nodes of a boundary, and the fit of a curve to them.

#include "libmorph/basis/closest.h"
#include "libmorph/basis/fit.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace morph::bench {

namespace {

/// A closed curve of radius about 1 with five bulges.
Curve bulgy_curve(Index control_points)
{
    CurveDefinition curve;
    curve.closed = true;
    curve.control_points.resize(control_points, 2);
    for (Index i = 0; i < control_points; ++i) {
        const double angle = 2 * std::numbers::pi * i / control_points;
        const double radius = 1 + 0.3 * std::cos(5 * angle);
        curve.control_points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return Curve(curve);
}

Points2 nodes_on(const Curve& curve, Index count)
{
    Points2 nodes(count, 2);
    for (Index i = 0; i < count; ++i)
        nodes.row(i) = curve.point(static_cast<double>(i) / count);
    return nodes;
}

void BM_NodeParameters(benchmark::State& state)
{
    const Curve curve = bulgy_curve(static_cast<Index>(state.range(1)));
    const Points2 nodes = nodes_on(curve, static_cast<Index>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(node_parameters(curve, nodes, true));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_NodeParameters)
    ->ArgsProduct({{1'000, 10'000, 100'000}, {12, 40, 400}})
    ->ArgNames({"nodes", "control_points"})
    ->Unit(benchmark::kMillisecond);

void BM_FitCurve(benchmark::State& state)
{
    const Points2 nodes = nodes_on(bulgy_curve(60), static_cast<Index>(state.range(0)));
    FitSettings settings;
    settings.control_points = static_cast<Index>(state.range(1));
    for (auto _ : state)
        benchmark::DoNotOptimize(fit_curve(nodes, true, settings));
}
BENCHMARK(BM_FitCurve)
    ->ArgsProduct({{200, 10'000}, {12, 40}})
    ->ArgNames({"nodes", "control_points"})
    ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace morph::bench
