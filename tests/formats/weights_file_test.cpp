#include "formats/weights_file.h"

#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/weight_fields.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::HasSubstr;

const std::vector<ControlPoint> kColumns{{"body", 0}, {"body", 1}};

/// A square whose weights are the coordinates.
struct SavedWeights {
    test::TemporaryFolder folder;
    std::string path = folder.file("weights.vtu");
    Mesh mesh = build_mesh(test::uneven_square(5));
    Matrix values = points(std::as_const(mesh)).leftCols(2);

    SavedWeights()
    {
        Mesh with_fields = mesh;
        with_fields.fields = weight_fields({kColumns, values});
        write_mesh_data(to_mesh_data(with_fields), path);
    }
};

TEST(WeightsFile, IsReadIntoTheNumberingOfTheMesh)
{
    const SavedWeights saved;
    EXPECT_EQ(read_weights(saved.path, saved.mesh, kColumns).values, saved.values);
    const Weights swapped = read_weights(saved.path, saved.mesh, {kColumns[1], kColumns[0]});
    EXPECT_EQ(swapped.values, Matrix(saved.values.rowwise().reverse()));
}

TEST(WeightsFile, IsRefusedForAnotherMeshOrOtherControlPoints)
{
    const SavedWeights saved;
    const auto refusal = [&](const Mesh& mesh, const std::vector<ControlPoint>& columns) {
        return test::message_of([&] { read_weights(saved.path, mesh, columns); });
    };
    EXPECT_THAT(refusal(build_mesh(test::uneven_square(4)), kColumns), HasSubstr("the mesh has 25"));
    EXPECT_THAT(refusal(build_mesh(test::uneven_square(5)), {{"wing", 0}}), HasSubstr("h_wing_1"));
    Mesh shifted = saved.mesh;
    points(shifted).array() += 1;
    EXPECT_THAT(refusal(shifted, kColumns), HasSubstr("is for another mesh"));
}

} // namespace
