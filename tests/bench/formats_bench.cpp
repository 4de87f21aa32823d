// Reading and writing of mesh files. The file lies in memory (/dev/shm), so that no disk is measured.
//   formats_bench --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
#include "formats/formats.h"
#include "tests/bench/bench_meshes.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

using namespace morph;

/// A mesh of a million vertices and two million triangles in a file that goes with this.
struct LargeFile {
    std::string path = "/dev/shm/morph_formats_bench.su2";
    MeshData mesh = bench::triangulated_annulus(1000000, bench::Order::shuffled);

    LargeFile() { write_mesh_data(mesh, path); }
    ~LargeFile() { std::filesystem::remove(path); }
    LargeFile(const LargeFile&) = delete;
    LargeFile& operator=(const LargeFile&) = delete;
};

const LargeFile& large_file()
{
    static const LargeFile file;
    return file;
}

void report_bytes(benchmark::State& state, const std::string& path)
{
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void BM_ReadSu2(benchmark::State& state)
{
    const LargeFile& file = large_file();
    for (auto _ : state)
        benchmark::DoNotOptimize(read_mesh_data(file.path));
    report_bytes(state, file.path);
}

void BM_WriteSu2(benchmark::State& state)
{
    const LargeFile& file = large_file();
    for (auto _ : state)
        benchmark::DoNotOptimize(write_mesh_data(file.mesh, file.path));
    report_bytes(state, file.path);
}

/// What the machine does at best: the same bytes copied from the page cache into memory already touched.
void BM_CopyFile(benchmark::State& state)
{
    const LargeFile& file = large_file();
    std::vector<char> bytes(std::filesystem::file_size(file.path));
    for (auto _ : state) {
        std::ifstream in(file.path, std::ios::binary);
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        benchmark::DoNotOptimize(bytes.data());
    }
    report_bytes(state, file.path);
}

/// A million points with three scalar fields: five columns of numbers of full length.
struct LargeTable {
    std::string path = "/dev/shm/morph_formats_bench.csv";
    MeshData mesh;

    LargeTable()
    {
        mesh.points = bench::triangulated_annulus(1000000, bench::Order::shuffled).points;
        const auto x = mesh.points.col(0).array(), y = mesh.points.col(1).array();
        mesh.fields = {{"density", FieldLocation::vertex, (x * x + y).matrix()},
                       {"pressure", FieldLocation::vertex, (1e5 * x.sin()).matrix()},
                       {"temperature", FieldLocation::vertex, (300 + y.cos()).matrix()}};
        write_mesh_data(mesh, path);
    }
    ~LargeTable() { std::filesystem::remove(path); }
    LargeTable(const LargeTable&) = delete;
    LargeTable& operator=(const LargeTable&) = delete;
};

const LargeTable& large_table()
{
    static const LargeTable table;
    return table;
}

void BM_ReadCsv(benchmark::State& state)
{
    const LargeTable& table = large_table();
    for (auto _ : state)
        benchmark::DoNotOptimize(read_mesh_data(table.path));
    report_bytes(state, table.path);
}

void BM_WriteCsv(benchmark::State& state)
{
    const LargeTable& table = large_table();
    for (auto _ : state)
        benchmark::DoNotOptimize(write_mesh_data(table.mesh, table.path));
    report_bytes(state, table.path);
}

BENCHMARK(BM_ReadSu2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WriteSu2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadCsv)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WriteCsv)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CopyFile)->Unit(benchmark::kMillisecond);

} // namespace
