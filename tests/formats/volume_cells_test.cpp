#include "formats/mesh/volume_cells.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::message_of;
using testing::ElementsAre;

const InputBytes kSurface{"box.msh", "", {.surface = true, .zone = ""}};

/// Volume enclosed by the faces: a sixth of the sum of the determinants of their triangles (Gauss's theorem).
double enclosed_volume(const MeshData& mesh)
{
    double sum = 0;
    const auto add = [&](Index a, Index b, Index c) {
        Eigen::Matrix3d corners;
        corners << mesh.points.row(a), mesh.points.row(b), mesh.points.row(c);
        sum += corners.determinant();
    };
    for (const Element& face : mesh.elements) {
        add(face[0], face[1], face[2]);
        if (face[3] >= 0)
            add(face[0], face[2], face[3]);
    }
    return sum / 6;
}

/// A volume mesh of one cell with these corners.
VolumeFile one_cell(VolumeShape shape, const std::vector<std::array<double, 3>>& corners)
{
    VolumeFile volume;
    volume.mesh.dimension = 3;
    volume.mesh.points.resize(static_cast<Index>(corners.size()), 3);
    VolumeCell cell{shape, {}};
    for (std::size_t v = 0; v < corners.size(); ++v) {
        volume.mesh.points.row(static_cast<Index>(v)) << corners[v][0], corners[v][1], corners[v][2];
        cell.corners[v] = static_cast<Index>(v);
    }
    volume.cells = {cell};
    return volume;
}

VolumeFile cube()
{
    return one_cell(VolumeShape::hexahedron,
                    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
}

/// Two unit cubes, one on the other; vertices 8 to 11 are the top.
VolumeFile two_cubes()
{
    VolumeFile volume = cube();
    volume.mesh.points.conservativeResize(12, 3);
    for (Index v = 0; v < 4; ++v)
        volume.mesh.points.row(8 + v) = volume.mesh.points.row(4 + v) + Eigen::RowVector3d(0, 0, 1);
    volume.cells.push_back({VolumeShape::hexahedron, {4, 5, 6, 7, 8, 9, 10, 11}});
    return volume;
}

TEST(VolumeSurface, EveryShapeIsEnclosedByItsFacesPointingOutwards)
{
    EXPECT_DOUBLE_EQ(enclosed_volume(surface_of(cube(), kSurface)), 1);
    EXPECT_DOUBLE_EQ(
        enclosed_volume(surface_of(
            one_cell(VolumeShape::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), kSurface)),
        1.0 / 6);
    EXPECT_DOUBLE_EQ(
        enclosed_volume(surface_of(
            one_cell(VolumeShape::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}),
            kSurface)),
        1.0 / 3);
    EXPECT_DOUBLE_EQ(
        enclosed_volume(surface_of(
            one_cell(VolumeShape::prism, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}),
            kSurface)),
        0.5);
}

TEST(VolumeSurface, FacesBetweenCellsAreInside)
{
    const MeshData surface = surface_of(two_cubes(), kSurface);
    EXPECT_EQ(surface.elements.size(), 10U);
    EXPECT_DOUBLE_EQ(enclosed_volume(surface), 2);
    const Mesh mesh = build_mesh(surface); // closed: Euler's number of a sphere
    EXPECT_EQ(vertex_count(mesh) - static_cast<Index>(mesh.kernel.n_edges()) + element_count(mesh), 2);
}

TEST(VolumeSurface, VerticesInsideAreLeftOutAndFieldsFollow)
{
    // Four tetrahedra around an inner vertex 0.
    VolumeFile volume;
    volume.mesh.points.resize(5, 3);
    volume.mesh.points << 0.2, 0.2, 0.2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    volume.cells = {{VolumeShape::tetrahedron, {1, 2, 3, 0}},
                    {VolumeShape::tetrahedron, {1, 4, 2, 0}},
                    {VolumeShape::tetrahedron, {2, 4, 3, 0}},
                    {VolumeShape::tetrahedron, {1, 3, 4, 0}}};
    Field number{"number", FieldLocation::vertex, Matrix(5, 1)};
    number.values << 10, 11, 12, 13, 14;
    volume.mesh.fields = {number};
    const MeshData surface = surface_of(volume, kSurface);
    EXPECT_EQ(surface.points.rows(), 4);
    EXPECT_EQ(surface.elements.size(), 4U);
    EXPECT_EQ(surface.fields[0].values, (Matrix(4, 1) << 11, 12, 13, 14).finished());
}

TEST(VolumeSurface, ListedFacesKeepTheirGroupsWhicheverWayTheyAreListed)
{
    VolumeFile volume = two_cubes();
    volume.mesh.elements = {{11, 10, 9, 8}, {0, 1, 2, 3}, {4, 5, 6, 7}};
    volume.mesh.groups = {{"top", {0}}, {"bottom", {1}}, {"between", {2}}};
    ReadNotes notes;
    InputBytes file = kSurface;
    file.notes = &notes;
    const MeshData surface = surface_of(volume, file);
    ASSERT_EQ(surface.groups.size(), 2U);
    EXPECT_EQ(surface.groups[0].name, "top");
    ASSERT_EQ(surface.groups[0].elements.size(), 1U);
    for (const Index v : surface.elements[static_cast<std::size_t>(surface.groups[0].elements[0])])
        EXPECT_EQ(surface.points(v, 2), 2);
    ASSERT_EQ(surface.groups[1].elements.size(), 1U);
    for (const Index v : surface.elements[static_cast<std::size_t>(surface.groups[1].elements[0])])
        EXPECT_EQ(surface.points(v, 2), 0);
    EXPECT_THAT(notes.warnings, ElementsAre("box.msh: 1 listed face(s) inside the volume were left out"));
}

TEST(VolumeSurface, ElementFieldsComeAlongWhereAllBoundaryFacesAreListed)
{
    VolumeFile volume = cube();
    const MeshData bare = surface_of(volume, kSurface);
    volume.mesh.elements.assign(bare.elements.rbegin(), bare.elements.rend());
    Field number{"number", FieldLocation::element, Matrix(6, 1)};
    number.values << 5, 4, 3, 2, 1, 0;
    volume.mesh.fields = {number};
    const MeshData surface = surface_of(volume, kSurface);
    ASSERT_EQ(surface.fields.size(), 1U);
    EXPECT_EQ(surface.fields[0].values, (Matrix(6, 1) << 0, 1, 2, 3, 4, 5).finished());

    volume.mesh.elements.pop_back();
    volume.mesh.fields[0].values.conservativeResize(5, 1);
    ReadNotes notes;
    InputBytes file = kSurface;
    file.notes = &notes;
    EXPECT_TRUE(surface_of(volume, file).fields.empty());
    EXPECT_THAT(notes.warnings,
                ElementsAre("box.msh: element field 'number' was left out: it has no values for "
                            "some boundary faces"));
}

TEST(VolumeSurface, WhatIsNoVolumeMeshIsRefused)
{
    EXPECT_EQ(message_of([] {
                  surface_of(cube(), {"box.msh", ""});
              }),
              "box.msh: holds a volume mesh of 1 cells; --surface takes its boundary");
    VolumeFile beyond = cube();
    beyond.cells[0].corners[3] = 8;
    EXPECT_EQ(message_of([&] { surface_of(beyond, kSurface); }),
              "box.msh: cell 0 names vertex 8, but the mesh has 8");
    VolumeFile thrice = cube();
    thrice.cells.assign(3, thrice.cells[0]);
    EXPECT_EQ(message_of([&] { surface_of(thrice, kSurface); }),
              "box.msh: the face of vertices 0, 1, 2, 3 belongs to 3 cells, expected at most 2");
}

TEST(VolumeSurface, FacesAloneAreTheMeshAsTheyAre)
{
    VolumeFile flat;
    flat.mesh.points = Points::Zero(3, 3);
    flat.mesh.elements = {{0, 1, 2, -1}};
    EXPECT_EQ(surface_of(flat, {"flat.msh", ""}).elements, flat.mesh.elements);
}

} // namespace
