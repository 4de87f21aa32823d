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

/// A hybrid mesh with elements of no group, of one and of two, and a group of none.
MeshData grouped()
{
    MeshData mesh = test::rich_meshes()[2].second;
    mesh.groups = {{"inner \"core\"", {1, 2, 5}}, {"no group", {0}}, {"empty", {}}, {"outer", {2, 4, 5, 7}}};
    return mesh;
}

TEST(Gmsh, HoldsEveryMeshBitForBit)
{
    std::vector<std::pair<std::string, MeshData>> meshes = test::rich_meshes();
    meshes.emplace_back("groups", grouped());
    for (const auto& [name, mesh] : meshes)
        for (const char* format : {"gmsh", "gmsh22"})
            for (const bool binary : {false, true})
                EXPECT_EQ(difference(mesh, read_bytes(written(mesh, format, {.binary = binary}), format)), "")
                    << name << " as " << format << (binary ? " binary" : " text");
}

TEST(Gmsh, SurvivesMutatedFiles)
{
    for (const char* format : {"gmsh", "gmsh22"})
        test::survive_mutations(format,
                                {written(grouped(), format, {.binary = false}),
                                 written(grouped(), format, {.binary = true})},
                                2000);
}

} // namespace

} // namespace morph
