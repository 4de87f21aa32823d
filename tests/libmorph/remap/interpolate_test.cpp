#include "libmorph/remap/interpolate.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace {

using namespace morph;

/// A field with one component for each function, taken at the vertices.
template <typename... Function>
Field nodal_field(const Mesh& mesh, const Function&... function)
{
    Field field{"f", FieldLocation::vertex, Matrix(vertex_count(mesh), sizeof...(function))};
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const std::array<double, sizeof...(Function)> row{
            function(points(mesh)(v, 0), points(mesh)(v, 1))...};
        std::copy(row.begin(), row.end(), field.values.row(v).data());
    }
    return field;
}

Matrix carried(const Mesh& source, const Field& field, const Points& targets,
               QuadRule rule = QuadRule::bilinear)
{
    const std::vector<const Field*> fields{&field};
    return interpolate(source, Locator(source).locate(targets), targets, fields, rule)[0];
}

/// The targets that some element holds.
std::vector<Index> inside(const Mesh& source, const Points& targets)
{
    const std::vector<Index> face = Locator(source).locate(targets).face;
    std::vector<Index> found;
    for (Index i = 0; i < targets.rows(); ++i)
        if (face[static_cast<std::size_t>(i)] >= 0)
            found.push_back(i);
    return found;
}

TEST(Interpolate, ReproducesLinearFunctionsOnRandomMeshesToRounding)
{
    constexpr double kExact = 1e-13; // of the function's range, which is about 1
    const auto linear = [](double x, double y) { return 0.3 + 0.5 * x - 0.7 * y; };
    std::mt19937 random(11);
    for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
        const MeshData data = test::random_mesh(test::some_settings(seed));
        const Mesh mesh = build_mesh(data);
        const Points targets = test::random_targets(data, 12, random);
        for (const QuadRule rule : {QuadRule::bilinear, QuadRule::split}) {
            const Matrix values = carried(mesh, nodal_field(mesh, linear), targets, rule);
            for (const Index i : inside(mesh, targets)) {
                EXPECT_NEAR(values(i, 0), linear(targets(i, 0), targets(i, 1)), kExact) << "seed " << seed;
            }
        }
    }
}

TEST(Interpolate, ReproducesBilinearFunctionsInRectangles)
{
    MeshData data = test::quad_square(4);
    for (Index v = 0; v < data.points.rows(); ++v) // an even grid: only there x y is in the quads' space
        data.points.row(v) << 0.25 * (v % 5), 0.25 * (v / 5), 0;
    const Mesh mesh = build_mesh(data);
    const auto bilinear = [](double x, double y) { return 1 + x - 2 * y + 3 * x * y; };
    std::mt19937 random(3);
    const Points targets = test::random_targets(data, 200, random);
    const Matrix values = carried(mesh, nodal_field(mesh, bilinear), targets);
    const Matrix split = carried(mesh, nodal_field(mesh, bilinear), targets, QuadRule::split);
    double worst_split = 0;
    for (const Index i : inside(mesh, targets)) {
        const double exact = bilinear(targets(i, 0), targets(i, 1));
        EXPECT_NEAR(values(i, 0), exact, 1e-13);
        worst_split = std::max(worst_split, std::abs(split(i, 0) - exact));
    }
    EXPECT_GT(worst_split, 1e-3); // the two triangles do not
}

TEST(Interpolate, OntoTheMeshItselfGivesEveryBitBack)
{
    for (const MeshData& data : {test::uneven_square(20), test::quad_square(20), test::touching_squares(5)}) {
        const Mesh mesh = build_mesh(data);
        std::mt19937_64 random(9);
        Field field{"f", FieldLocation::vertex, Matrix(vertex_count(mesh), 9)};
        for (Index v = 0; v < vertex_count(mesh); ++v)
            for (Index c = 0; c < 9; ++c)
                field.values(v, c) = c == 0 ? -0.0
                                            : std::ldexp(static_cast<double>(random()),
                                                         static_cast<int>(random() % 1900) - 1000);
        for (Index v = 0; v < vertex_count(mesh); ++v) // copies of a split vertex have one value
            for (Index w = 0; w < v; ++w)
                if (points(mesh).row(v) == points(mesh).row(w))
                    field.values.row(v) = field.values.row(w);
        const Matrix values = carried(mesh, field, points(mesh));
        EXPECT_EQ(std::memcmp(values.data(), field.values.data(),
                              sizeof(double) * static_cast<std::size_t>(values.size())),
                  0);
    }
}

TEST(Interpolate, LeavesConstantsAsTheyAreAndValuesInTheirRange)
{
    std::mt19937 random(2);
    for (std::uint32_t seed = 1; seed <= 500; ++seed) {
        const MeshData data = test::random_mesh(test::some_settings(seed));
        const Mesh mesh = build_mesh(data);
        const Points targets = test::random_targets(data, 20, random);
        const Matrix values = carried(mesh,
                                      nodal_field(
                                          mesh, [](double, double) { return 1.0 / 3; },
                                          [&](double, double) { return static_cast<double>(random() % 2); }),
                                      targets);
        for (const Index i : inside(mesh, targets)) {
            EXPECT_EQ(values(i, 0), 1.0 / 3);
            EXPECT_GE(values(i, 1), 0);
            EXPECT_LE(values(i, 1), 1);
        }
    }
}

TEST(Interpolate, ConvergesAtSecondOrderForSmoothFunctions)
{
    const auto smooth = [](double x, double y) { return std::sin(3 * x) * std::exp(y) + x * x * y; };
    std::mt19937 random(1);
    const Points targets = test::random_targets(test::uneven_square(3), 4000, random);
    for (const bool quads : {false, true}) {
        std::vector<double> errors;
        for (const Index cells : {16, 32, 64, 128}) {
            const Mesh mesh = build_mesh(quads ? test::quad_square(cells) : test::uneven_square(cells));
            const ContainingElements found = Locator(mesh).locate(targets);
            const Matrix values = carried(mesh, nodal_field(mesh, smooth), targets);
            double worst = 0;
            for (Index i = 0; i < targets.rows(); ++i)
                if (found.face[static_cast<std::size_t>(i)] >= 0)
                    worst = std::max(worst, std::abs(values(i, 0) - smooth(targets(i, 0), targets(i, 1))));
            errors.push_back(worst);
        }
        const double order = std::log2(errors.front() / errors.back()) / 3;
        EXPECT_GT(order, 1.85) << "quads: " << quads; // largest errors jump about a little between meshes
        EXPECT_LT(order, 2.3) << "quads: " << quads;
    }
}

TEST(Interpolate, GivesElementFieldsTheValueOfTheElement)
{
    const Mesh mesh = build_mesh(test::quad_square(6));
    Field field{"cell", FieldLocation::element, Matrix(element_count(mesh), 2)};
    for (Index f = 0; f < element_count(mesh); ++f)
        field.values.row(f) << f, -f;
    Points centres(element_count(mesh), 3);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        centres.row(f) = (points(mesh).row(e[0]) + points(mesh).row(e[1]) + points(mesh).row(e[2]) +
                          points(mesh).row(e[3])) /
                         4;
    }
    EXPECT_EQ(carried(mesh, field, centres), field.values);
}

TEST(Interpolate, GivesTheSameBytesForAnyThreadCount)
{
    const MeshData data = test::annulus(1, 3, 90, 20);
    const Mesh mesh = build_mesh(data);
    std::mt19937 random(3);
    const Points targets = test::random_targets(data, 20000, random);
    const Field field = nodal_field(mesh, [](double x, double y) { return std::sin(x * y); });
    set_thread_count(1);
    const Matrix one = carried(mesh, field, targets);
    set_thread_count(7);
    const Matrix seven = carried(mesh, field, targets);
    set_thread_count(0);
    EXPECT_EQ(one, seven);
}

} // namespace
