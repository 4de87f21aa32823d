#include "libmorph/core/error.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/controlled_points.h"
#include "tests/support/errors.h"
#include "tests/support/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::HasSubstr;

// A handful of products and sums of numbers of size 1.
constexpr double kRoundOff = 1e-14;

TEST(ControlledPoints, OfVerticesMoveAsTheMeshDoes)
{
    const Weights weights = test::random_weights(40, 6);
    const Points start = Points::Random(40, 3);
    const std::vector<Index> vertices = {39, 0, 7};
    const ControlledPoints points = controlled_vertices(weights, start, vertices);
    for (const int components : {2, 3}) {
        const Matrix D = Matrix::Random(6, components);
        Points mesh = start;
        apply_weights(weights, D, {mesh.data(), mesh.rows(), 3});
        EXPECT_LE((moved(points, D) - mesh(vertices, Eigen::all)).norm(), kRoundOff) << components;
    }
}

TEST(ControlledPoints, OfElementsMoveWithTheirCorners)
{
    const Weights weights = test::random_weights(40, 6);
    const Points start = Points::Random(40, 3);
    const ControlledPoints points = controlled_points(weights, start, {{{3, 8, 20}, {0.5, 0.2, 0.3}}});
    const Matrix D = Matrix::Random(6, 3);
    Points mesh = start;
    apply_weights(weights, D, {mesh.data(), mesh.rows(), 3});
    const Eigen::RowVector3d expected = 0.5 * mesh.row(3) + 0.2 * mesh.row(8) + 0.3 * mesh.row(20);
    EXPECT_LE((moved(points, D) - expected).norm(), kRoundOff);
}

TEST(ControlledPoints, AreTheSameFromSparseWeights)
{
    const SparseWeights sparse = test::random_sparse_weights(40, 9);
    const Weights dense{sparse.columns, sparse.values};
    const Points start = Points::Random(40, 3);
    const ControlledPoints from_sparse = controlled_vertices(sparse, start, {5, 6});
    const ControlledPoints from_dense = controlled_vertices(dense, start, {5, 6});
    EXPECT_EQ(from_sparse.positions, from_dense.positions);
    EXPECT_EQ(Matrix(from_sparse.weights), Matrix(from_dense.weights));
    EXPECT_EQ(from_dense.weights.nonZeros(), from_sparse.weights.nonZeros());
}

TEST(ControlledPoints, RefuseWhatTheMeshDoesNotHave)
{
    const Weights weights = test::random_weights(10, 2);
    const Points start = Points::Zero(10, 3);
    EXPECT_THAT(test::message_of([&] { controlled_vertices(weights, start, {10}); }),
                HasSubstr("names vertex 10, but the mesh has 10"));
    EXPECT_THAT(test::message_of([&] {
                    controlled_points(weights, start, {{{1, 2}, {1.0}}});
                }),
                HasSubstr("2 vertices and 1 shares"));
    EXPECT_THROW(controlled_vertices(weights, Points::Zero(9, 3), {0}), InputError);
}

} // namespace
