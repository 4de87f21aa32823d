#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::rich_meshes;
using test::written;
using testing::HasSubstr;

TEST(Vtk, BinaryFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtk"), "vtk")), "") << name;
}

TEST(Vtk, AsciiFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtk", {.binary = false}), "vtk")), "") << name;
}

TEST(Vtk, SurvivesMutatedFiles)
{
    const MeshData mesh = rich_meshes()[4].second;
    test::survive_mutations("vtk", {written(mesh, "vtk"), written(mesh, "vtk", {.binary = false})}, 600);
}

} // namespace

} // namespace morph
