#include "tests/support/boundary_moves.h"

#include "libmorph/quality/quality.h"

#include <cmath>
#include <numbers>
#include <set>

namespace morph::test {

namespace {

Index file_number(const Mesh& mesh, Index v)
{
    return mesh.numbering.vertex[static_cast<std::size_t>(v)];
}

Eigen::RowVector2d moved_by(const Move& move, const Mesh& mesh, Index v)
{
    return move(points(mesh)(v, 0), points(mesh)(v, 1));
}

} // namespace

DirichletBoundary dirichlet_boundary(const Mesh& mesh, const std::vector<std::string>& moving)
{
    DirichletBoundary held;
    std::set<Index> known;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v) && !mesh.kernel.is_isolated(v) &&
            known.insert(file_number(mesh, v.idx())).second)
            held.vertices.push_back(v.idx());
    for (const std::string& name : moving) {
        const auto& edges = marker(mesh, name).edges;
        held.moving_edges.insert(held.moving_edges.end(), edges.begin(), edges.end());
    }
    return held;
}

std::vector<bool> is_moving(const Mesh& mesh, const DirichletBoundary& held)
{
    std::set<Index> moving;
    for (const auto& edge : held.moving_edges)
        for (const Index v : edge)
            moving.insert(file_number(mesh, v));
    std::vector<bool> result;
    for (const Index v : held.vertices)
        result.push_back(moving.count(file_number(mesh, v)) > 0);
    return result;
}

Move turn(double degrees, std::array<double, 2> centre)
{
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return [=](double x, double y) {
        const double dx = x - centre[0], dy = y - centre[1];
        return Eigen::RowVector2d(c * dx - s * dy - dx, s * dx + c * dy - dy);
    };
}

Matrix boundary_displacement(const Mesh& mesh, const DirichletBoundary& held, const Move& move)
{
    const std::vector<bool> moving = is_moving(mesh, held);
    Matrix displacement = Matrix::Zero(static_cast<Index>(held.vertices.size()), 2);
    for (std::size_t i = 0; i < moving.size(); ++i)
        if (moving[i])
            displacement.row(static_cast<Index>(i)) = moved_by(move, mesh, held.vertices[i]);
    return displacement;
}

Matrix displacement_everywhere(const Mesh& mesh, const Move& move)
{
    Matrix displacement(vertex_count(mesh), 2);
    for (Index v = 0; v < displacement.rows(); ++v)
        displacement.row(v) = moved_by(move, mesh, v);
    return displacement;
}

Index inverted_after(const Mesh& mesh, const Matrix& displacement)
{
    Points moved = points(mesh);
    moved.leftCols<2>() += displacement;
    return static_cast<Index>(inverted_elements(mesh, moved).size());
}

double difference(const Matrix& a, const Matrix& b)
{
    return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

} // namespace morph::test
