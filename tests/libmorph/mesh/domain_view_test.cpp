#include "libmorph/mesh/domain_view.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace morph;

TEST(DomainView, ShowsThePointsOfAMesh)
{
    Mesh mesh = build_mesh(test::uneven_square(5));
    const DomainView domain = mesh;
    EXPECT_EQ(domain.vertex_count(), 36);
    EXPECT_EQ(domain.dimension(), 2);
    EXPECT_EQ(domain.positions(), points(mesh));
    EXPECT_EQ(domain.coordinates(), points(mesh).leftCols(2));
    points(mesh)(7, 1) = 0.125;
    EXPECT_EQ(domain.coordinates()(7, 1), 0.125); // a view
}

TEST(DomainView, HasThreeCoordinatesInSpace)
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(3, 3);
    data.points << 0, 0, 0, 1, 0, 1, 0, 1, 2;
    data.elements = {{0, 1, 2, -1}};
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(DomainView(mesh).dimension(), 3);
    EXPECT_EQ(DomainView(mesh).coordinates(), points(mesh));
}

TEST(DomainView, ListsElementsAndTheFacetsThatHaveOneOfThem)
{
    const Mesh mesh = build_mesh(test::quad_square(4));
    const DomainView domain = mesh;
    EXPECT_EQ(domain.elements(), element_table(mesh));
    std::multiset<std::set<Index>> sides; // counted from the elements
    for (const Element& corners : domain.elements())
        for (std::size_t i = 0; i < 4; ++i)
            sides.insert({corners[i], corners[(i + 1) % 4]});
    EXPECT_EQ(domain.boundary_facets().size(), 16U);
    for (const auto& [a, b] : domain.boundary_facets())
        EXPECT_EQ(sides.count({a, b}), 1U);
}

TEST(DomainView, KnowsTheCopiesOfASplitVertexAndTheFilesNumbers)
{
    const Mesh mesh = build_mesh(test::touching_squares(3));
    const DomainView domain = mesh;
    const std::vector<Index> first = domain.representatives();
    Index copies = 0;
    for (Index v = 0; v < domain.vertex_count(); ++v) {
        const Index other = first[static_cast<std::size_t>(v)];
        copies += other == v ? 0 : 1;
        EXPECT_EQ(domain.file_vertex(v), domain.file_vertex(other));
        EXPECT_EQ(domain.positions().row(v), domain.positions().row(other));
    }
    EXPECT_EQ(copies, 1);
    EXPECT_EQ(domain.file_element(2), mesh.numbering.element[2]);
}

} // namespace
