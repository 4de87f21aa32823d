#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace {

using namespace morph;

void expect_same(const MeshData& a, const MeshData& b)
{
    EXPECT_EQ(a.dimension, b.dimension);
    ASSERT_EQ(a.points.rows(), b.points.rows());
    EXPECT_EQ(0, std::memcmp(a.points.data(), b.points.data(),
                             sizeof(double) * static_cast<std::size_t>(a.points.size())))
        << "some coordinate changed its bits";
    EXPECT_EQ(a.elements, b.elements);
    ASSERT_EQ(a.markers.size(), b.markers.size());
    for (std::size_t i = 0; i < a.markers.size(); ++i) {
        EXPECT_EQ(a.markers[i].name, b.markers[i].name);
        EXPECT_EQ(a.markers[i].edges, b.markers[i].edges);
    }
    ASSERT_EQ(a.carried.size(), b.carried.size());
    for (std::size_t i = 0; i < a.carried.size(); ++i) {
        EXPECT_EQ(a.carried[i].what, b.carried[i].what);
        EXPECT_EQ(a.carried[i].text, b.carried[i].text);
    }
}

TEST(Su2, WritesEveryRealMeshAsItWasRead)
{
    const test::TemporaryFolder folder;
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const MeshData mesh = read_mesh_data(path);
        EXPECT_THAT(write_mesh_data(mesh, folder.file("out.su2")), testing::IsEmpty());
        expect_same(mesh, read_mesh_data(folder.file("out.su2")));
    }
}

} // namespace
