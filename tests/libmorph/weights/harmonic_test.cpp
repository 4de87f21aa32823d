#include "libmorph/weights/harmonic.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace morph;

// One sparse solve of a well-conditioned system loses a few digits; n is some hundreds here.
constexpr double kSolveTol = 1e-12;

// The bounds 0 and 1 hold for exact arithmetic on the rounded matrix. Each of a value's few thousand
// predecessors in the elimination adds at most one rounding.
constexpr double kBoundTol = 1e-13;

constexpr Diffusivity kDiffusivities[] = {Diffusivity::uniform, Diffusivity::inverse_distance,
                                          Diffusivity::inverse_area};

std::vector<Index> boundary_vertices(const Mesh& mesh)
{
    std::vector<Index> found;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v))
            found.push_back(v.idx());
    return found;
}

/// Hold the whole boundary at values(x, y), a function that returns a row of K; the edges of the named
/// marker move.
template <typename Values>
HarmonicProblem held_boundary(const Mesh& mesh, Index columns, const Values& values,
                              const std::string& moving = "")
{
    HarmonicProblem problem;
    problem.held.vertices = boundary_vertices(mesh);
    problem.held.values.resize(static_cast<Index>(problem.held.vertices.size()), columns);
    for (Index i = 0; i < problem.held.values.rows(); ++i) {
        const Index v = problem.held.vertices[static_cast<std::size_t>(i)];
        problem.held.values.row(i) = values(points(mesh)(v, 0), points(mesh)(v, 1));
    }
    problem.moving_edges = moving.empty() ? mesh.markers.front().edges : marker(mesh, moving).edges;
    return problem;
}

Eigen::RowVector3d affine(double x, double y)
{
    return {1.0, 0.3 * x - 2 * y + 0.7, 5 * y - x};
}

void expect_affine_reproduced(const Mesh& mesh)
{
    const Matrix h = harmonic_weights(mesh, held_boundary(mesh, 3, affine), Diffusivity::uniform);
    Matrix exact(h.rows(), 3);
    for (Index v = 0; v < h.rows(); ++v)
        exact.row(v) = affine(points(mesh)(v, 0), points(mesh)(v, 1));
    EXPECT_LE((h - exact).norm(), kSolveTol * exact.norm());
}

TEST(HarmonicWeights, ReproduceAnAffineFunctionOnTriangles)
{
    expect_affine_reproduced(build_mesh(test::uneven_square(20)));
}

TEST(HarmonicWeights, ReproduceAnAffineFunctionOnQuads)
{
    expect_affine_reproduced(build_mesh(test::quad_square(20)));
}

TEST(HarmonicWeights, KeepTheirBoundsForEveryDiffusivity)
{
    const Mesh mesh = build_mesh(test::annulus(0.5, 3, 40, 20));
    const auto on_inner = [](double x, double y) {
        const double part = std::hypot(x, y) < 1 ? 0.5 + x : 0;
        return Eigen::RowVector2d(part, std::hypot(x, y) < 1 ? 1 - part : 0);
    };
    for (const Diffusivity g : kDiffusivities) {
        const Matrix h = harmonic_weights(mesh, held_boundary(mesh, 2, on_inner, "inner"), g);
        EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), -kBoundTol);
        EXPECT_LE(h.rowwise().sum().maxCoeff<Eigen::PropagateNaN>(), 1 + kBoundTol);
    }
}

TEST(HarmonicWeights, RefuseAPartThatIsNotHeld)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    EXPECT_THROW(harmonic_weights(mesh, {}, Diffusivity::uniform), InputError);
}

TEST(HarmonicWeights, RefuseASurfaceInSpace)
{
    Mesh mesh = build_mesh(test::uneven_square(4));
    const HarmonicProblem problem = held_boundary(mesh, 3, affine);
    mesh.dimension = 3;
    EXPECT_THROW(harmonic_weights(mesh, problem, Diffusivity::uniform), InputError);
}

} // namespace
