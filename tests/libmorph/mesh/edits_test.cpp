#include "libmorph/mesh/edits.h"

#include "tests/support/errors.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::difference;
using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;

/// A square of quads and two triangles with a field at the vertices and one at the elements.
MeshData hybrid_with_fields()
{
    MeshData mesh = test::quad_square(3);
    mesh.elements.push_back({0, 1, 5, -1});
    mesh.elements.erase(mesh.elements.begin());
    mesh.elements.push_back({0, 5, 4, -1});
    const auto elements = static_cast<Index>(mesh.elements.size());
    mesh.fields = {{"p", FieldLocation::vertex, Matrix::Random(mesh.points.rows(), 1)},
                   {"T", FieldLocation::element, Matrix::Random(elements, 2)}};
    return mesh;
}

const MeshData kMesh = hybrid_with_fields();

MeshData edited(const Edits& edits, MeshData mesh = kMesh)
{
    EXPECT_THAT(apply_edits(edits, mesh), ElementsAre());
    return mesh;
}

std::string complaint(const Edits& edits)
{
    MeshData mesh = kMesh;
    return message_of([&] { apply_edits(edits, mesh); });
}

TEST(Edits, NoneLeaveTheMeshBitForBit)
{
    EXPECT_EQ(difference(edited({}), kMesh), "");
}

TEST(Edits, MapsPointsAndSetsTheDimension)
{
    const Transform transform{rotation(2, 90) * Eigen::Vector3d(2, 1, 1).asDiagonal(), {10, 0, 0}};
    const MeshData moved = edited({.transform = transform});
    EXPECT_EQ(moved.points.col(0), (10 - kMesh.points.col(1).array()).matrix());
    EXPECT_EQ(moved.points.col(1), 2 * kMesh.points.col(0));
    EXPECT_EQ(moved.dimension, 2);
    const MeshData upright = edited({.transform = Transform{.linear = rotation(0, 90)}});
    EXPECT_EQ(upright.dimension, 3);
    EXPECT_EQ(upright.points.col(2), kMesh.points.col(1));
}

TEST(Edits, RotationsAreExactAtQuarterTurnsAndOrthogonalElsewhere)
{
    for (const int axis : {0, 1, 2}) {
        const Eigen::Matrix3d quarter = rotation(axis, 90);
        EXPECT_EQ(quarter * quarter * quarter * quarter, Eigen::Matrix3d::Identity());
        EXPECT_EQ(rotation(axis, -270), quarter);
        EXPECT_EQ(quarter.col((axis + 1) % 3), Eigen::Matrix3d::Identity().col((axis + 2) % 3));
        const Eigen::Matrix3d third = rotation(axis, 30);
        EXPECT_LE((third * third * third - quarter).norm(), 1e-15);
    }
}

TEST(Edits, SplitQuadsWithTheirFields)
{
    const MeshData split = edited({.triangulate = true});
    EXPECT_EQ(split.elements.size(), kMesh.elements.size() + 8);
    for (const Element& element : split.elements)
        EXPECT_EQ(corner_count(element), 3);
    EXPECT_EQ(split.fields[1].values.rows(), static_cast<Index>(split.elements.size()));
}

TEST(Edits, RenameMarkersAllAtOnce)
{
    const MeshData renamed = edited({.renames = {{"left", "right"}, {"right", "left"}}});
    EXPECT_EQ(find_marker(renamed.markers, "left")->edges, find_marker(kMesh.markers, "right")->edges);
    EXPECT_EQ(find_marker(renamed.markers, "right")->edges, find_marker(kMesh.markers, "left")->edges);
    EXPECT_THAT(complaint({.renames = {{"lft", "a"}}}),
                testing::AllOf(HasSubstr("has no marker or group 'lft' to rename"),
                               HasSubstr("did you mean 'left'?")));
    EXPECT_THAT(complaint({.renames = {{"left", "right"}}}),
                HasSubstr("would have two markers 'right' after renaming"));
}

TEST(Edits, RenameGroups)
{
    MeshData mesh = kMesh;
    mesh.groups = {{"fluid", {0, 1}}};
    EXPECT_EQ(edited({.renames = {{"fluid", "air"}}}, mesh).groups[0].name, "air");
}

TEST(Edits, DropFieldsByNameOrAll)
{
    const MeshData named = edited({.drop_fields = {"p"}});
    ASSERT_EQ(named.fields.size(), 1U);
    EXPECT_EQ(named.fields[0].name, "T");
    EXPECT_TRUE(edited({.drop_all_fields = true}).fields.empty());
    EXPECT_THAT(complaint({.drop_fields = {"q"}}), HasSubstr("has no field 'q' to drop, but p, T"));
}

TEST(Edits, MergeVerticesAndSayWhatWasLeftOut)
{
    MeshData mesh = kMesh;
    mesh.fields.clear();
    mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
    mesh.points.row(mesh.points.rows() - 1) = mesh.points.row(0);
    mesh.elements.back()[0] = static_cast<Index>(mesh.points.rows()) - 1;
    EXPECT_EQ(edited({.merge_tolerance = 1e-9}, mesh).points, kMesh.points);
    mesh.elements.push_back({0, 1, static_cast<Index>(mesh.points.rows()) - 1, -1});
    EXPECT_THAT(apply_edits({.merge_tolerance = 1e-9}, mesh),
                ElementsAre("1 element(s) lay within the merge tolerance of 1e-09 and were left out"));
}

TEST(SetField, TakesThePlaceOfOneOfItsNameAndPlace)
{
    std::vector<Field> fields = kMesh.fields;
    set_field(fields, {"p", FieldLocation::vertex, Matrix::Zero(1, 1)});
    set_field(fields, {"p", FieldLocation::element, Matrix::Ones(1, 1)});
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_EQ(find_field(fields, "p", FieldLocation::vertex)->values, Matrix::Zero(1, 1));
    EXPECT_EQ(fields[2].location, FieldLocation::element);
}

} // namespace
