// Files in pieces, and collections of files.
#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using testing::ElementsAre;
using testing::HasSubstr;

using Edges = std::vector<std::array<Index, 2>>;

/// A triangle, and a quad to its right, each a piece of its own.
const std::string kPieces =
    "<VTKFile type='UnstructuredGrid' version='0.1'><UnstructuredGrid>\n"
    "<FieldData><Array type='String' Name='marker_names' format='ascii'>97 0 98 0</Array>\n"
    "<Array type='String' Name='group_names' format='ascii'>103 0</Array></FieldData>\n"
    "<Piece NumberOfPoints='3' NumberOfCells='2'>\n"
    "<Points><DataArray type='Float64' NumberOfComponents='3'>0 0 0 1 0 0 1 1 0</DataArray></Points>\n"
    "<Cells><DataArray type='Int32' Name='connectivity'>0 1 2 0 1</DataArray>\n"
    "<DataArray type='Int32' Name='offsets'>3 5</DataArray>\n"
    "<DataArray type='UInt8' Name='types'>5 3</DataArray></Cells>\n"
    "<PointData><DataArray type='Float32' Name='T'>1 2 3</DataArray>\n"
    "<DataArray type='Float32' Name='first'>1 2 3</DataArray></PointData>\n"
    "<CellData><DataArray type='Int8' Name='marker'>0 2</DataArray>\n"
    "<DataArray type='Int8' Name='group'>0 0</DataArray></CellData>\n"
    "</Piece>\n"
    "<Piece NumberOfPoints='4' NumberOfCells='2'>\n"
    "<Points><DataArray type='Float64' NumberOfComponents='3'>1 0 0 2 0 0 2 1 0 1 1 0</DataArray></Points>\n"
    "<Cells><DataArray type='Int32' Name='connectivity'>0 1 0 1 2 3</DataArray>\n"
    "<DataArray type='Int32' Name='offsets'>2 6</DataArray>\n"
    "<DataArray type='UInt8' Name='types'>3 9</DataArray></Cells>\n"
    "<PointData><DataArray type='Float32' Name='T'>4 5 6 7</DataArray></PointData>\n"
    "<CellData><DataArray type='Int8' Name='marker'>2 0</DataArray>\n"
    "<DataArray type='Int8' Name='group'>0 1</DataArray></CellData>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

MeshData read_zone(const std::string& bytes, const std::string& zone, ReadNotes* notes = nullptr)
{
    return find_format("", "vtu").read({"file", bytes, {.surface = false, .zone = zone}, notes});
}

TEST(VtkPieces, AreJoinedAsGroups)
{
    ReadNotes notes;
    const MeshData mesh = read_zone(kPieces, "", &notes);
    EXPECT_EQ(mesh.points.rows(), 7);
    EXPECT_EQ(mesh.points.row(5), Eigen::RowVector3d(2, 1, 0));
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 2, -1}, {3, 4, 5, 6}}));
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].edges, Edges{});
    EXPECT_EQ(mesh.markers[1].name, "b");
    EXPECT_EQ(mesh.markers[1].edges, (Edges{{0, 1}, {3, 4}}));
    ASSERT_EQ(mesh.groups.size(), 3U);
    EXPECT_EQ(mesh.groups[0].name, "g");
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(1));
    EXPECT_EQ(mesh.groups[1].name, "piece 1");
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(0));
    EXPECT_THAT(mesh.groups[2].elements, ElementsAre(1));
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].values.col(0), (Eigen::VectorXd(7) << 1, 2, 3, 4, 5, 6, 7).finished());
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("its 2 pieces were joined"),
                                            HasSubstr("field(s) first that not all parts have")));
    EXPECT_EQ(notes.version, "0.1, ascii");
}

TEST(VtkPieces, CanBePickedByNumberOrName)
{
    EXPECT_EQ(read_zone(kPieces, "1").elements, (std::vector<Element>{{0, 1, 2, -1}}));
    const MeshData second = read_zone(kPieces, "piece 2");
    EXPECT_EQ(second.elements, (std::vector<Element>{{0, 1, 2, 3}}));
    ASSERT_EQ(second.groups.size(), 1U);
    EXPECT_THAT(test::message_of([] { read_zone(kPieces, "3"); }),
                HasSubstr("file: there is no piece '3'; there are piece 1, piece 2"));
}

/// Two pieces of poly data and two grids, in a folder with the collection.
class PvdFiles : public testing::Test {
protected:
    void SetUp() override
    {
        write_mesh_data(test::quad_square(1), folder_.file("square.vtu"));
        write_mesh_data(test::uneven_square(2), folder_.file("triangles.vtp"));
    }

    static std::string pvd(const std::string& sets)
    {
        return "<?xml version='1.0'?>\r\n<VTKFile type='Collection' version='0.1'>\n<Collection>\n" + sets +
               "</Collection></VTKFile>";
    }

    MeshData read(const std::string& sets, const std::string& zone = "", ReadNotes* notes = nullptr) const
    {
        const std::string bytes = pvd(sets);
        return find_format("", "pvd").read(
            {folder_.file("series.pvd"), bytes, {.surface = false, .zone = zone}, notes});
    }

    std::string refusal_of(const std::string& sets, const std::string& zone = "") const
    {
        return test::message_of([&] { read(sets, zone); });
    }

    test::TemporaryFolder folder_;
    std::string series_ = "<DataSet timestep='10' file='triangles.vtp'/>\n"
                          "<DataSet timestep='2.5e-1' group='' part='0' file='square.vtu'/>\n";
};

TEST_F(PvdFiles, TheLastTimeStepIsReadUnlessAnotherIsPicked)
{
    ReadNotes notes;
    EXPECT_EQ(difference(read(series_, "", &notes), test::uneven_square(2)), "");
    EXPECT_EQ(notes.version, "0.1, time 10");
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("of its 2 time steps the last was read, 10")));
    EXPECT_EQ(difference(read(series_, "1"), test::quad_square(1)), "");
    EXPECT_EQ(difference(read(series_, "0.25"), test::quad_square(1)), "");
    EXPECT_THAT(refusal_of(series_, "3"),
                HasSubstr("series.pvd: there is no time step '3'; there are 0.25, 10"));
}

TEST_F(PvdFiles, PartsOfATimeStepBecomeGroups)
{
    ReadNotes notes;
    const MeshData mesh = read("<DataSet part='0' name='wing' file='square.vtu'/>"
                               "<DataSet part='1' file='triangles.vtp'/>",
                               "", &notes);
    EXPECT_EQ(mesh.elements.size(), 1U + 8);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "wing");
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(0));
    EXPECT_EQ(mesh.groups[1].name, "part 1");
    EXPECT_EQ(mesh.markers.size(), 4U) << "both squares have the same four sides";
    EXPECT_EQ(mesh.markers[0].edges.size(), 1U + 2);
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("the 2 parts of a time step were joined")));
}

TEST_F(PvdFiles, WhatIsWrongIsSaidWithTheLine)
{
    EXPECT_THAT(refusal("<VTKFile type='Collection'/>", "pvd"),
                HasSubstr("file:1: expected <VTKFile type=\"Collection\"> with a <Collection>"));
    EXPECT_THAT(refusal_of(""), HasSubstr("series.pvd:3: the collection has no <DataSet>"));
    EXPECT_THAT(refusal_of("<DataSet timestep='soon' file='square.vtu'/>"),
                HasSubstr("series.pvd:4: timestep is 'soon', expected a number"));
    EXPECT_THAT(refusal_of("<DataSet timestep='1'/>"), HasSubstr("series.pvd:4: <DataSet> has no file"));
    EXPECT_THAT(refusal_of("\n<DataSet file='square.pvtu'/>"),
                HasSubstr("series.pvd:5: the file 'square.pvtu' is no .vtu, .vtp or .vtk"));
    EXPECT_THAT(refusal_of("<DataSet file='missing.vtu'/>"),
                testing::AllOf(HasSubstr("series.pvd:4: "), HasSubstr("missing.vtu: cannot be read")));
}

TEST_F(PvdFiles, SurviveMutation)
{
    test::survive_mutations("pvd", {pvd(series_), pvd("<DataSet part='1' name='a&amp;b' file='x.vtu'/>")},
                            2000);
}

TEST_F(PvdFiles, AreNotWritten)
{
    EXPECT_THAT(test::message_of([&] { write_mesh_data(test::quad_square(1), folder_.file("out.pvd")); }),
                HasSubstr("pvd can only be read"));
}

} // namespace

} // namespace morph
