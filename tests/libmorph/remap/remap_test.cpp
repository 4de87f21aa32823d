#include "libmorph/remap/remap.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

namespace {

using namespace morph;
using test::message_of;

Mesh points_mesh(const Points& points)
{
    MeshData data;
    data.points = points;
    data.dimension = points.col(2).isZero(0) ? 2 : 3;
    return build_mesh(data);
}

Mesh points_mesh(std::initializer_list<std::array<double, 3>> list)
{
    Points points(static_cast<Index>(list.size()), 3);
    Index row = 0;
    for (const auto& [x, y, z] : list)
        points.row(row++) << x, y, z;
    return points_mesh(points);
}

template <typename Function>
Field nodal(const Mesh& mesh, const Function& function, const std::string& name = "f")
{
    Field field{name, FieldLocation::vertex, Matrix(vertex_count(mesh), 1)};
    for (Index v = 0; v < vertex_count(mesh); ++v)
        field.values(v, 0) = function(points(mesh)(v, 0), points(mesh)(v, 1));
    return field;
}

double linear(double x, double y)
{
    return 2 + x - 3 * y;
}

/// The field on the target in the order of its file.
Matrix carried(const Mesh& source, const Field& field, const Mesh& target, const RemapSettings& settings = {})
{
    const Locator locator(source);
    const std::vector<const Field*> fields{&field};
    Mesh result = target;
    result.fields = Remapper(locator, target, settings).transfer(fields);
    return to_mesh_data(result).fields[0].values;
}

TEST(Remapper, InterpolatesInsideAndWeighsTargetsInsideByInverseDistanceOutside)
{
    const Mesh source = build_mesh(test::uneven_square(6));
    const Mesh target = points_mesh({{0.25, 0.5, 0}, {0.75, 0.5, 0}, {1.25, 0.5, 0}});
    const Matrix values = carried(source, nodal(source, linear), target);
    EXPECT_NEAR(values(0, 0), linear(0.25, 0.5), 1e-14);
    EXPECT_NEAR(values(1, 0), linear(0.75, 0.5), 1e-14);
    const double near = std::pow(0.5, -5), far = std::pow(1.0, -5);
    EXPECT_NEAR(values(2, 0), (near * values(1, 0) + far * values(0, 0)) / (near + far), 1e-14);
    RemapSettings one;
    one.inverse_distance = {1, 5};
    EXPECT_EQ(carried(source, nodal(source, linear), target, one)(2, 0), values(1, 0));
}

TEST(Remapper, TakesTheNearestVertexOrTheClosestPointWhenAskedTo)
{
    const Mesh source = build_mesh(test::uneven_square(4));
    const Mesh target = points_mesh({{0.5, 0.5, 0}, {1.5, 0.6, 0}, {-1, -1, 0}});
    RemapSettings settings;
    settings.outside = Outside::nearest;
    const Matrix nearest = carried(source, nodal(source, linear), target, settings);
    EXPECT_DOUBLE_EQ(nearest(1, 0), linear(1, 0.5));
    EXPECT_DOUBLE_EQ(nearest(2, 0), linear(0, 0));
    settings.outside = Outside::project;
    const Matrix closest = carried(source, nodal(source, linear), target, settings);
    EXPECT_NEAR(closest(1, 0), linear(1, 0.6), 1e-14);
    EXPECT_DOUBLE_EQ(closest(2, 0), linear(0, 0));
}

TEST(Remapper, NearestLooksPastVerticesOfNoElement)
{
    MeshData data = test::uneven_square(4);
    data.points.conservativeResize(data.points.rows() + 1, Eigen::NoChange);
    data.points.bottomRows(1) << 1.5, 0.6, 0;
    const Mesh source = build_mesh(data);
    RemapSettings settings;
    settings.outside = Outside::nearest;
    const Mesh target = points_mesh({{0.5, 0.5, 0}, {1.5, 0.6, 0}});
    EXPECT_DOUBLE_EQ(carried(source, nodal(source, linear), target, settings)(1, 0), linear(1, 0.5));
}

TEST(Remapper, OfElementFieldsTakesTheElementAtTheCentre)
{
    const Mesh source = build_mesh(test::quad_square(3));
    Field field{"cell", FieldLocation::element, Matrix(element_count(source), 1)};
    for (Index f = 0; f < element_count(source); ++f)
        field.values(f, 0) = source.numbering.element[static_cast<std::size_t>(f)];
    const Mesh halves = build_mesh([] { // each of the quads as two triangles
        MeshData data = test::uneven_square(3);
        return data;
    }());
    const Matrix values = carried(source, field, halves);
    for (Index e = 0; e < values.rows(); ++e)
        EXPECT_EQ(values(e, 0), e / 2);
}

TEST(Remapper, GivesPointsTheValueOfTheElementTheyLieIn)
{
    const Mesh source = build_mesh(test::quad_square(1));
    const Field field{"cell", FieldLocation::element, Matrix::Constant(1, 1, 7)};
    const Locator locator(source);
    const Mesh target = points_mesh({{0.5, 0.5, 0}, {3, 0, 0}});
    const std::vector<const Field*> fields{&field};
    for (const Outside rule : {Outside::idw, Outside::nearest, Outside::project}) {
        RemapSettings settings;
        settings.outside = rule;
        const std::vector<Field> result = Remapper(locator, target, settings).transfer(fields);
        EXPECT_EQ(result[0].location, FieldLocation::vertex);
        EXPECT_EQ(result[0].values, Matrix::Constant(2, 1, 7));
    }
}

TEST(Remapper, KeepsEveryBitOnTheSameMesh)
{
    for (const std::string& path : {std::string("quads"), std::string("triangles")}) {
        Mesh mesh = build_mesh(path == "quads" ? test::quad_square(9) : test::uneven_square(9));
        std::mt19937_64 random(1);
        Field field{"f", FieldLocation::vertex, Matrix(vertex_count(mesh), 4)};
        for (Index i = 0; i < field.values.size(); ++i)
            field.values.data()[i] = std::ldexp(static_cast<double>(random()), -64) - 0.5;
        const Locator locator(mesh);
        const std::vector<const Field*> fields{&field};
        const Field result = Remapper(locator, mesh).transfer(fields)[0];
        EXPECT_EQ(std::memcmp(result.values.data(), field.values.data(),
                              sizeof(double) * static_cast<std::size_t>(field.values.size())),
                  0);
    }
}

TEST(Remapper, GivesTheSameBytesForAnyThreadCount)
{
    const Mesh source = build_mesh(test::annulus(1, 2, 60, 12));
    const Mesh target = build_mesh(test::annulus(0.9, 2.1, 77, 15));
    const Field field = nodal(source, [](double x, double y) { return std::sin(3 * x) * y; });
    for (const bool conserve : {false, true}) {
        RemapSettings settings;
        settings.conserve_nodal = conserve;
        set_thread_count(1);
        const Matrix one = carried(source, field, target, settings);
        set_thread_count(4);
        EXPECT_EQ(carried(source, field, target, settings), one);
        set_thread_count(0);
    }
}

TEST(Remapper, FillsWhatNothingCoversAsWithoutKeepingIntegrals)
{
    const Mesh source = build_mesh(test::uneven_square(8));
    MeshData shifted = test::quad_square(8);
    shifted.points.col(0).array() += 0.5; // half of it lies beyond the source
    const Mesh target = build_mesh(shifted);
    const Field field = nodal(source, linear);
    RemapSettings settings;
    settings.outside = Outside::project;
    const Matrix interpolated = carried(source, field, target, settings);
    settings.conserve_nodal = true;
    const Matrix conserved = carried(source, field, target, settings);
    for (Index v = 0; v < conserved.rows(); ++v) {
        const double x = shifted.points(v, 0), y = shifted.points(v, 1);
        if (x > 1.3) {
            EXPECT_EQ(conserved(v, 0), interpolated(v, 0));
        } else if (x < 1.05) {
            EXPECT_NEAR(conserved(v, 0), linear(x, y), 1e-9); // ill-conditioned where little is covered
        }
    }
}

// A sphere as a surface: the poles are fans of triangles, the rest quads.
Mesh sphere(Index around, Index rings)
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(around * (rings - 1) + 2, 3);
    const auto at = [&](Index ring, Index i) { return (ring - 1) * around + i % around; };
    for (Index ring = 1; ring < rings; ++ring)
        for (Index i = 0; i < around; ++i) {
            const double theta = std::numbers::pi * ring / rings, phi = 2 * std::numbers::pi * i / around;
            data.points.row(at(ring, i)) << std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                std::cos(theta);
        }
    const auto pole = static_cast<Index>(data.points.rows()) - 2;
    data.points.row(pole) << 0, 0, 1;
    data.points.row(pole + 1) << 0, 0, -1;
    for (Index i = 0; i < around; ++i) {
        data.elements.push_back({pole, at(1, i), at(1, i + 1), -1});
        data.elements.push_back({pole + 1, at(rings - 1, i + 1), at(rings - 1, i), -1});
        for (Index ring = 1; ring + 1 < rings; ++ring)
            data.elements.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
    return build_mesh(data);
}

Field height(const Mesh& mesh)
{
    return {"z", FieldLocation::vertex, points(mesh).col(2)};
}

TEST(Remapper, ProjectsOnSurfacesAtSecondOrderAndTellsTheDistance)
{
    const Mesh target = sphere(90, 45);
    std::vector<double> errors;
    for (const Index rings : {10, 20, 40}) {
        const Mesh source = sphere(2 * rings, rings);
        const Locator locator(source);
        const Field field = height(source);
        const std::vector<const Field*> fields{&field};
        Remapper remapper(locator, target);
        const Matrix values = remapper.transfer(fields)[0].values;
        errors.push_back((values - points(target).col(2)).cwiseAbs().maxCoeff());
        const TargetLocations& targets = remapper.locations(FieldLocation::vertex);
        EXPECT_TRUE(targets.outside.empty());
        const double sagitta = 1 - std::cos(std::numbers::pi / rings / 2);
        const double farthest = *std::max_element(targets.distance.begin(), targets.distance.end());
        EXPECT_GT(farthest, sagitta / 2);
        EXPECT_LT(farthest, 2.5 * sagitta); // of quads: the sagitta of their diagonal
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[2]) / 2, 2, 0.3);
}

TEST(Remapper, OnAnOpenSurfaceCountsWhatLiesBeyondTheRimAsOutside)
{
    MeshData data = test::uneven_square(4);
    data.dimension = 3;
    for (Index v = 0; v < data.points.rows(); ++v)
        data.points(v, 2) = data.points(v, 0);
    const Mesh source = build_mesh(data);
    const Locator locator(source);
    const Mesh target = points_mesh({{0.5, 0.5, 0.6}, {1.5, 0.5, 1.5}, {1, 0.5, 1}});
    Remapper remapper(locator, target);
    const Field field = nodal(source, linear);
    const std::vector<const Field*> fields{&field};
    Mesh result = target;
    result.fields = remapper.transfer(fields);
    const Matrix values = to_mesh_data(result).fields[0].values;
    EXPECT_NEAR(values(0, 0), linear(0.55, 0.5), 1e-14);
    EXPECT_NEAR(values(1, 0), linear(1, 0.5), 1e-14);
    ASSERT_EQ(remapper.locations(FieldLocation::vertex).outside.size(), 1U);
    EXPECT_NEAR(remapper.locations(FieldLocation::vertex).outside_feet[0].distance, std::sqrt(0.5), 1e-14);
}

TEST(Remapper, SaysWhatCannotBeCarried)
{
    const Mesh source = build_mesh(test::uneven_square(2));
    Field field = nodal(source, linear, "p");
    const auto transfer = [&](const Mesh& target, const RemapSettings& settings = {}) {
        return message_of([&] { carried(source, field, target, settings); });
    };
    EXPECT_EQ(
        transfer(points_mesh({{2, 0, 0}, {3, 4, 0}})),
        "none of the 2 targets lies in the source: they span (2, 0) to (3, 4), the source (0, 0) to (1, 1)");
    RemapSettings fail;
    fail.outside = Outside::fail;
    EXPECT_EQ(transfer(points_mesh({{0.5, 0.5, 0}, {1.25, 0.5, 0}, {1.5, 0.5, 0}}), fail),
              "2 of 3 targets lie outside the source, the farthest at (1.5, 0.5) by 0.5");
    EXPECT_EQ(transfer(points_mesh({{0.5, 0.5, 0}}), fail), "nothing was thrown");
    EXPECT_EQ(transfer(points_mesh({{0.5, 0.5, 1}})),
              "the source is planar, but the target lies in space: some of its z are not 0");
    RemapSettings conserve;
    conserve.conserve_nodal = true;
    EXPECT_EQ(transfer(points_mesh({})), "the target has no point to take values to");
    EXPECT_EQ(transfer(points_mesh({{0.5, 0.5, 0}}), conserve),
              "integrals are kept between meshes, but the target has no elements");
    MeshData away = test::uneven_square(2);
    away.points.col(0).array() += 5;
    EXPECT_EQ(transfer(build_mesh(away), conserve), "source and target have no area in common");
    field.values(4, 0) = NAN;
    EXPECT_EQ(transfer(source), "field 'p' of the source is not finite at vertex " +
                                    std::to_string(source.numbering.vertex[4]));
}

TEST(Remapper, RefusesASourceWithoutElements)
{
    const Mesh source = points_mesh({{0, 0, 0}});
    const Locator locator(source);
    EXPECT_EQ(message_of([&] { Remapper(locator, source); }),
              "the source has no element to take values from");
}

TEST(Remapper, CarriesFromASingleElement)
{
    MeshData data;
    data.points.resize(3, 3);
    data.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    data.elements = {{0, 1, 2, -1}};
    const Mesh source = build_mesh(data);
    const Matrix values = carried(source, nodal(source, linear), points_mesh({{0.25, 0.25, 0}, {1, 1, 0}}));
    EXPECT_NEAR(values(0, 0), linear(0.25, 0.25), 1e-15);
    EXPECT_EQ(values(1, 0), values(0, 0));
}

} // namespace
