#include "libmorph/mesh/builder.h"

#include "libmorph/core/error.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

TEST(BuildMesh, GivesBackWhatItWasGiven)
{
    for (const MeshData& data : {test::uneven_square(7), test::quad_square(6), test::annulus(1, 10, 40, 12)})
        for (const unsigned seed : {1U, 2U, 3U}) {
            MeshData listed = test::shuffled(data, seed);
            test::turn_some(listed, 0.3, seed);
            const Mesh mesh = build_mesh(listed);
            test::expect_sound(mesh);
            test::expect_same(to_data(mesh), listed);
        }
}

} // namespace

} // namespace morph
