// Applying a move against the memory bandwidth of the same run: 1M x 11 weights, 2 components.
#include "libmorph/core/parallel.h"
#include "libmorph/deform/apply.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace morph;

constexpr Index kVertices = 1'000'000;
constexpr Index kControlPoints = 11;

/// McCalpin's STREAM triad a = b + s c on three arrays of 128 MB, with the library's threads.
void BM_triad(benchmark::State& state)
{
    const std::size_t n = 16'000'000;
    std::vector<double> a(n);
    std::vector<double> b(n, 1.0);
    std::vector<double> c(n, 2.0);
    for (auto _ : state) {
        parallel_for(n, 262'144, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                a[i] = b[i] + 3.0 * c[i];
        });
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * n * sizeof(double)));
}
BENCHMARK(BM_triad)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);

/// Bytes: the weights once, the coordinates read and written.
void BM_apply_weights(benchmark::State& state)
{
    Weights weights;
    weights.values = Matrix::Random(kVertices, kControlPoints);
    const Matrix moves = Matrix::Random(kControlPoints, 2);
    Points positions = Points::Random(kVertices, 3);
    for (auto _ : state)
        apply_weights(weights, moves, {positions.data(), kVertices, 3});
    state.SetBytesProcessed(state.iterations() * kVertices * (kControlPoints + 6) *
                            static_cast<std::int64_t>(sizeof(double)));
}
BENCHMARK(BM_apply_weights)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);

} // namespace
