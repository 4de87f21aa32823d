#include "formats/formats.h"
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
using test::rich_meshes;
using test::written;
using testing::HasSubstr;

TEST(Cgns, HoldsEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "cgns"), "cgns")), "") << name;
}

TEST(Cgns, SurvivesMutatedFiles)
{
    test::survive_mutations("cgns", {written(rich_meshes()[4].second, "cgns")}, 2000);
}

} // namespace

} // namespace morph
