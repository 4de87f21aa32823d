#include "tests/support/dense_projection.h"

#include "tests/support/exact_overlap.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace morph::test {

namespace {

/// The triangles of a mesh, in its own numbering.
MeshData triangles_of(const Mesh& mesh)
{
    MeshData data;
    data.points = points(mesh);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        data.elements.push_back({e[0], e[1], e[2], -1});
        if (corner_count(e) == 4)
            data.elements.push_back({e[0], e[2], e[3], -1});
    }
    return data;
}

/// The basis functions of a triangle's corners at points: one row for each point.
Eigen::MatrixX3d basis_at(const MeshData& mesh, Index triangle, const Points2& at)
{
    Eigen::Matrix2d sides;
    const Element& e = mesh.elements[static_cast<std::size_t>(triangle)];
    for (Eigen::Index k = 0; k < 2; ++k)
        sides.col(k) =
            (mesh.points.row(e[static_cast<std::size_t>(k + 1)]) - mesh.points.row(e[0])).head<2>();
    const Eigen::Matrix2Xd offsets = at.transpose().colwise() - mesh.points.row(e[0]).head<2>().transpose();
    Eigen::MatrixX3d basis(at.rows(), 3);
    basis.rightCols(2) = sides.fullPivLu().solve(offsets).transpose();
    basis.col(0) = 1 - basis.col(1).array() - basis.col(2).array();
    return basis;
}

/// Weights that integrate products of linear functions over a convex polygon, given at its corners: of each
/// triangle of the fan area / 12 (sum f g + sum f sum g).
Eigen::MatrixXd product_weights(const Points2& polygon)
{
    const Eigen::Index n = polygon.rows();
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index k = 2; k < n; ++k) {
        const Eigen::RowVector2d a = polygon.row(k - 1) - polygon.row(0), b = polygon.row(k) - polygon.row(0);
        const double area = std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
        const std::array<Eigen::Index, 3> corner{0, k - 1, k};
        for (const Eigen::Index i : corner)
            for (const Eigen::Index j : corner)
                weights(i, j) += area / 12 * (i == j ? 2 : 1);
    }
    return weights;
}

} // namespace

DenseProjection dense_projection(const Mesh& source, const Mesh& target)
{
    const MeshData from = triangles_of(source), to = triangles_of(target);
    DenseProjection dense{Eigen::MatrixXd::Zero(vertex_count(target), vertex_count(target)),
                          Eigen::MatrixXd::Zero(vertex_count(target), vertex_count(source))};
    for (const ExactOverlap& overlap : exact_overlaps(from, to))
        for (const Points2& part : overlap.parts) {
            const Eigen::MatrixX3d phi = basis_at(to, overlap.target, part);
            const Eigen::MatrixX3d psi = basis_at(from, overlap.source, part);
            const Eigen::MatrixXd weights = product_weights(part);
            const Eigen::Matrix3d own = phi.transpose() * weights * phi,
                                  mixed = phi.transpose() * weights * psi;
            const Element& t = to.elements[static_cast<std::size_t>(overlap.target)];
            const Element& s = from.elements[static_cast<std::size_t>(overlap.source)];
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) {
                    dense.M(t[i], t[j]) += own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                    dense.B(t[i], s[j]) += mixed(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                }
        }
    return dense;
}

} // namespace morph::test
