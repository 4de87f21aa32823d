#include "libmorph/mesh/builder.h"

#include "formats/formats.h"
#include "libmorph/core/parallel.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace morph {

namespace {

/// A tetrahedron's surface next to a quad with a triangle on its side: a surface in space of two parts.
MeshData small_surface()
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(9, 3);
    data.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0, 4, 0, 1, 4, 1, 1, 3, 1, 0, 5, 0, 3;
    data.elements = {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {4, 5, 6, 7}, {6, 5, 8, -1}};
    data.markers = {{"seam", {{5, 6}}}, {"ridge", {{3, 0}, {1, 3}}}};
    return data;
}

std::vector<MeshData> synthetic_meshes()
{
    return {test::uneven_square(9), test::quad_square(8), test::annulus(1, 10, 40, 12), small_surface()};
}

std::vector<MeshData> all_meshes()
{
    std::vector<MeshData> meshes = synthetic_meshes();
    for (const std::string& path : test::real_meshes())
        meshes.push_back(read_mesh_data(path));
    return meshes;
}

/// Fields of 1 to 9 components whose every value is different.
void add_fields(MeshData& data)
{
    for (const Index components : {1, 3, 9})
        for (const FieldLocation location : {FieldLocation::vertex, FieldLocation::element}) {
            const auto rows = location == FieldLocation::vertex
                                  ? data.points.rows()
                                  : static_cast<Eigen::Index>(data.elements.size());
            Matrix values(rows, components);
            for (Eigen::Index i = 0; i < values.size(); ++i)
                values.data()[i] = static_cast<double>(i) + 0.1 * static_cast<double>(components);
            data.fields.push_back({"f" + std::to_string(components), location, values});
        }
}

/// Halfedge between two vertices of the file -> element, and the next halfedge around it or around the hole.
using Connectivity = std::map<std::array<Index, 2>, std::tuple<Index, Index, Index>>;

template <typename VertexNumber, typename ElementNumber>
Connectivity connectivity(const Kernel& kernel, const VertexNumber& vertex, const ElementNumber& element)
{
    Connectivity links;
    for (const HalfedgeHandle h : kernel.halfedges()) {
        const HalfedgeHandle next = kernel.next_halfedge_handle(h);
        const Index from = vertex(kernel.from_vertex_handle(h).idx());
        const Index to = vertex(kernel.to_vertex_handle(h).idx());
        const Index face = kernel.is_boundary(h) ? -1 : element(kernel.face_handle(h).idx());
        links[{from, to}] = {face, vertex(kernel.from_vertex_handle(next).idx()),
                             vertex(kernel.to_vertex_handle(next).idx())};
    }
    return links;
}

Connectivity connectivity(const Mesh& mesh)
{
    return connectivity(
        mesh.kernel, [&](Index v) { return mesh.numbering.vertex[static_cast<std::size_t>(v)]; },
        [&](Index f) { return mesh.numbering.element[static_cast<std::size_t>(f)]; });
}

/// What OpenMesh's own incremental construction makes of elements that need no repair.
Connectivity connectivity_by_add_face(const MeshData& data)
{
    Kernel kernel;
    for (Index i = 0; i < data.points.rows(); ++i)
        kernel.add_vertex({data.points(i, 0), data.points(i, 1), data.points(i, 2)});
    for (const Element& e : data.elements) {
        std::vector<VertexHandle> corners;
        for (int k = 0; k < corner_count(e); ++k)
            corners.emplace_back(e[static_cast<std::size_t>(k)]);
        kernel.add_face(corners);
    }
    const auto same = [](Index i) { return i; };
    return connectivity(kernel, same, same);
}

double total_area(const Mesh& mesh)
{
    double sum = 0;
    for (const Element& e : element_table(mesh)) {
        const auto corner = [&](std::size_t k) -> Eigen::RowVector3d { return points(mesh).row(e[k]); };
        const Eigen::RowVector3d last = corner_count(e) == 4 ? corner(3) : corner(0);
        sum += (corner(2) - corner(0)).cross(last - corner(1)).z() / 2;
    }
    return sum;
}

TEST(BuildMesh, GivesBackEveryRealMeshBitForBit)
{
    ASSERT_GE(test::real_meshes().size(), 8U);
    for (const std::string& path : test::real_meshes()) {
        MeshData data = read_mesh_data(path);
        add_fields(data);
        EXPECT_EQ(test::difference(to_mesh_data(build_mesh(data)), data), "") << path;
    }
}

TEST(BuildMesh, GivesBackAnyNumberingAndAnyWayOfListing)
{
    unsigned seed = 0;
    for (const MeshData& original : all_meshes())
        for (const double turned : {0.0, 0.02, 0.5, 1.0}) {
            MeshData data = test::shuffled(original, ++seed);
            test::turn_some(data, turned, seed);
            add_fields(data);
            const Mesh mesh = build_mesh(data);
            EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "") << "seed " << seed;
            if (data.dimension == 2) { // the same geometry, counter-clockwise, however it was listed
                EXPECT_NEAR(total_area(mesh), total_area(build_mesh(original)), 1e-12 * total_area(mesh));
            }
        }
}

TEST(BuildMesh, MakesAKernelThatOpenMeshAccepts)
{
    for (const MeshData& data : all_meshes())
        test::expect_sound(build_mesh(data));
}

TEST(BuildMesh, ConnectsAsAddFaceDoes)
{
    for (const MeshData& data : all_meshes())
        EXPECT_EQ(connectivity(build_mesh(data)), connectivity_by_add_face(data));
}

TEST(BuildMesh, StartsElementsAtTheCornerListedFirst)
{
    const MeshData data = test::shuffled(test::quad_square(5), 1);
    const Mesh mesh = build_mesh(data);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const VertexHandle first = *mesh.kernel.cfv_ccwbegin(FaceHandle(f));
        const auto listed =
            data.elements[static_cast<std::size_t>(mesh.numbering.element[static_cast<std::size_t>(f)])];
        EXPECT_EQ(mesh.numbering.vertex[static_cast<std::size_t>(first.idx())], listed[0]);
    }
}

TEST(BuildMesh, PutsNeighboursNearEachOtherInMemory)
{
    const MeshData data = test::shuffled(test::uneven_square(100), 5);
    const Mesh mesh = build_mesh(data);
    double near = 0;
    for (const EdgeHandle e : mesh.kernel.edges()) {
        const HalfedgeHandle h = mesh.kernel.halfedge_handle(e, 0);
        near +=
            std::abs(mesh.kernel.to_vertex_handle(h).idx() - mesh.kernel.from_vertex_handle(h).idx()) < 256
                ? 1
                : 0;
    }
    // Row by row, an edge upwards spans 100; at random a hundredth of the edges would be this short.
    EXPECT_GT(near, 0.8 * static_cast<double>(mesh.kernel.n_edges()));
}

TEST(BuildMesh, KeepsVerticesOfNoElement)
{
    MeshData data = test::uneven_square(3);
    const Index used = static_cast<Index>(data.points.rows());
    data.points.conservativeResize(used + 2, 3);
    data.points.row(used) << 0.5, 0.5, 0;
    data.points.row(used + 1) << -7, 0.25, 0;
    add_fields(data);
    const Mesh mesh = build_mesh(data);
    test::expect_sound(mesh);
    Index isolated = 0;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_isolated(v)) {
            ++isolated;
            EXPECT_GE(mesh.numbering.vertex[static_cast<std::size_t>(v.idx())], used);
        }
    EXPECT_EQ(isolated, 2);
    EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
}

TEST(BuildMesh, TakesMeshesWithoutElementsOrVertices)
{
    MeshData data;
    data.points.resize(0, 3);
    EXPECT_EQ(test::difference(to_mesh_data(build_mesh(data)), data), "");
    data.points.setRandom(5, 3);
    data.dimension = 3;
    EXPECT_EQ(test::difference(to_mesh_data(build_mesh(data)), data), "");
}

TEST(BuildMesh, CarriesWhatItDoesNotKnow)
{
    MeshData data = test::quad_square(2);
    data.sections = {{"su2", "1 FFD box", "FFD_NBOX= 1\n"}};
    const MeshData back = to_mesh_data(build_mesh(data));
    ASSERT_EQ(back.sections.size(), 1U);
    EXPECT_EQ(back.sections[0].format, "su2");
    EXPECT_EQ(back.sections[0].what, "1 FFD box");
    EXPECT_EQ(back.sections[0].text, "FFD_NBOX= 1\n");
}

TEST(BuildMesh, KeepsGroupsWithTheirElements)
{
    MeshData data = test::uneven_square(5);
    data.groups = {{"some", {40, 3, 17}}, {"empty", {}}, {"again", {3}}};
    const Mesh mesh = build_mesh(data);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto inside = static_cast<std::size_t>(mesh.groups[0].elements[i]);
        EXPECT_EQ(mesh.numbering.element[inside], data.groups[0].elements[i]);
    }
    EXPECT_EQ(test::difference(data, to_mesh_data(mesh)), "");
}

TEST(BuildMesh, KeepsTheDirectionOfMarkerEdges)
{
    MeshData data = test::uneven_square(4);
    data.markers = {{"mixed", {{1, 0}, {1, 2}, {6, 1}}}}; // against the boundary, along it, inside
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(to_mesh_data(mesh).markers[0].edges, data.markers[0].edges);
    for (const auto& [from, to] : mesh.markers[0].edges)
        EXPECT_TRUE(mesh.kernel.find_halfedge(VertexHandle(from), VertexHandle(to)).is_valid());
}

TEST(BuildMesh, FindsMarkerEdgesAtAVertexOfManyElements)
{
    const Index rim = 5000;
    MeshData data;
    data.points.setZero(rim + 1, 3);
    data.markers = {{"spokes", {}}};
    for (Index i = 0; i < rim; ++i) {
        data.points.row(i) << std::cos(2 * std::numbers::pi * i / rim),
            std::sin(2 * std::numbers::pi * i / rim), 0;
        data.elements.push_back({rim, i, (i + 1) % rim, -1});
        data.markers[0].edges.push_back({rim, i});
    }
    const Mesh mesh = build_mesh(data);
    test::expect_sound(mesh);
    EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
}

TEST(BuildMesh, MakesTheSameBytesForAnyNumberOfThreads)
{
    MeshData data = test::shuffled(test::annulus(1, 10, 400, 100), 3);
    test::turn_some(data, 0.3, 3);
    add_fields(data);
    set_thread_count(1);
    const Mesh one = build_mesh(data);
    for (const int threads : {2, 3}) {
        set_thread_count(threads);
        const Mesh many = build_mesh(data);
        EXPECT_EQ(many.numbering.vertex, one.numbering.vertex);
        EXPECT_EQ(many.numbering.element, one.numbering.element);
        EXPECT_EQ(many.numbering.reversed, one.numbering.reversed);
        EXPECT_EQ(element_table(many), element_table(one));
        EXPECT_TRUE(points(many) == points(one));
        EXPECT_EQ(test::difference(to_mesh_data(many), data), "");
        for (const HalfedgeHandle h : one.kernel.halfedges()) {
            ASSERT_EQ(many.kernel.next_halfedge_handle(h), one.kernel.next_halfedge_handle(h));
            ASSERT_EQ(many.kernel.to_vertex_handle(h), one.kernel.to_vertex_handle(h));
        }
        for (const VertexHandle v : one.kernel.vertices())
            ASSERT_EQ(many.kernel.halfedge_handle(v), one.kernel.halfedge_handle(v));
    }
    set_thread_count(0);
}

} // namespace

} // namespace morph
