#include "libmorph/remap/mass_matrix.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/convex_parts.h"
#include "tests/support/meshes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;

struct Problem {
    Mesh mesh = build_mesh(test::quad_square(6));
    std::vector<Index> first_piece;
    std::vector<TriangleMass> masses;
    Eigen::MatrixXd dense;
};

/// The consistent mass of the triangles of a mesh of quads, without the first @p left_out triangles.
Problem problem(Index left_out)
{
    Problem made;
    const Index n = vertex_count(made.mesh);
    made.dense = Eigen::MatrixXd::Zero(n, n);
    for (Index f = 0; f < element_count(made.mesh); ++f) {
        made.first_piece.push_back(2 * f);
        for (const ConvexParts pieces = split_convex(made.mesh, f, Cut::triangles);
             const ConvexPart& piece : pieces.all()) {
            const bool out = static_cast<Index>(made.masses.size()) < left_out;
            const double a = out ? 0 : piece.area;
            made.masses.push_back({a / 6, a / 12, a / 12, a / 6, a / 12, a / 6});
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    made.dense(piece.vertices[i], piece.vertices[j]) += i == j ? a / 6 : a / 12;
        }
    }
    made.first_piece.push_back(static_cast<Index>(made.masses.size()));
    return made;
}

TEST(MassMatrix, SolvesAsADenseFactorisationDoes)
{
    constexpr double kSolve = 1e-13; // its condition number is below 10
    const Problem p = problem(0);
    Matrix R = Matrix::Random(p.dense.rows(), 4);
    R.col(1).setZero();
    const Matrix exact = p.dense.llt().solve(R);
    const Eigen::RowVector4d scale(1, 1, 1e-200, 1e300); // each column has steps and a goal of its own
    const Matrix X = MassMatrix(p.mesh, p.first_piece, p.masses).solve(R.array().rowwise() * scale.array());
    const Matrix error = (X.array().rowwise() / scale.array()).matrix() - exact;
    for (Eigen::Index k = 0; k < 4; ++k)
        EXPECT_LE(error.col(k).norm(), kSolve * exact.col(k).norm()) << "column " << k;
}

TEST(MassMatrix, LeavesVerticesWithoutMassAtZero)
{
    const Problem p = problem(30);
    const MassMatrix M(p.mesh, p.first_piece, p.masses);
    const Matrix X = M.solve(Matrix::Ones(p.dense.rows(), 1));
    int empty = 0;
    for (Index v = 0; v < vertex_count(p.mesh); ++v) {
        EXPECT_NEAR(M.row_sums()[static_cast<std::size_t>(v)], p.dense.row(v).sum(),
                    1e-16); // sums of about 0.03
        if (p.dense(v, v) == 0) {
            EXPECT_EQ(X(v, 0), 0);
            ++empty;
        }
    }
    EXPECT_GT(empty, 5);
    EXPECT_LE(
        (p.dense * X - (p.dense.rowwise().sum().array() > 0).select(Matrix::Ones(X.rows(), 1), 0)).norm(),
        1e-13);
}

TEST(MassMatrix, SaysWhenItDoesNotConverge)
{
    const Problem p = problem(0);
    const MassMatrix M(p.mesh, p.first_piece, p.masses);
    EXPECT_THROW(M.solve(Matrix::Constant(p.dense.rows(), 1, NAN)), SolverError);
}

} // namespace
