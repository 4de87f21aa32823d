#include "libmorph/deform/repair_in_steps.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::dirichlet_boundary;

constexpr double kLanding = 1e-15; // place + displacement, of about 1

void expect_landed(const Mesh& start, const DirichletBoundary& held, const Matrix& displacement,
                   const Points& after)
{
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        EXPECT_LE((after.row(held.vertices[i]).head<2>() - points(start).row(held.vertices[i]).head<2>() -
                   displacement.row(static_cast<Index>(i)))
                      .norm(),
                  4 * kLanding);
}

TEST(RepairInSteps, FollowsABodyThatTurnsAndOneThatGetsANotch)
{
    const Mesh start = build_mesh(test::uneven_annulus(0.5, 3, 60));
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    const test::Move notch = [](double x, double y) {
        return Eigen::RowVector2d(x > 0 ? -0.75 * std::exp(-std::pow(y / 0.12, 2)) : 0, 0);
    };
    for (const test::Move& move : {test::turn(175, {0.1, 0}), notch}) {
        const Matrix D = boundary_displacement(start, held, move);
        UntangleResult work;
        const Points after = repair_in_steps(start, held, D, work);
        EXPECT_TRUE(inverted_elements(start, after).empty());
        EXPECT_GT(work.patch_vertices, 0);
        expect_landed(start, held, D, after);
    }
}

TEST(RepairInSteps, EndsAlsoWhereNoValidMeshExists)
{
    // The hole has left the domain.
    const Mesh start = build_mesh(test::uneven_annulus(0.5, 3, 30));
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    const Matrix D =
        boundary_displacement(start, held, [](double, double) { return Eigen::RowVector2d(8, 0); });
    UntangleResult work;
    const Points after = repair_in_steps(start, held, D, work);
    EXPECT_FALSE(inverted_elements(start, after).empty());
    expect_landed(start, held, D, after);
}

TEST(RepairInSteps, MovesCopiesOfASplitVertexTogether)
{
    const Mesh start = build_mesh(test::touching_squares(6));
    DirichletBoundary held;
    for (const VertexHandle v : start.kernel.vertices())
        if (start.kernel.is_boundary(v))
            held.vertices.push_back(v.idx());
    Matrix D(static_cast<Index>(held.vertices.size()), 2);
    for (std::size_t i = 0; i < held.vertices.size(); ++i) {
        const auto x = points(start).row(held.vertices[i]);
        D.row(static_cast<Index>(i)) << 0.4 * std::sin(2 * x(1)), 0.3 * x(0);
    }
    UntangleResult work;
    const Points after = repair_in_steps(start, held, D, work);
    EXPECT_TRUE(inverted_elements(start, after).empty());
    expect_landed(start, held, D, after);
}

} // namespace
