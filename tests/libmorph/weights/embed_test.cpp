#include "libmorph/weights/embed.h"

#include "libmorph/core/parallel.h"
#include "tests/support/lattices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace morph;
using test::all_kinds_of_lattices;
using test::kind;

// What the issue promises, relative to the size of the lattice.
constexpr double kFound = 1e-14;

// The coordinates of the lattices of the tests are up to 22, their size 2.7: rounding of the points
// themselves, which S is measured without, because it is summed from a near origin.
constexpr double kRoundOff = 2e-14;

/// The largest distance from S(parameters) to the points inside.
double farthest(const Lattice& lattice, const Embedding& embedding, const Points& points)
{
    const Eigen::RowVector3d origin = lattice.definition().control_points.row(0);
    const Lattice near = lattice.with_control_points(lattice.definition().control_points.rowwise() - origin);
    double farthest = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (embedding.inside[static_cast<std::size_t>(i)] != 0)
            farthest = std::max(farthest, (near.point(embedding.parameters.row(i).transpose()).transpose() -
                                           (points.row(i) - origin))
                                              .norm());
    return farthest;
}

TEST(Embed, FindsEveryPointOfADeformedLattice)
{
    for (const Lattice& lattice : all_kinds_of_lattices()) {
        const test::Embedded exact = test::random_embedded(lattice, 2000);
        const Embedding found = embed(lattice, exact.positions);
        EXPECT_EQ(found.inside_count, 2000) << kind(lattice);
        EXPECT_LE(farthest(lattice, found, exact.positions), kFound * lattice.size() + kRoundOff)
            << kind(lattice);
        // The Jacobians of these lattices stretch by no less than 1/20.
        EXPECT_LE((found.parameters - exact.parameters).cwiseAbs().maxCoeff(), 1e-12) << kind(lattice);
    }
}

TEST(Embed, IsExactInABox)
{
    const Lattice box = lattice_in_box({-0.3, -0.4, 0}, {1.3, 0.4, 0}, {.dimension = 2, .points = {7, 5, 1}});
    Points points = 0.6 * Points::Random(1000, 3);
    points.col(2).setZero();
    const Embedding found = embed(box, points);
    for (Eigen::Index i = 0; i < 1000; ++i) {
        const double x = points(i, 0);
        const double y = points(i, 1);
        const bool inside = x >= -0.3 && x <= 1.3 && y >= -0.4 && y <= 0.4;
        ASSERT_EQ(found.inside[static_cast<std::size_t>(i)], inside ? 1 : 0);
        const Eigen::RowVector3d u((x + 0.3) / 1.6, (y + 0.4) / 0.8, 0);
        EXPECT_LE((found.parameters.row(i) - (inside ? u : u.Zero())).norm(), kFound);
    }
}

} // namespace
