#include "libmorph/weights/biharmonic.h"

#include "libmorph/numerics/dirichlet_system.h"
#include "libmorph/numerics/fan_laplacian.h"
#include "libmorph/weights/walled_triangulation.h"

#include <vector>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
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

class BiharmonicExtension : public BoundaryExtension {
public:
    BiharmonicExtension(const Mesh& mesh, const DirichletBoundary& boundary, int components = 1)
        : BoundaryExtension(mesh, boundary, components),
          triangulation_(walled_triangulation(mesh, boundary, held())), fans_(triangulation_),
          laplacian_(fan_laplacian(mesh, triangulation_, fans_, held().representatives())),
          system_(points(mesh).leftCols<2>(), bilaplacian(vertex_count(mesh), laplacian_), 1,
                  held().vertices())
    {
    }

protected:
    /// K M^-1 (K u - flux) = 0 at the free vertices. The second round takes back most of what rounding has
    /// done to the first, K M^-1 K being far worse conditioned than its factors.
    Matrix solve_with(const Matrix& flux, const Matrix& joined) const
    {
        const Matrix still = Matrix::Zero(joined.rows(), joined.cols());
        Matrix u = Matrix::Zero(static_cast<Index>(held().representatives().size()), joined.cols());
        for (Index i = 0; i < joined.rows(); ++i)
            u.row(held().vertices()[at(i)]) = joined.row(i);
        for (int round = 0; round < 2; ++round)
            u += system_.solve(still, laplacian_.load(u, flux));
        return u;
    }

    /// A row for each fan.
    Matrix no_flux(Eigen::Index columns) const
    {
        return Matrix::Zero(static_cast<Index>(fans_.count()), columns);
    }

    const Triangulation& triangulation() const { return triangulation_; }
    const TriangleFans& fans() const { return fans_; }

private:
    Matrix solve(const Matrix& joined) const override { return solve_with(no_flux(joined.cols()), joined); }

    Triangulation triangulation_;
    TriangleFans fans_;
    FanLaplacian laplacian_;
    DirichletSystem system_;
};

class ConformalBiharmonicExtension final : public BiharmonicExtension {
public:
    ConformalBiharmonicExtension(const Mesh& mesh, const DirichletBoundary& boundary)
        : BiharmonicExtension(mesh, boundary, 2), walls_(wall_edges(triangulation(), fans(), held()))
    {
    }

private:
    Matrix solve(const Matrix& joined) const override { return solve_with(flux(joined), joined); }

    /// The integral of du/dn along the walls next to each fan.
    Matrix flux(const Matrix& joined) const
    {
        Matrix sum = no_flux(2);
        for (const WallEdge& e : walls_) {
            const Eigen::RowVector2d along = joined.row(e.to) - joined.row(e.from);
            const Eigen::RowVector2d half(0.5 * along.y(), -0.5 * along.x());
            sum.row(static_cast<Index>(e.from_fan)) += half;
            sum.row(static_cast<Index>(e.to_fan)) += half;
        }
        return sum;
    }

    std::vector<WallEdge> walls_;
};

} // namespace

std::unique_ptr<BoundaryExtension> biharmonic_extension(const Mesh& mesh, const DirichletBoundary& boundary)
{
    return std::make_unique<BiharmonicExtension>(mesh, boundary);
}

std::unique_ptr<BoundaryExtension> conformal_biharmonic_extension(const Mesh& mesh,
                                                                  const DirichletBoundary& boundary)
{
    return std::make_unique<ConformalBiharmonicExtension>(mesh, boundary);
}

} // namespace morph
