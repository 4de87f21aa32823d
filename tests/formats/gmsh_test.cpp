// Gmsh's .msh files: what is written and read back.
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::written;

TEST(Gmsh, HoldsEveryMeshBitForBitAsTextAndBinary)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        for (const bool binary : {false, true})
            EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "gmsh", {.binary = binary}), "gmsh")), "")
                << name << (binary ? " binary" : " as text");
}

TEST(Gmsh, SurvivesMutatedFiles)
{
    MeshData mesh = test::rich_meshes()[2].second;
    mesh.groups = {{"in", {1, 2}}, {"out", {2, 4}}};
    test::survive_mutations(
        "gmsh", {written(mesh, "gmsh", {.binary = false}), written(mesh, "gmsh", {.binary = true})}, 2000);
}

} // namespace

} // namespace morph
