#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include <gtest/gtest.h>
namespace {
using namespace morph;
TEST(Tecplot, HoldsEveryRichMeshBitForBit)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        EXPECT_EQ(test::difference(mesh, test::read_bytes(test::written(mesh, "tecplot"), "tecplot")), "") << name;
}
}
