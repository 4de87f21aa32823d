#include "libmorph/pipeline/detail/lattice_fit.h"

#include "libmorph/deform/controlled_points.h"

#include <Eigen/Cholesky>

namespace morph {

namespace {

/// Displacements of the curves' nodes as their control points give them.
Matrix node_displacements(const PlacedBoundaries& curves, std::vector<Index>& vertices)
{
    std::vector<Eigen::RowVector2d> target;
    for (std::size_t b = 0; b < curves.boundaries.size(); ++b) {
        const CurveBoundary& boundary = curves.boundaries[b];
        const Curve moved = moved_curve(curves, b, curves.displacements);
        for (std::size_t i = 0; i < boundary.vertices.size(); ++i) {
            const double u = boundary.parameters[i].u;
            vertices.push_back(boundary.vertices[i]);
            target.emplace_back((moved.point(u) - boundary.curve.point(u)).transpose());
        }
    }
    Matrix rows(static_cast<Index>(target.size()), 2);
    for (std::size_t i = 0; i < target.size(); ++i)
        rows.row(static_cast<Index>(i)) = target[i];
    return rows;
}

} // namespace

double fit_lattice(const Mesh& mesh, const PreparedMotion& motion, Matrix& displacements)
{
    constexpr double kSmallest = 1e-3;
    std::vector<Index> vertices;
    const Matrix target = node_displacements(motion.curves, vertices);
    const ControlledPoints nodes = controlled_vertices(motion.rows(), points(mesh), vertices);
    Eigen::MatrixXd R(nodes.weights);
    for (const Index held : motion.held())
        R.col(held).setZero();
    const Eigen::MatrixXd start = target - R * displacements;
    const double damping = kSmallest * R.colwise().norm().maxCoeff();
    Eigen::MatrixXd normal = R.transpose() * R;
    normal.diagonal().array() += damping * damping;
    displacements += normal.ldlt().solve(R.transpose() * start);
    return (target - R * displacements).rowwise().norm().maxCoeff();
}

} // namespace morph
