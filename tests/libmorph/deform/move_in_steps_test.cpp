#include "libmorph/deform/move_in_steps.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/weights/harmonic.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::dirichlet_boundary;

Matrix harmonic_move(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
{
    return harmonic_extension(mesh, held, Diffusivity::inverse_distance)->extend(displacement);
}

Mesh ring()
{
    return build_mesh(test::uneven_annulus(0.5, 3, 60));
}

/// Targets of the held vertices, n x 3 rows of the others as they are.
double landing_error(const Mesh& moved, const Mesh& start, const DirichletBoundary& held,
                     const Matrix& displacement)
{
    double error = 0;
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        error = std::max(error, (points(moved).row(held.vertices[i]).head<2>() -
                                 points(start).row(held.vertices[i]).head<2>() -
                                 displacement.row(static_cast<Index>(i)))
                                    .norm());
    return error;
}

TEST(MoveInSteps, OneStepIsTheMoveItself)
{
    const Mesh start = ring();
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    const Matrix D = boundary_displacement(start, held, test::turn(20, {0.1, 0}));
    Mesh mesh = start;
    EXPECT_EQ(move_in_steps(mesh, held, D, harmonic_move, 1), 1);
    Points wanted = points(start);
    wanted.leftCols<2>() += harmonic_move(start, held, D);
    EXPECT_LE((points(mesh) - wanted).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE(landing_error(mesh, start, held, D), 1e-15);
}

TEST(MoveInSteps, StepsTurnABodyWithoutShrinkingItOnTheWay)
{
    // Seen by the move: the radius of the inner circle before each step.
    const Mesh start = ring();
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    const Matrix D = boundary_displacement(start, held, test::turn(170, {0, 0}));
    const std::vector<bool> moving = test::is_moving(start, held);
    int calls = 0;
    const BoundaryMove watched = [&](const Mesh& mesh, const DirichletBoundary& of,
                                     const Matrix& displacement) {
        ++calls;
        for (const auto& [a, b] : of.moving_edges) {
            EXPECT_NEAR(points(mesh).row(a).norm(), 0.5, 1e-12) << calls;
            EXPECT_NEAR(points(mesh).row(b).norm(), 0.5, 1e-12) << calls;
        }
        return harmonic_move(mesh, of, displacement);
    };
    Mesh mesh = start;
    EXPECT_EQ(move_in_steps(mesh, held, D, watched, 10), 10);
    EXPECT_EQ(calls, 10);
    EXPECT_LE(landing_error(mesh, start, held, D), 1e-15);
    EXPECT_EQ(quality_report(mesh).inverted, 0);
    Mesh at_once = start;
    move_in_steps(at_once, held, D, harmonic_move, 1);
    EXPECT_GT(quality_report(at_once).inverted, 0);
}

TEST(MoveInSteps, AutomaticStepsKeepEveryElementValid)
{
    const Mesh start = ring();
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    for (const double degrees : {1.0, 60.0, 150.0}) {
        const Matrix D = boundary_displacement(start, held, test::turn(degrees, {0, 0}));
        Mesh mesh = start;
        const int steps = move_in_steps(mesh, held, D, harmonic_move, kAutoSteps);
        EXPECT_EQ(quality_report(mesh).inverted, 0) << degrees;
        EXPECT_LE(landing_error(mesh, start, held, D), 1e-15);
        EXPECT_EQ(steps > 1, degrees == 150) << steps;
        EXPECT_LT(steps, kMostAutoSteps);
    }
}

TEST(MoveInSteps, RefusesNegativeNumbersOfSteps)
{
    Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(mesh, held, test::turn(20, {0, 0}));
    EXPECT_THAT(test::message_of([&] { move_in_steps(mesh, held, D, harmonic_move, -1); }),
                ::testing::HasSubstr("at least 1 step, not -1"));
}

} // namespace
