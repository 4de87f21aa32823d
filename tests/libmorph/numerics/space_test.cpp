// Points in space: what the solvers do with three columns of coordinates.

#include "libmorph/numerics/conjugate_gradients.h"
#include "libmorph/numerics/dirichlet_laplacian.h"
#include "libmorph/numerics/nested_dissection.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace {

using namespace morph;

// The matrices here have condition numbers below 1e3.
constexpr double kSolveTol = 1e-12;

/// A grid of points in a box, each cell of it cut into six tetrahedra around its diagonal, with random
/// weights on their edges.
struct TetrahedralBox {
    TetrahedralBox(Index nx, Index ny, Index nz, double shift) : size{nx, ny, nz}, points(nx * ny * nz, 3)
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> off(-shift, shift), weight(0.1, 1);
        for (Index v = 0; v < points.rows(); ++v) {
            const auto at = cell(v);
            for (int d = 0; d < 3; ++d)
                points(v, d) = at[static_cast<std::size_t>(d)] + off(random);
            for (int corner = 1; corner < 8; ++corner)
                if (const Index w = beyond(v, corner); w >= 0)
                    edges.push_back({v, w, weight(random)});
        }
    }

    std::array<Index, 3> cell(Index v) const
    {
        return {v % size[0], v / size[0] % size[1], v / (size[0] * size[1])};
    }

    /// The vertex one step on in the directions whose bits are set, or -1.
    Index beyond(Index v, int directions) const
    {
        const auto at = cell(v);
        const std::array<Index, 3> stride{1, size[0], size[0] * size[1]};
        for (std::size_t d = 0; d < 3; ++d)
            if ((directions >> d & 1) != 0) {
                if (at[d] + 1 == size[d])
                    return -1;
                v += stride[d];
            }
        return v;
    }

    /// The vertices on the faces of the box.
    std::vector<Index> outside() const
    {
        std::vector<Index> found;
        for (Index v = 0; v < points.rows(); ++v) {
            const auto at = cell(v);
            bool out = false;
            for (std::size_t d = 0; d < 3; ++d)
                out = out || at[d] == 0 || at[d] + 1 == size[d];
            if (out)
                found.push_back(v);
        }
        return found;
    }

    /// The sum of weight (h_a - h_b)^2, and shift h^2, as a dense matrix.
    Eigen::MatrixXd dense(double shift) const
    {
        Eigen::MatrixXd L = shift * Eigen::MatrixXd::Identity(points.rows(), points.rows());
        for (const auto& [a, b, weight] : edges) {
            L(a, a) += weight;
            L(b, b) += weight;
            L(a, b) -= weight;
            L(b, a) -= weight;
        }
        return L;
    }

    std::array<Index, 3> size;
    Points points;
    std::vector<WeightedEdge> edges;
};

SymmetricMatrix sparse(const Eigen::MatrixXd& dense)
{
    SymmetricMatrix A;
    A.start.push_back(0);
    for (Index i = 0; i < dense.rows(); ++i) {
        A.diagonal.push_back(dense(i, i));
        for (Index j = 0; j < dense.cols(); ++j)
            if (i != j && dense(i, j) != 0) {
                A.column.push_back(j);
                A.value.push_back(dense(i, j));
            }
        A.start.push_back(A.column.size());
    }
    return A;
}

TEST(DirichletLaplacianInSpace, AgreesWithADenseFactorisation)
{
    const TetrahedralBox box(9, 8, 10, 0.3);
    const std::vector<Index> held = box.outside();
    const Matrix values = Matrix::Random(static_cast<Index>(held.size()), 3);
    const Matrix h = DirichletLaplacian(box.points, box.edges, held).solve(values);

    std::vector<Index> free;
    for (Index v = 0; v < box.points.rows(); ++v)
        if (!std::binary_search(held.begin(), held.end(), v))
            free.push_back(v);
    ASSERT_EQ(free.size(), 7U * 6 * 8);
    const Eigen::MatrixXd L = box.dense(0);
    const Matrix expected = L(free, free).llt().solve(-L(free, held) * values);
    EXPECT_EQ(h(held, Eigen::all), values);
    EXPECT_LE((h(free, Eigen::all) - expected).norm(), kSolveTol * expected.norm());
}

TEST(ConjugateGradientsInSpace, AgreeWithADenseFactorisation)
{
    const TetrahedralBox box(7, 8, 9, 0.3);
    const Eigen::MatrixXd dense = box.dense(0.5);
    const Matrix b = Matrix::Random(dense.rows(), 1);
    const Matrix expected = dense.llt().solve(b);
    Matrix x = b;
    conjugate_gradients(sparse(dense), box.points, {100, 1e-14, 200}, x);
    EXPECT_LE((x - expected).norm(), kSolveTol * expected.norm());
}

TEST(NestedDissectionInSpace, CutsALongBoxAcrossWhicheverAxisItLies)
{
    for (const auto& [nx, ny, nz] : {std::array{40, 4, 4}, {4, 40, 4}, {4, 4, 40}}) {
        const TetrahedralBox box(nx, ny, nz, 0);
        const Dissection tree = nested_dissection(sparse(box.dense(1)), box.points);
        EXPECT_EQ(tree.nodes.back().end - tree.nodes.back().begin, 16) << nx << ' ' << ny << ' ' << nz;
    }
}

TEST(NestedDissectionInSpace, OfAPlaneIsThatOfTwoColumns)
{
    TetrahedralBox box(24, 20, 1, 0.3);
    box.points.col(2).setZero();
    const SymmetricMatrix A = sparse(box.dense(1));
    const Dissection space = nested_dissection(A, box.points);
    const Dissection plane = nested_dissection(A, box.points.leftCols<2>());
    EXPECT_EQ(space.order, plane.order);
    EXPECT_EQ(space.nodes.size(), plane.nodes.size());
}

} // namespace
