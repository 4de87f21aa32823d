#include "libmorph/remesh/chord_size.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/domains.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morph {
namespace {

constexpr double kError = 0.01;

/// A closed grid of rows x columns vertices, each at place(i / rows, j / columns), triangles outwards.
template <typename Place>
MeshData wrapped(Index rows, Index columns, const Place& place)
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(Eigen::Index{rows} * columns, 3);
    const auto number = [&](Index i, Index j) { return i % rows * columns + j % columns; };
    for (Index i = 0; i < rows; ++i)
        for (Index j = 0; j < columns; ++j) {
            data.points.row(number(i, j)) = place(double(i) / rows, double(j) / columns);
            data.elements.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), -1});
            data.elements.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1), -1});
        }
    return data;
}

TEST(ChordSize, IsThatOfTheTubeAllOverATorus)
{
    constexpr double kTube = 1, kRing = 3, kTurn = 2 * std::numbers::pi;
    const Mesh mesh = build_mesh(wrapped(90, 40, [](double s, double t) {
        const double out = kRing + kTube * std::cos(kTurn * t);
        return Eigen::RowVector3d(out * std::cos(kTurn * s), out * std::sin(kTurn * s),
                                  kTube * std::sin(kTurn * t));
    }));
    const Eigen::VectorXd sizes = chord_sizes(mesh, {}, kError);
    // The tube's curvature is the larger everywhere; 40 sides find it to second order: (9 degrees)^2.
    for (Index v = 0; v < vertex_count(mesh); ++v)
        EXPECT_NEAR(sizes[v], std::sqrt(8 * kError * kTube), 0.025 * sizes[v]);
}

TEST(ChordSize, IsThatOfBothCirclesOfARingAndNoneInside)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 60, 10));
    const Eigen::VectorXd sizes = chord_sizes(mesh, {}, kError);
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double radius = points(mesh).row(v).norm();
        if (mesh.kernel.is_boundary(VertexHandle(v)))
            EXPECT_NEAR(sizes[v], std::sqrt(8 * kError * radius), 1e-3 * sizes[v]); // (6 degrees)^2 / 24
        else
            EXPECT_TRUE(std::isinf(sizes[v]));
    }
}

TEST(ChordSize, TakesCreasesForEdgesAndNotForCurvature)
{
    const Mesh mesh = build_mesh(test::uneven_square(5));
    EXPECT_TRUE(std::isinf(chord_sizes(mesh, {}, kError).minCoeff()));
    MeshData box;
    box.dimension = 3;
    box.points.resize(8, 3);
    for (Index i = 0; i < 8; ++i)
        box.points.row(i) << (i & 4) / 4.0, (i & 2) / 2.0, i & 1;
    for (const Element& q : {Element{0, 1, 3, 2}, Element{4, 6, 7, 5}, Element{0, 4, 5, 1},
                             Element{2, 3, 7, 6}, Element{0, 2, 6, 4}, Element{1, 5, 7, 3}}) {
        box.elements.push_back({q[0], q[1], q[2], -1});
        box.elements.push_back({q[0], q[2], q[3], -1});
    }
    // Rounding of unit normals: curvatures of some 1e-16.
    EXPECT_GT(chord_sizes(build_mesh(box), {}, kError).minCoeff(), 1e6);
}

TEST(ChordSize, NamesTheMarkerNearestToAMissingOneWithACurve)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 20, 4));
    FeatureSettings features;
    features.curves.push_back({"iner", test::round_curve(0, 0, 1)});
    EXPECT_NE(test::message_of([&] { chord_sizes(mesh, features, kError); }).find("did you mean 'inner'"),
              std::string::npos);
}

} // namespace
} // namespace morph
