#include "libmorph/remap/inverse_distance.h"

#include "libmorph/core/parallel.h"
#include "tests/support/errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace morph;

/// Random points, the first of them known, the rest not, with random values of three columns.
struct Cloud {
    Points positions;
    std::vector<Index> known, unknown;
    Matrix values;

    explicit Cloud(Index known_count, Index unknown_count, double scale = 1)
        : positions(Points::Zero(known_count + unknown_count, 3)), values(positions.rows(), 3)
    {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (Index i = 0; i < positions.rows(); ++i) {
            positions.row(i) << scale * uniform(random), scale * uniform(random), 0;
            values.row(i) << uniform(random), -uniform(random), 1.0 / 3;
            (i < known_count ? known : unknown).push_back(i);
        }
    }

    Matrix filled(const InverseDistance& settings = {}) const
    {
        std::vector<Matrix> matrices{values};
        fill_by_inverse_distance(positions, known, unknown, settings, matrices);
        return matrices[0];
    }
};

/// Equation (4.6) of the thesis, term by term.
double by_the_equation(const Cloud& cloud, Index row, Index column, int neighbors, double power)
{
    std::vector<std::pair<double, Index>> by_distance;
    for (const Index k : cloud.known)
        by_distance.emplace_back((cloud.positions.row(k) - cloud.positions.row(row)).norm(), k);
    std::sort(by_distance.begin(), by_distance.end());
    by_distance.resize(std::min(by_distance.size(), static_cast<std::size_t>(neighbors)));
    double above = 0, below = 0;
    for (const auto& [distance, k] : by_distance) {
        above += cloud.values(k, column) * std::pow(distance, -power);
        below += std::pow(distance, -power);
    }
    return above / below;
}

TEST(InverseDistance, IsTheEquationOfTheThesis)
{
    const Cloud cloud(400, 60);
    for (const auto& [neighbors, power] : {std::pair{100, 5.0}, {7, 2.0}, {1000, 0.5}}) {
        const Matrix filled = cloud.filled({neighbors, power});
        for (const Index row : cloud.unknown)
            for (Index c = 0; c < 3; ++c)
                EXPECT_NEAR(filled(row, c), by_the_equation(cloud, row, c, neighbors, power), 1e-13);
    }
}

TEST(InverseDistance, LeavesConstantsExactKnownRowsAloneAndValuesInTheirRange)
{
    const Cloud cloud(400, 60);
    const Matrix filled = cloud.filled();
    EXPECT_EQ(filled.col(2), cloud.values.col(2));
    EXPECT_EQ(filled.topRows(400), cloud.values.topRows(400));
    EXPECT_GE(filled.col(0).minCoeff(), 0);
    EXPECT_LE(filled.col(1).maxCoeff(), 0);
}

TEST(InverseDistance, TakesTheValueOfAKnownPointAtItsPlace)
{
    Cloud cloud(400, 3);
    cloud.positions.row(400) = cloud.positions.row(17);
    cloud.positions.row(401) = cloud.positions.row(399);
    cloud.positions.row(398) = cloud.positions.row(399);
    const Matrix filled = cloud.filled();
    EXPECT_EQ(filled.row(400), cloud.values.row(17));
    EXPECT_EQ(filled.row(401), cloud.values.row(398)); // of two points in one place the lower row
}

TEST(InverseDistance, TakesTheLowestOfMorePointsInOnePlaceThanNeighbours)
{
    Cloud cloud(400, 2);
    cloud.positions.topRows(300).rowwise() = Eigen::RowVector3d(0.5, 0.5, 0);
    cloud.positions.row(400) << 0.5, 0.5, 0;
    EXPECT_EQ(cloud.filled().row(400), cloud.values.row(0));
    EXPECT_EQ(cloud.filled({1, 5}).row(400), cloud.values.row(0));
}

TEST(InverseDistance, DoesNotDependOnTheUnitOfLength)
{
    const Matrix metres = Cloud(300, 20).filled({100, 5});
    for (const double scale : {0x1p-300, 0x1p300}) // powers of two, so that the points are the same ones
        EXPECT_EQ(Cloud(300, 20, scale).filled({100, 5}), metres);
}

TEST(InverseDistance, DoesNotDependOnWhereThePointsLieAndHowTheyAreTurned)
{
    Cloud cloud(300, 50);
    const Matrix here = cloud.filled();
    // Moving rounds positions by some 1e-16; distances are 1e-3 or more and enter with the power 5.
    constexpr double kRoundOff = 1e-12;
    const Points positions = cloud.positions;
    cloud.positions.rowwise() += Eigen::RowVector3d(-3, 0.7, 0);
    EXPECT_LE((cloud.filled() - here).norm(), kRoundOff * here.norm());
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
    cloud.positions = positions * turn.transpose(); // out of the plane: the tree is one of space now
    EXPECT_LE((cloud.filled() - here).norm(), kRoundOff * here.norm());
}

TEST(InverseDistance, WithOneNeighbourIsTheNearestValue)
{
    const Cloud cloud(100, 10);
    const Matrix filled = cloud.filled({1, 5});
    for (const Index row : cloud.unknown)
        EXPECT_DOUBLE_EQ(filled(row, 0), by_the_equation(cloud, row, 0, 1, 1));
}

TEST(InverseDistance, GivesTheSameBytesForAnyThreadCount)
{
    const Cloud cloud(2000, 3000);
    set_thread_count(1);
    const Matrix one = cloud.filled();
    set_thread_count(4);
    EXPECT_EQ(cloud.filled(), one);
    set_thread_count(0);
}

TEST(InverseDistance, RefusesSettingsWithoutMeaning)
{
    Cloud cloud(10, 2);
    EXPECT_EQ(test::message_of([&] {
                  cloud.filled({0, 5});
              }),
              "inverse distance weighting needs at least 1 neighbour, not 0");
    EXPECT_EQ(test::message_of([&] {
                  cloud.filled({100, -1});
              }),
              "the power of inverse distance weighting is -1.000000, but a positive number was expected");
}

TEST(InverseDistance, RefusesRowsAndValuesThatDoNotFit)
{
    Cloud cloud(10, 2);
    cloud.unknown.push_back(12);
    EXPECT_EQ(test::message_of([&] { cloud.filled(); }),
              "row 12 of the values is asked for, but there are 12 points");
    cloud.unknown.pop_back();
    cloud.values.conservativeResize(11, 3);
    EXPECT_EQ(test::message_of([&] { cloud.filled(); }), "there are values for 11 points, but 12 points");
    cloud.known.clear();
    EXPECT_EQ(test::message_of([&] { cloud.filled(); }), "no value is known to weight by inverse distance");
}

} // namespace
