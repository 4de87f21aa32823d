#include "libmorph/weights/biharmonic.h"

#include "libmorph/geometry/delaunay.h"
#include "libmorph/numerics/dirichlet_system.h"
#include "libmorph/numerics/fan_laplacian.h"
#include "libmorph/weights/unique_dirichlet_vertices.h"

#include <vector>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

Triangulation delaunay(const Mesh& mesh, const DirichletBoundary& held)
{
    Triangulation triangulation = triangulate(mesh);
    cut_along(triangulation, held.walls);
    make_delaunay(points(mesh), triangulation);
    return triangulation;
}

/// Boundary edge with both ends held, the mesh on its left.
struct WallEdge {
    Index from, to; // rows in UniqueDirichletVertices::vertices()
    std::size_t from_fan, to_fan;
};

std::vector<WallEdge> wall_edges(const Triangulation& triangulation, const TriangleFans& fans,
                                 const UniqueDirichletVertices& held)
{
    std::vector<Index> row(held.representatives().size(), -1);
    for (std::size_t i = 0; i < held.vertices().size(); ++i)
        row[at(held.vertices()[i])] = static_cast<Index>(i);
    std::vector<WallEdge> walls;
    for (std::size_t t = 0; t < triangulation.corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            const auto row_of = [&](std::size_t c) {
                return row[at(held.representatives()[at(triangulation.corners[t][c])])];
            };
            if (triangulation.neighbours[t][k] < 0 && row_of(a) >= 0 && row_of(b) >= 0)
                walls.push_back({row_of(a), row_of(b), fans.fan(t, a), fans.fan(t, b)});
        }
    return walls;
}

/// What both kinds of biharmonic functions have.
struct Biharmonic {
    Biharmonic(const Mesh& mesh, const DirichletBoundary& boundary)
        : held(mesh, boundary), triangulation(delaunay(mesh, boundary)), fans(triangulation),
          laplacian(fan_laplacian(mesh, triangulation, fans, held.representatives())),
          system(points(mesh), bilaplacian(vertex_count(mesh), laplacian), 1, held.vertices())
    {
    }

    /// K M^-1 (K u - flux) = 0 at the free vertices. The second round takes back most of what rounding has
    /// done to the first, K M^-1 K being far worse conditioned than its factors.
    Matrix solve(const Matrix& values, const Matrix& flux) const
    {
        const Matrix joined = held.join(values), still = Matrix::Zero(joined.rows(), joined.cols());
        Matrix u = Matrix::Zero(static_cast<Index>(held.representatives().size()), joined.cols());
        for (Index i = 0; i < joined.rows(); ++i)
            u.row(held.vertices()[at(i)]) = joined.row(i);
        for (int round = 0; round < 2; ++round)
            u += system.solve(still, laplacian.load(u, flux));
        held.finish(joined, u);
        return u;
    }

    UniqueDirichletVertices held;
    Triangulation triangulation;
    TriangleFans fans;
    FanLaplacian laplacian;
    DirichletSystem system;
};

class BiharmonicSpread final : public BoundaryExtension {
public:
    BiharmonicSpread(const Mesh& mesh, const DirichletBoundary& held) : parts_(mesh, held) {}

    Matrix extend(const Matrix& values) const override
    {
        return parts_.solve(values, Matrix::Zero(static_cast<Index>(parts_.fans.count()), values.cols()));
    }

private:
    Biharmonic parts_;
};

class ConformalBiharmonicSpread final : public CoupledExtension {
public:
    ConformalBiharmonicSpread(const Mesh& mesh, const DirichletBoundary& held)
        : parts_(mesh, held), walls_(wall_edges(parts_.triangulation, parts_.fans, parts_.held))
    {
    }

    Points2 extend(const Points2& displacements) const override
    {
        return parts_.solve(displacements, flux(parts_.held.join(displacements)));
    }

private:
    /// The integral of du/dn along the walls beside each fan.
    Matrix flux(const Matrix& joined) const
    {
        Matrix sum = Matrix::Zero(static_cast<Index>(parts_.fans.count()), 2);
        for (const WallEdge& e : walls_) {
            const Eigen::RowVector2d along = joined.row(e.to) - joined.row(e.from);
            const Eigen::RowVector2d half(0.5 * along.y(), -0.5 * along.x());
            sum.row(static_cast<Index>(e.from_fan)) += half;
            sum.row(static_cast<Index>(e.to_fan)) += half;
        }
        return sum;
    }

    Biharmonic parts_;
    std::vector<WallEdge> walls_;
};

} // namespace

std::unique_ptr<BoundaryExtension> biharmonic_extension(const Mesh& mesh, const DirichletBoundary& held)
{
    return std::make_unique<BiharmonicSpread>(mesh, held);
}

std::unique_ptr<CoupledExtension> conformal_biharmonic_extension(const Mesh& mesh,
                                                                 const DirichletBoundary& held)
{
    return std::make_unique<ConformalBiharmonicSpread>(mesh, held);
}

} // namespace morph
