// What remap_bench measures, done by VTK in the same run: vtkProbeFilter locates and interpolates,
// vtkPointInterpolator with a vtkShepardKernel weighs by inverse distance. Building their locators counts.
#include "tests/bench/remap_inputs.h"

#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCellArray.h>
#include <vtkCellLocatorStrategy.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointInterpolator.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkShepardKernel.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

namespace morph::bench {

namespace {

vtkNew<vtkDoubleArray> array_of(const Matrix& values, const std::string& name)
{
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(static_cast<int>(values.cols()));
    array->SetNumberOfTuples(values.rows());
    std::copy(values.data(), values.data() + values.size(), array->GetPointer(0));
    return array;
}

vtkNew<vtkPoints> points_of(const Points& positions)
{
    vtkNew<vtkPoints> made;
    made->SetDataTypeToDouble();
    made->SetData(array_of(positions, "positions"));
    return made;
}

vtkNew<vtkPolyData> cloud_of(const Points& positions)
{
    vtkNew<vtkPolyData> made;
    made->SetPoints(points_of(positions));
    return made;
}

/// The triangles of a mesh with its nodal fields, numbered as in its file.
vtkNew<vtkUnstructuredGrid> grid_of(const MeshData& mesh)
{
    vtkNew<vtkCellArray> cells;
    for (const Element& e : mesh.elements)
        cells->InsertNextCell({e[0], e[1], e[2]});
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points_of(mesh.points));
    grid->SetCells(VTK_TRIANGLE, cells);
    for (const Field& field : mesh.fields)
        grid->GetPointData()->AddArray(array_of(field.values, field.name));
    return grid;
}

/// The peer of BM_LocateAndInterpolate. By default the filter walks from the nearest vertex, which can miss
/// the element; a cell locator cannot.
void BM_VtkProbeFilter(benchmark::State& state)
{
    const auto size = static_cast<Index>(state.range(0));
    const bool cell_locator = state.range(1) != 0;
    const MeshData source = source_data(size);
    const auto targets = cloud_of(random_points(size));
    double found = 0;
    for (auto _ : state) {
        state.PauseTiming(); // a grid keeps the locator that was built for it
        const auto grid = grid_of(source);
        state.ResumeTiming();
        vtkNew<vtkProbeFilter> probe;
        if (cell_locator) {
            vtkNew<vtkStaticCellLocator> locator;
            vtkNew<vtkCellLocatorStrategy> strategy;
            strategy->SetCellLocator(locator);
            probe->SetFindCellStrategy(strategy);
        }
        probe->SetInputData(targets);
        probe->SetSourceData(grid);
        probe->Update();
        found = static_cast<double>(probe->GetValidPoints()->GetNumberOfTuples());
    }
    state.counters["found"] = found;
    state.counters["s/target"] =
        benchmark::Counter(size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_VtkProbeFilter)
    ->ArgNames({"size", "cell_locator"})
    ->Args({1'000'000, 0})
    ->Args({1'000'000, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// What vtkSMPTools::Initialize does; VTK 9.1's header of that class is not valid C++20.
void use_threads(int count)
{
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().Initialize(count);
}

/// The peer of BM_InverseDistance.
void BM_VtkShepard(benchmark::State& state)
{
    use_threads(static_cast<int>(state.range(1)));
    const Cloud points = cloud(static_cast<Place>(state.range(0)));
    const auto known = cloud_of(points.positions(points.known, Eigen::all));
    const auto unknown = cloud_of(points.positions(points.unknown, Eigen::all));
    const Matrix values = points.values(points.known, Eigen::all);
    known->GetPointData()->AddArray(array_of(values.leftCols(1), "pressure"));
    known->GetPointData()->AddArray(array_of(values.rightCols(3), "velocity"));
    for (auto _ : state) {
        vtkNew<vtkShepardKernel> kernel;
        kernel->SetKernelFootprintToNClosest();
        kernel->SetNumberOfPoints(100);
        kernel->SetPowerParameter(5);
        vtkNew<vtkPointInterpolator> interpolator;
        interpolator->SetKernel(kernel);
        interpolator->SetSourceData(known);
        interpolator->SetInputData(unknown);
        interpolator->Update();
    }
    state.counters["s/point"] =
        benchmark::Counter(static_cast<double>(points.unknown.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_VtkShepard)
    ->ArgNames({"around", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace

} // namespace morph::bench
