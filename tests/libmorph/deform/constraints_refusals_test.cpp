#include "libmorph/core/error.h"
#include "libmorph/deform/constraints.h"
#include "tests/support/errors.h"
#include "tests/support/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace morph;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr Index kControlPoints = 12;

ConstraintSet body()
{
    ConstraintSet set;
    set.boundaries.push_back({"body", test::nodes_on(test::ellipse_curve(kControlPoints, 0.2), 100)});
    return set;
}

/// A node of the body as a point of its own.
ControlledPoints node(const ConstraintSet& set, Index i)
{
    const ControlledPoints& nodes = set.boundaries[0].nodes;
    return {nodes.positions.row(i), nodes.weights.middleRows(i, 1)};
}

Thickness thickness(const std::string& name, double x, Bound bound)
{
    return {name, 0, {x, 0}, {0, 1}, bound};
}

std::string refusal(const ConstraintSet& set, const Matrix& wanted = Matrix::Zero(kControlPoints, 2))
{
    return test::message_of([&] { satisfy_constraints(set, wanted); });
}

std::string failure(const ConstraintSet& set, const Matrix& wanted = Matrix::Zero(kControlPoints, 2))
{
    try {
        satisfy_constraints(set, wanted);
    } catch (const SolverError& error) {
        return error.what();
    }
    return "no SolverError was thrown";
}

TEST(ContradictingConstraints, OfFixedPointsAreNamed)
{
    ConstraintSet set = body();
    set.fixed.push_back({"nose", node(set, 50), {}});
    set.fixed.push_back({"tail", node(set, 0), {}});
    set.fixed.push_back({"nose again", node(set, 50), Matrix::Constant(1, 2, 0.1)});
    EXPECT_THAT(refusal(set), AllOf(HasSubstr("'nose'"), HasSubstr("'nose again'"),
                                    HasSubstr("contradict each other: no move of the free control points")));
    set.fixed[2].displacements.setZero(); // the same twice is no contradiction
    EXPECT_EQ(refusal(set), "nothing was thrown");
}

TEST(ContradictingConstraints, OfATieAndAPulledPointAreNamed)
{
    ConstraintSet set = body();
    set.ties.push_back({"all as one", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
    set.fixed.push_back({"nose", node(set, 50), {}});
    set.fixed.push_back({"tail", node(set, 0), Matrix::Constant(1, 2, 0.1)});
    EXPECT_THAT(refusal(set), HasSubstr("contradict each other"));
}

TEST(ContradictingConstraints, AreNamedWhenAPointCannotMove)
{
    ConstraintSet set = body();
    set.fixed.push_back({"nose", node(set, 50), Matrix::Constant(1, 2, 0.1)});
    for (Index k = 0; k < kControlPoints; ++k)
        set.held.push_back(k);
    EXPECT_EQ(refusal(set), "constraint 'nose' asks for what no move of the free control points does");
}

TEST(ContradictingConstraints, OfThicknessesAreNamedWithWhatIsReached)
{
    ConstraintSet set = body();
    set.areas.push_back({"area", 0});
    set.thicknesses.push_back(thickness("thin", 0.3, {Bound::Kind::equal, 0.1, false}));
    set.thicknesses.push_back(thickness("far", -0.4, {Bound::Kind::at_least, 0.5, true}));
    set.thicknesses.push_back(thickness("thick", 0.3, {Bound::Kind::at_least, 0.2, false}));
    EXPECT_THAT(failure(set),
                AllOf(HasSubstr("'thin'"), HasSubstr("'thick'"), HasSubstr("contradict each other"),
                      HasSubstr("'thick' is 0.15 instead of at least 0.2")));
}

TEST(ContradictingConstraints, OfAThicknessAndATieAreNamed)
{
    ConstraintSet set = body();
    set.ties.push_back({"all as one", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
    Distance spar{"spar", node(set, 25), {Bound::Kind::equal, 0.7, true}};
    spar.ends.positions.conservativeResize(2, 3);
    spar.ends.positions.row(1) = set.boundaries[0].nodes.positions.row(75);
    Matrix W(2, kControlPoints);
    W << Matrix(set.boundaries[0].nodes.weights).row(25), Matrix(set.boundaries[0].nodes.weights).row(75);
    spar.ends.weights = W.sparseView();
    set.distances.push_back(spar);
    EXPECT_THAT(failure(set),
                AllOf(HasSubstr("'spar' and 'all as one' contradict each other"), HasSubstr("instead of")));
}

TEST(ContradictingConstraints, AreNamedWhenNothingMayMove)
{
    ConstraintSet set = body();
    set.areas.push_back({"area", 0});
    for (Index k = 0; k < kControlPoints; ++k)
        set.held.push_back(k);
    EXPECT_THAT(failure(set, Matrix::Random(kControlPoints, 2) * 0.1),
                HasSubstr("constraint 'area' cannot be met"));
}

TEST(Constraints, RefuseALineThatMissesItsBoundary)
{
    ConstraintSet set = body();
    set.thicknesses.push_back(thickness("behind", 3, {}));
    EXPECT_EQ(refusal(set), "the line of constraint 'behind' does not cross its boundary");
    set.thicknesses[0] = thickness("middle", 0, {});
    Matrix away = Matrix::Zero(kControlPoints, 2);
    away.col(0).setConstant(5);
    EXPECT_THAT(failure(set, away), HasSubstr("move the boundary off the line of constraint 'middle'"));
}

TEST(Constraints, RefuseAnAreaThatIsNone)
{
    ConstraintSet set = body();
    set.boundaries[0].nodes.positions.col(1).setZero();
    set.areas.push_back({"area", 0});
    EXPECT_THAT(refusal(set), HasSubstr("'area' keeps an area, but its boundary encloses none"));
}

TEST(Constraints, RefuseWhatDoesNotExist)
{
    ConstraintSet set = body();
    set.areas.push_back({"area", 1});
    EXPECT_THAT(refusal(set), HasSubstr("'area' names boundary 1, but there are 1"));
    set = body();
    set.ties.push_back({"tie", {0, kControlPoints}});
    EXPECT_THAT(refusal(set), HasSubstr("'tie' names control point 12, but there are 12"));
    set = body();
    set.symmetries.push_back({"mirror", {{-1, 0}}, {0, 1, 0}});
    EXPECT_THAT(refusal(set), HasSubstr("'mirror' names control point -1"));
    set = body();
    set.held = {99};
    EXPECT_THAT(refusal(set), HasSubstr("held control points names control point 99"));
}

TEST(Constraints, RefuseDirectionsThatAreNone)
{
    ConstraintSet set = body();
    set.thicknesses.push_back({"t", 0, {0, 0}, {0, 0}, {}});
    EXPECT_THAT(refusal(set), HasSubstr("the line of constraint 't' has no direction"));
    set = body();
    set.symmetries.push_back({"mirror", {}, {0, 0, 1}}); // across the plane
    EXPECT_THAT(refusal(set), HasSubstr("the normal of constraint 'mirror' has no direction"));
}

TEST(Constraints, RefuseNumbersThatAreNone)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(body(), Matrix::Constant(kControlPoints, 2, none)), HasSubstr("not all finite"));
    ConstraintSet set = body();
    set.thicknesses.push_back(thickness("t", 0, {Bound::Kind::equal, none, true}));
    EXPECT_THAT(refusal(set), HasSubstr("'t' asks for a length of nan"));
    set.thicknesses[0].bound.value = -1;
    EXPECT_THAT(refusal(set), HasSubstr("'t' asks for a length of -1"));
}

TEST(Constraints, RefuseSizesThatDoNotFit)
{
    EXPECT_THAT(refusal(body(), Matrix::Zero(kControlPoints, 4)), HasSubstr("4 columns"));
    EXPECT_THAT(refusal(body(), Matrix::Zero(5, 2)), HasSubstr("and 5 control points"));
    ConstraintSet set = body();
    set.areas.push_back({"area", 0});
    EXPECT_THAT(refusal(set, Matrix::Zero(kControlPoints, 3)), HasSubstr("'area' is of the plane"));
    set = body();
    set.fixed.push_back({"nose", node(set, 50), Matrix::Zero(2, 2)});
    EXPECT_THAT(refusal(set), HasSubstr("'nose' has displacements of 2 x 2 for 1 points"));
    set = body();
    set.distances.push_back({"spar", node(set, 50), {}});
    EXPECT_THAT(refusal(set), HasSubstr("'spar' is the distance of 2 points, but has 1"));
}

} // namespace
