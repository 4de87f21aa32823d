#include "libmorph/pipeline/comparison.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/pipeline/deformer.h"
#include "tests/support/domains.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::HasSubstr;

/// A ring 1 < r < 3 whose inner circle follows a curve of 8 control points.
class RingComparison : public ::testing::Test {
protected:
    MotionSettings motion(double dx) const
    {
        const Curve circle = test::round_curve(0, 0, 1);
        MotionSettings settings;
        settings.curves = {{.marker = "inner", .curve = circle.definition()}};
        Points2& D = settings.curves[0].displacements;
        D = Points2::Zero(circle.definition().control_points.rows(), 2);
        D.col(0).setConstant(dx);
        return settings;
    }

    ComparisonRow row(const std::string& method, double dx = 0.1) const
    {
        const MotionSettings settings = motion(dx);
        return compare(mesh_, parametrize_boundaries(mesh_, settings), settings, compared_method(method));
    }

    Mesh mesh_ = build_mesh(test::annulus(1, 3, 48, 12));
};

TEST_F(RingComparison, MeasuresWhatDeformerMoves)
{
    const ComparisonRow found = row("harmonic-distance");
    MotionSettings settings = motion(0.1);
    settings.deform.diffusivity = Diffusivity::inverse_distance;
    const Deformer deformer(mesh_, settings);
    const MoveResult moved = deformer.move();
    EXPECT_EQ(found.method, "harmonic-distance");
    EXPECT_EQ(found.moved.positions, moved.positions);
    EXPECT_EQ(found.quality.min_scaled_jacobian, moved.after->min_scaled_jacobian);
    EXPECT_EQ(found.moved.control_variables, 2 * static_cast<Index>(deformer.control_points().size()));
    EXPECT_EQ(found.moved.weights_bytes, deformer.weights_bytes());
    EXPECT_LT(found.boundary_error, 1e-12); // harmonic weights make the curve exactly
    EXPECT_LE(found.rms_boundary_error, found.boundary_error);
    const auto quality = element_quality(mesh_, moved.positions);
    EXPECT_EQ(quality[static_cast<std::size_t>(found.worst_element)].scaled_jacobian,
              found.quality.min_scaled_jacobian);
}

TEST_F(RingComparison, HasAnEnergyThatIsQuadraticInTheMoveAndLeastForLaplacesEquation)
{
    const double one = row("harmonic", 0.1).energy;
    EXPECT_NEAR(row("harmonic", 0.05).energy, one / 4, 1e-12 * one);
    EXPECT_NEAR(row("harmonic", 0.2).energy, 4 * one, 1e-12 * one);
    for (const ComparedMethod& method : compared_methods()) {
        if (method.uses_lattice) // whose fit leaves the boundary elsewhere
            continue;
        EXPECT_GE(row(method.name).energy, one * (1 - 1e-12)) << method.name;
    }
}

TEST_F(RingComparison, MakesASmallMoveByEveryMethod)
{
    for (const ComparedMethod& method : compared_methods()) {
        const ComparisonRow found = row(method.name);
        EXPECT_EQ(found.quality.inverted, 0) << method.name;
        EXPECT_LT(found.boundary_error, method.uses_lattice ? 0.05 : 1e-9) << method.name;
        EXPECT_GT(found.moved.control_variables, 0) << method.name;
        EXPECT_EQ(method.uses_lattice, method.name.starts_with("ffd")) << method.name;
    }
}

TEST_F(RingComparison, RepairsWhatAMethodLeavesInverted)
{
    const ComparisonRow tangled = row("harmonic", 1.3);
    const ComparisonRow repaired = row("harmonic+untangle", 1.3);
    ASSERT_GT(tangled.quality.inverted, 0);
    EXPECT_EQ(repaired.method, "harmonic+untangle");
    EXPECT_EQ(repaired.quality.inverted, 0);
    EXPECT_EQ(repaired.boundary_error, tangled.boundary_error); // the boundary is held
    EXPECT_GE(repaired.moved.move_seconds, 0);
}

TEST_F(RingComparison, NeedsACurveToMeasureHowWellItIsFollowed)
{
    const MotionSettings none;
    const PlacedBoundaries nothing = parametrize_boundaries(mesh_, none);
    EXPECT_THAT(test::message_of([&] { compare(mesh_, nothing, none, compared_method("ffd")); }),
                HasSubstr("there is no [[boundary]]"));
}

TEST(ComparedMethods, NameTheNearestToOneThatIsNotKnown)
{
    EXPECT_THAT(test::message_of([] { compared_method("harmonics"); }),
                ::testing::AllOf(HasSubstr("method 'harmonics' is not known; known are harmonic, "),
                                 HasSubstr("did you mean 'harmonic'?")));
}

} // namespace
