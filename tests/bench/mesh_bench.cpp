// Building the halfedge structure: build_mesh() against OpenMesh's own add_face().

#include "libmorph/mesh/builder.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peak_memory.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace morph::bench {

namespace {

constexpr double kMiB = 1024.0 * 1024.0;

void every_size(benchmark::internal::Benchmark* bench)
{
    for (const Index vertices : {16'000, 100'000, 1'000'000, 4'000'000})
        for (const Order order : {Order::sorted, Order::shuffled})
            bench->Args({vertices, static_cast<int>(order)});
    bench->ArgNames({"vertices", "shuffled"})->Unit(benchmark::kMillisecond);
}

MeshData input(const benchmark::State& state)
{
    return triangulated_square(static_cast<Index>(state.range(0)), static_cast<Order>(state.range(1)));
}

Kernel with_add_face(const MeshData& data)
{
    Kernel kernel;
    const auto vertices = static_cast<std::size_t>(data.points.rows());
    kernel.reserve(vertices, vertices + data.elements.size(), data.elements.size()); // Euler: one edge less
    for (Index i = 0; i < data.points.rows(); ++i)
        kernel.add_vertex({data.points(i, 0), data.points(i, 1), data.points(i, 2)});
    for (const Element& e : data.elements)
        kernel.add_face(VertexHandle(e[0]), VertexHandle(e[1]), VertexHandle(e[2]));
    return kernel;
}

/// Time and memory, beyond the input, of one way of building.
template <typename Build>
void measure(benchmark::State& state, const Build& build)
{
    const MeshData data = input(state);
    double peak = 0;
    for (auto _ : state) {
        MeshData copy = data;
        const PeakMemory memory;
        const auto start = std::chrono::steady_clock::now();
        auto mesh = build(std::move(copy));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        benchmark::DoNotOptimize(mesh);
        state.SetIterationTime(seconds.count());
        peak = std::max(peak, static_cast<double>(memory.bytes()));
    }
    state.counters["peak_MiB"] = peak / kMiB;
}

void BM_BuildMesh(benchmark::State& state)
{
    measure(state, [](MeshData data) { return build_mesh(std::move(data)); });
}
BENCHMARK(BM_BuildMesh)->Apply(every_size)->UseManualTime();

void BM_AddFace(benchmark::State& state)
{
    measure(state, [](const MeshData& data) { return with_add_face(data); });
}
BENCHMARK(BM_AddFace)->Apply(every_size)->UseManualTime();

void BM_ElementTable(benchmark::State& state)
{
    const Mesh mesh = build_mesh(input(state));
    for (auto _ : state) {
        const std::vector<Element> table = element_table(mesh);
        benchmark::DoNotOptimize(table.data());
    }
}
BENCHMARK(BM_ElementTable)->Apply(every_size)->UseRealTime();

void BM_ToData(benchmark::State& state)
{
    const Mesh mesh = build_mesh(input(state));
    for (auto _ : state) {
        const MeshData data = to_mesh_data(mesh);
        benchmark::DoNotOptimize(data.points.data());
    }
}
BENCHMARK(BM_ToData)->Apply(every_size)->UseRealTime();

} // namespace

} // namespace morph::bench
