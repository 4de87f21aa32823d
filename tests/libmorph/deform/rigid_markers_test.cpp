#include "libmorph/deform/rigid_markers.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::dirichlet_boundary;

Mesh ring()
{
    return build_mesh(test::uneven_annulus(0.5, 3, 120));
}

TEST(RigidMarkers, ARigidMoveIsLeftAsItIs)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    for (const double degrees : {0.0, 30.0, 150.0, -90.0}) {
        const Matrix D = boundary_displacement(mesh, held, test::turn(degrees, {0.3, 0.1}));
        EXPECT_LE((with_rigid_markers(mesh, held, D, {"inner"}) - D).cwiseAbs().maxCoeff(), 1e-14) << degrees;
    }
}

TEST(RigidMarkers, NoOtherRigidMotionFitsTheDisplacementBetter)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(mesh, held, [](double x, double y) {
        return Eigen::RowVector2d(0.2 * x - 0.7 * y + 0.1 * y * y, 0.6 * x + 0.3 * std::sin(4 * y));
    });
    const Matrix rigid = with_rigid_markers(mesh, held, D, {"inner"});
    const double best = (rigid - D).squaredNorm();
    EXPECT_GT(best, 0.1);
    for (const double turn : {-1e-3, 1e-3})
        for (const double shift : {-1e-3, 0.0, 1e-3}) {
            Matrix other = rigid;
            for (std::size_t i = 0; i < held.vertices.size(); ++i) {
                const auto row = static_cast<Index>(i);
                const Eigen::RowVector2d x = points(mesh).row(held.vertices[i]).head<2>() + rigid.row(row);
                if (points(mesh).row(held.vertices[i]).norm() < 1)
                    other.row(row) += Eigen::RowVector2d(shift - turn * x.y(), turn * x.x());
            }
            EXPECT_GT((other - D).squaredNorm(), best);
        }
}

TEST(RigidMarkers, DistancesOnTheMarkerStayAndOtherMarkersAreLeftAlone)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(
        mesh, held, [](double x, double y) { return Eigen::RowVector2d(0.3 * x + y, -0.3 * y); });
    const Matrix rigid = with_rigid_markers(mesh, held, D, {"inner"});
    std::vector<Index> inner;
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        if (points(mesh).row(held.vertices[i]).norm() < 1)
            inner.push_back(static_cast<Index>(i));
        else
            EXPECT_EQ(rigid.row(static_cast<Index>(i)), D.row(static_cast<Index>(i)));
    for (std::size_t i = 1; i < inner.size(); ++i) {
        const Eigen::RowVector2d before =
            points(mesh).row(held.vertices[static_cast<std::size_t>(inner[i])]).head<2>() -
            points(mesh).row(held.vertices[static_cast<std::size_t>(inner[0])]).head<2>();
        const Eigen::RowVector2d after = before + rigid.row(inner[i]) - rigid.row(inner[0]);
        EXPECT_NEAR(after.norm(), before.norm(), 1e-14);
    }
}

TEST(RigidMarkers, AMarkerThatIsNotHeldIsRefused)
{
    const Mesh mesh = ring();
    DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    EXPECT_THAT(test::message_of([&] {
                    with_rigid_markers(mesh, held, Matrix::Zero(std::ssize(held.vertices), 2), {"iner"});
                }),
                testing::HasSubstr("'inner'"));
    held.vertices.pop_back();
    const Matrix none = Matrix::Zero(std::ssize(held.vertices), 2);
    const auto either = [&](const std::string& name) {
        return test::message_of([&] { with_rigid_markers(mesh, held, none, {name}); });
    };
    EXPECT_THAT(either("inner") + either("outer"), testing::HasSubstr("is neither moved nor fixed"));
}

} // namespace
