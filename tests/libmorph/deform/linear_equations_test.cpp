#include "libmorph/deform/linear_equations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// One solve with rows of length 1 and condition numbers under 100.
constexpr double kSolveTol = 1e-12;
constexpr double kTolerance = 1e-11;

std::vector<LinearEquation> equations_from(const Eigen::MatrixXd& A, const Eigen::VectorXd& b)
{
    std::vector<LinearEquation> equations;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        LinearEquation equation{static_cast<std::size_t>(i), {}, b[i]};
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            equation.terms.emplace_back(static_cast<Index>(k), A(i, k));
        equations.push_back(equation);
    }
    return equations;
}

TEST(SolutionSpace, HoldsEverySolutionWithTheNearestAtItsBase)
{
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(3, 8);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(3);
    const Eigen::VectorXd wanted = Eigen::VectorXd::Random(8);
    const SolutionSpace space(equations_from(A, b), wanted, kTolerance);
    EXPECT_THAT(space.clash(), IsEmpty());
    ASSERT_EQ(space.dimension(), 5);
    EXPECT_LE((A * space.at(Eigen::VectorXd::Random(5)) - b).norm(), kSolveTol);
    const Eigen::MatrixXd directions = space.restrict_rows(Eigen::MatrixXd::Identity(8, 8));
    EXPECT_LE((directions.transpose() * directions - Eigen::MatrixXd::Identity(5, 5)).norm(), kSolveTol);
    EXPECT_LE((directions.transpose() * (space.base() - wanted)).norm(), kSolveTol);
    EXPECT_LE((space.restrict_form(Eigen::MatrixXd::Identity(8, 8)) - Eigen::MatrixXd::Identity(5, 5)).norm(),
              kSolveTol);
}

TEST(SolutionSpace, IsEverythingWithoutEquations)
{
    const Eigen::VectorXd wanted = Eigen::VectorXd::Random(4);
    const SolutionSpace space({}, wanted, kTolerance);
    EXPECT_EQ(space.dimension(), 4);
    EXPECT_EQ(space.base(), wanted);
    EXPECT_EQ(space.at(Eigen::VectorXd::Unit(4, 2)), wanted + Eigen::VectorXd::Unit(4, 2));
}

TEST(SolutionSpace, AcceptsEquationsThatRepeatEachOther)
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(4, 6);
    A.row(3) = A.row(0) - 2 * A.row(1);
    const Eigen::VectorXd b = A * Eigen::VectorXd::Random(6);
    const SolutionSpace space(equations_from(A, b), Eigen::VectorXd::Zero(6), kTolerance);
    EXPECT_THAT(space.clash(), IsEmpty());
    EXPECT_EQ(space.dimension(), 3);
    EXPECT_LE((A * space.base() - b).norm(), kSolveTol);
}

TEST(SolutionSpace, DoesNotGoFarForWhatRoundingTellsApart)
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(2, 6);
    A.row(1) = A.row(0);
    A(1, 3) += 1e-13;
    Eigen::VectorXd b = A * Eigen::VectorXd::Random(6);
    b[1] += 1e-12; // within the tolerance
    const SolutionSpace space(equations_from(A, b), Eigen::VectorXd::Zero(6), kTolerance);
    EXPECT_THAT(space.clash(), IsEmpty());
    EXPECT_EQ(space.dimension(), 5);
    EXPECT_LE(space.base().norm(), 3); // no more than the point b comes from
}

TEST(SolutionSpace, NamesTheEquationsThatContradictEachOther)
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(5, 8);
    A.row(3) = 2 * A.row(1);
    Eigen::VectorXd b = A * Eigen::VectorXd::Random(8);
    b[3] += 1;
    const SolutionSpace space(equations_from(A, b), Eigen::VectorXd::Zero(8), kTolerance);
    EXPECT_THAT(space.clash(), ::testing::UnorderedElementsAre(1, 3));
}

TEST(SolutionSpace, NamesAnEquationThatNothingMoves)
{
    const std::vector<LinearEquation> equations = {{4, {{0, 1.0}}, 1.0}, {7, {}, 0.5}};
    EXPECT_THAT(SolutionSpace(equations, Eigen::VectorXd::Zero(2), kTolerance).clash(), ElementsAre(7));
    EXPECT_THAT(SolutionSpace({{7, {}, 0.5}}, Eigen::VectorXd(0), kTolerance).clash(), ElementsAre(7));
    EXPECT_THAT(SolutionSpace({{7, {}, 0.0}}, Eigen::VectorXd(0), kTolerance).clash(), IsEmpty());
}

TEST(SolutionSpace, TellsWhichEquationsKeepAFormFromChanging)
{
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(4, 8);
    const SolutionSpace space(equations_from(A, Eigen::VectorXd::Zero(4)), Eigen::VectorXd::Zero(8),
                              kTolerance);
    const Eigen::VectorXd form = (3 * A.row(2).normalized() - A.row(0).normalized()).transpose();
    EXPECT_THAT(space.sources_of(form), ElementsAre(2, 0));
}

} // namespace
