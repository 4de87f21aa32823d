#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/quality/quality.h"
#include "libmorph/weights/boundary_extension.h"

#include <Eigen/Geometry>

#include <numbers>
#include <string>

namespace morph::test {

/// The whole boundary is held, the edges of the named marker move.
inline DirichletBoundary whole_boundary(const Mesh& mesh, const std::string& moving)
{
    DirichletBoundary held;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v))
            held.vertices.push_back(v.idx());
    held.moving_edges = marker(mesh, moving).edges;
    return held;
}

/// f(x, y), a row vector, at each of these vertices.
template <typename F>
Matrix values_at(const Mesh& mesh, const std::vector<Index>& vertices, const F& f)
{
    Matrix values(static_cast<Index>(vertices.size()), f(0.0, 0.0).cols());
    for (Index i = 0; i < values.rows(); ++i) {
        const auto at = points(mesh).row(vertices[static_cast<std::size_t>(i)]);
        values.row(i) = f(at[0], at[1]);
    }
    return values;
}

/// f(x, y), a row vector, at every vertex.
template <typename F>
Matrix values_at(const Mesh& mesh, const F& f)
{
    Matrix values(vertex_count(mesh), f(0.0, 0.0).cols());
    for (Index v = 0; v < values.rows(); ++v)
        values.row(v) = f(points(mesh)(v, 0), points(mesh)(v, 1));
    return values;
}

/// How the airfoil of unit chord of a real mesh, its farfield at rest, turns about its middle.
inline auto turned_airfoil(double degrees)
{
    return [turn = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180)](double x, double y) {
        const Eigen::Vector2d from_centre(x - 0.5, y);
        const Eigen::Vector2d moved = turn * from_centre - from_centre;
        return Eigen::RowVector2d((from_centre.norm() < 2 ? 1 : 0) * moved.transpose());
    };
}

/// Elements that a displacement (n x 2) turns over.
inline Index inverted_by(const Mesh& mesh, const Points2& displacement)
{
    Points moved = points(mesh);
    moved.leftCols<2>() += displacement;
    return static_cast<Index>(inverted_elements(mesh, moved).size());
}

} // namespace morph::test
