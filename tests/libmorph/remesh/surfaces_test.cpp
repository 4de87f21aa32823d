// Surfaces of every kind remade: what they are stays, and nothing is folded.

#include "libmorph/geometry/hausdorff.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/bounded_remesh.h"
#include "libmorph/remesh/folds.h"
#include "libmorph/remesh/remesh.h"
#include "tests/support/surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace morph {
namespace {

struct Surface {
    std::string name;
    MeshData data;
    double size;     ///< edge length to remake it with
    double accuracy; ///< part of area and volume that chords of this length cut off
    double least_quality;
};

/// Of a sphere of radius r, triangles of edge h lose h²/(4 r²) of the volume and half of that of the area, of
/// what they would have with their corners on it; the torus' tube has the radius 0.4, bumps of the scan about
/// as much.
std::vector<Surface> surfaces()
{
    return {{"sphere", test::sphere(20), 0.12, 0.008, 0.4},
            {"fine sphere", test::sphere(10), 0.05, 0.008, 0.4},
            {"torus", test::torus(60, 30), 0.12, 0.03, 0.4},
            {"cube", test::cube(4), 0.1, 1e-12, 0.4},
            {"hemisphere", test::hemisphere(20), 0.12, 0.008, 0.4},
            {"bent plate", test::bent_plate(20), 0.12, 0.004, 0.4},
            {"scan", test::scan(4000), 0.08, 0.01, 0.3},
            {"coarser scan", test::scan(4000), 0.2, 0.05, 0.3}};
}

MeshData remade(const Surface& surface)
{
    const Mesh mesh = build_mesh(surface.data);
    return remesh(mesh, Eigen::VectorXd::Constant(vertex_count(mesh), surface.size)).data;
}

bool self_intersects(const MeshData& data)
{
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    CGAL::Surface_mesh<Point> mesh;
    using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
    for (const auto& p : data.points.rowwise())
        mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const Element& e : data.elements)
        mesh.add_face(Vertex(static_cast<unsigned>(e[0])), Vertex(static_cast<unsigned>(e[1])),
                      Vertex(static_cast<unsigned>(e[2])));
    return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

TEST(RemeshSurfaces, HaveNoFoldAndDoNotIntersectThemselves)
{
    for (const Surface& surface : surfaces()) {
        const MeshData data = remade(surface);
        EXPECT_TRUE(folded_triangles(build_mesh(surface.data), build_mesh(data)).empty()) << surface.name;
        EXPECT_FALSE(self_intersects(data)) << surface.name;
    }
}

TEST(RemeshSurfaces, KeepTheirEulerCharacteristicAreaAndVolume)
{
    for (const Surface& surface : surfaces()) {
        const MeshData data = remade(surface);
        EXPECT_EQ(test::euler_characteristic(data), test::euler_characteristic(surface.data)) << surface.name;
        const double area = test::surface_area(surface.data), volume = test::volume(surface.data);
        EXPECT_NEAR(test::surface_area(data), area, surface.accuracy * area) << surface.name;
        EXPECT_NEAR(test::volume(data), volume, surface.accuracy * std::abs(volume)) << surface.name;
    }
}

TEST(RemeshSurfaces, HaveGoodTriangles)
{
    for (const Surface& surface : surfaces()) {
        const std::vector<double> quality = triangle_qualities(build_mesh(remade(surface)));
        EXPECT_GT(*std::min_element(quality.begin(), quality.end()), surface.least_quality) << surface.name;
        const double sum = std::accumulate(quality.begin(), quality.end(), 0.0);
        EXPECT_GT(sum / static_cast<double>(quality.size()), 0.9) << surface.name;
    }
}

TEST(RemeshSurfaces, OfACubeHaveItsFacesExactly)
{
    const MeshData data = remade({"cube", test::cube(4), 0.1, 0, 0});
    EXPECT_LE(hausdorff_distance(build_mesh(test::cube(4)), build_mesh(data)).bound, 1e-12);
}

TEST(RemeshSurfaces, StayWithinADistanceAskedFor)
{
    for (const Surface& surface : surfaces()) {
        const Mesh mesh = build_mesh(surface.data);
        constexpr double kDistance = 0.005;
        Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(mesh), 0.3);
        const Mesh made = build_mesh(remesh_within(mesh, kDistance, sizes).data);
        EXPECT_LE(hausdorff_distance(mesh, made).value, kDistance) << surface.name;
        EXPECT_TRUE(folded_triangles(mesh, made).empty()) << surface.name;
    }
}

TEST(RemeshSurfaces, WithATriangleTurnedRoundHaveAFold)
{
    MeshData data = test::sphere(4);
    data.points.row(0).swap(data.points.row(1)); // neighbours change places
    const Mesh old = build_mesh(test::sphere(4)), made = build_mesh(data);
    EXPECT_FALSE(folded_triangles(old, made).empty());
}

} // namespace
} // namespace morph
