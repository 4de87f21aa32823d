// Remeshing to longer and shorter edges, compared with CGAL's remeshing and mesh generation.

#include "libmorph/geometry/hausdorff.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/target_size.h"
#include "tests/bench/bench_meshes.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace morph::bench {

namespace {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalSurface = CGAL::Surface_mesh<CgalKernel::Point_3>;

void count(benchmark::State& state, const MeshData& data)
{
    const std::vector<double> quality = triangle_qualities(build_mesh(data));
    state.counters["triangles"] = static_cast<double>(quality.size());
    state.counters["min_quality"] = *std::min_element(quality.begin(), quality.end());
    state.counters["mean_quality"] =
        std::accumulate(quality.begin(), quality.end(), 0.0) / static_cast<double>(quality.size());
}

/// A ring as mesh generators leave it: graded, numbered at random, remade once so that it is not regular.
Mesh airfoil_like(Index vertices)
{
    const Mesh ring = build_mesh(triangulated_annulus(vertices, Order::shuffled));
    return build_mesh(remesh(ring, current_sizes(ring)).data);
}

void BM_RemeshRing(benchmark::State& state, Index vertices, double scale)
{
    const Mesh mesh = airfoil_like(vertices);
    const Eigen::VectorXd sizes = scale * current_sizes(mesh);
    MeshData made;
    for (auto _ : state)
        made = remesh(mesh, sizes).data;
    count(state, made);
    state.counters["input"] = element_count(mesh);
}

void settings(benchmark::internal::Benchmark* bench)
{
    bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK_CAPTURE(BM_RemeshRing, longer_217k, 107'000, 1.5)->Apply(settings);
BENCHMARK_CAPTURE(BM_RemeshRing, shorter_217k, 107'000, 0.7)->Apply(settings);
BENCHMARK_CAPTURE(BM_RemeshRing, longer_2M, 985'000, 1.5)->Apply(settings)->Iterations(1);

MeshData benchmark_surface(bool torus)
{
    return torus ? test::torus(360, 180) : test::sphere(127); // some 130 000 triangles each
}

constexpr double kSurfaceSize = 0.02;

void BM_RemeshSurface(benchmark::State& state, bool torus)
{
    const Mesh mesh = build_mesh(benchmark_surface(torus));
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(mesh), kSurfaceSize);
    MeshData made;
    for (auto _ : state)
        made = remesh(mesh, sizes).data;
    count(state, made);
    state.counters["hausdorff"] = hausdorff_distance(mesh, build_mesh(made)).value;
}

CgalSurface to_cgal(const MeshData& data)
{
    using Vertex = CgalSurface::Vertex_index;
    CgalSurface surface;
    for (const auto& p : data.points.rowwise())
        surface.add_vertex({p.x(), p.y(), p.z()});
    for (const Element& e : data.elements)
        surface.add_face(Vertex(static_cast<unsigned>(e[0])), Vertex(static_cast<unsigned>(e[1])),
                         Vertex(static_cast<unsigned>(e[2])));
    return surface;
}

MeshData from_cgal(CgalSurface& surface)
{
    surface.collect_garbage();
    MeshData data;
    data.dimension = 3;
    data.points.resize(static_cast<Index>(surface.number_of_vertices()), 3);
    for (const auto v : surface.vertices()) {
        const auto& p = surface.point(v);
        data.points.row(static_cast<Index>(v)) << p.x(), p.y(), p.z();
    }
    for (const auto f : surface.faces()) {
        Element e{-1, -1, -1, -1};
        std::size_t k = 0;
        for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
            e[k++] = static_cast<Index>(v);
        data.elements.push_back(e);
    }
    return data;
}

void BM_CgalIsotropicRemeshing(benchmark::State& state, bool torus)
{
    constexpr unsigned kIterations = 5; // as ours
    const MeshData input = benchmark_surface(torus);
    MeshData made;
    for (auto _ : state) {
        state.PauseTiming();
        CgalSurface surface = to_cgal(input);
        state.ResumeTiming();
        CGAL::Polygon_mesh_processing::isotropic_remeshing(
            surface.faces(), kSurfaceSize, surface,
            CGAL::parameters::number_of_iterations(kIterations).number_of_relaxation_steps(2));
        state.PauseTiming();
        made = from_cgal(surface);
        state.ResumeTiming();
    }
    count(state, made);
    state.counters["hausdorff"] = hausdorff_distance(build_mesh(input), build_mesh(made)).value;
}

BENCHMARK_CAPTURE(BM_RemeshSurface, sphere, false)->Apply(settings);
BENCHMARK_CAPTURE(BM_RemeshSurface, torus, true)->Apply(settings);
BENCHMARK_CAPTURE(BM_CgalIsotropicRemeshing, sphere, false)->Apply(settings)->Iterations(1);
BENCHMARK_CAPTURE(BM_CgalIsotropicRemeshing, torus, true)->Apply(settings)->Iterations(1);

/// CGAL's Delaunay refinement of a ring to one edge length, which has no size field of its own.
void BM_CgalDelaunayMesher(benchmark::State& state, double size)
{
    using Vertex = CGAL::Triangulation_vertex_base_2<CgalKernel>;
    using Face = CGAL::Delaunay_mesh_face_base_2<CgalKernel>;
    using Cdt =
        CGAL::Constrained_Delaunay_triangulation_2<CgalKernel,
                                                   CGAL::Triangulation_data_structure_2<Vertex, Face>>;
    constexpr double kAngleBound = 0.125; // sine squared: 20.7 degrees, as far as it surely ends
    MeshData made;
    for (auto _ : state) {
        Cdt cdt;
        for (const double radius : {1.0, 3.0}) {
            const auto nodes = static_cast<int>(2 * std::numbers::pi * radius / size);
            std::vector<CgalKernel::Point_2> circle;
            for (int i = 0; i < nodes; ++i) {
                const double angle = 2 * std::numbers::pi * i / nodes;
                circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
            }
            cdt.insert_constraint(circle.begin(), circle.end(), true);
        }
        const std::vector<CgalKernel::Point_2> hole{{0, 0}};
        CGAL::refine_Delaunay_mesh_2(cdt, hole.begin(), hole.end(),
                                     CGAL::Delaunay_mesh_size_criteria_2<Cdt>(kAngleBound, size));
        state.PauseTiming();
        made = MeshData();
        std::map<Cdt::Vertex_handle, Index> number;
        for (const auto v : cdt.finite_vertex_handles())
            number.emplace(v, static_cast<Index>(number.size()));
        made.points.setZero(static_cast<Index>(number.size()), 3);
        for (const auto& [v, i] : number)
            made.points.row(i) << v->point().x(), v->point().y(), 0;
        for (const auto f : cdt.finite_face_handles())
            if (f->is_in_domain())
                made.elements.push_back(
                    {number.at(f->vertex(0)), number.at(f->vertex(1)), number.at(f->vertex(2)), -1});
        state.ResumeTiming();
    }
    count(state, made);
}

/// The same ring from a coarse mesh, remade to that edge length.
void BM_RemeshRingToOneSize(benchmark::State& state, double size)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 800, 100));
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(mesh), size);
    MeshData made;
    for (auto _ : state)
        made = remesh(mesh, sizes).data;
    count(state, made);
}

BENCHMARK_CAPTURE(BM_CgalDelaunayMesher, ring, 0.015)->Apply(settings)->Iterations(1);
BENCHMARK_CAPTURE(BM_RemeshRingToOneSize, ring, 0.0125)->Apply(settings);

void BM_Hausdorff(benchmark::State& state)
{
    const Mesh fine = build_mesh(test::torus(1000, 500)), coarse = build_mesh(test::torus(620, 310));
    for (auto _ : state)
        benchmark::DoNotOptimize(hausdorff_distance(fine, coarse));
    state.counters["triangles"] = element_count(fine) + element_count(coarse);
}
BENCHMARK(BM_Hausdorff)->Apply(settings)->Iterations(1);

} // namespace

} // namespace morph::bench
