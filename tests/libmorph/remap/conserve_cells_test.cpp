#include "libmorph/remap/conserve_cells.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/exact_overlap.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace morph;

/// Of the integral of the field's magnitude: what conservation means here.
constexpr double kConserved = 1e-12;

Matrix random_values(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
    std::mt19937 random(seed);
    Matrix values(rows, columns);
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values.data()[i] = static_cast<double>(random()) / 2147483648.0 - 1;
    return values;
}

Transfer carried(const Mesh& source, const Mesh& target, const Matrix& values)
{
    return conserve_cells(Locator(source), target, values);
}

/// Sum of value times covered area.
Eigen::RowVectorXd integral(const Transfer& transfer)
{
    const Eigen::Map<const Eigen::VectorXd> areas(transfer.covered.data(), transfer.values.rows());
    return areas.transpose() * transfer.values;
}

/// The integral of a field of the source over all of it.
Eigen::RowVectorXd integral(const Mesh& mesh, const Matrix& values)
{
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(values.cols());
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        for (int k = 2; k < corner_count(e); ++k) {
            const Eigen::RowVector3d a = points(mesh).row(e[0]);
            const Eigen::RowVector3d u = points(mesh).row(e[static_cast<std::size_t>(k - 1)]) - a;
            const Eigen::RowVector3d v = points(mesh).row(e[static_cast<std::size_t>(k)]) - a;
            sum += (u.x() * v.y() - u.y() * v.x()) / 2 * values.row(f);
        }
    }
    return sum;
}

MeshData rectangle(double x, double y, double width, double height)
{
    MeshData mesh;
    mesh.points.resize(4, 3);
    mesh.points << x, y, 0, x + width, y, 0, x + width, y + height, 0, x, y + height, 0;
    mesh.elements = {{0, 1, 2, 3}};
    return mesh;
}

TEST(ConserveCells, PreservesTheIntegralOfEveryComponentBetweenAllKindsOfMeshes)
{
    MeshData hybrid = test::quad_square(31);
    for (std::size_t e = 0; e < 400; ++e) { // some quads become two triangles
        const Element q = hybrid.elements[e];
        hybrid.elements[e] = {q[0], q[1], q[2], -1};
        hybrid.elements.push_back({q[0], q[2], q[3], -1});
    }
    const std::vector<MeshData> squares{test::uneven_square(1), test::uneven_square(40),
                                        test::quad_square(27), hybrid, test::quad_square(60)};
    for (const MeshData& from : squares)
        for (const MeshData& to : squares) {
            const Mesh source = build_mesh(from), target = build_mesh(to);
            const Matrix values = random_values(element_count(source), 3, 4);
            const Transfer transfer = carried(source, target, values);
            const double magnitude = integral(source, values.cwiseAbs()).sum();
            EXPECT_LE((integral(transfer) - integral(source, values)).norm(), kConserved * magnitude);
            EXPECT_LE((transfer.source_integral - integral(source, values)).norm(), kConserved * magnitude);
            EXPECT_NEAR(transfer.covered_area, 1, kConserved);
            EXPECT_NEAR(transfer.target_area, 1, kConserved);
            EXPECT_NEAR(transfer.source_area, 1, kConserved);
        }
}

TEST(ConserveCells, GivesTheMeanOverTheCommonRegionOnRandomMeshes)
{
    // Areas that are cut off the smaller element by sides of the larger one are right to about 1e-16 of their
    // boxes; elements of less are left out here (slivers 1e-12 thin across ordinary elements).
    constexpr double kMean = 1e-9;
    int compared = 0;
    for (std::uint32_t seed = 1; seed <= 500; ++seed) {
        const MeshData from = test::random_mesh(test::some_settings(seed));
        const MeshData to = test::random_mesh(test::some_settings(3 + 5 * seed));
        const Mesh source = build_mesh(from), target = build_mesh(to);
        const Matrix values = random_values(element_count(source), 1, seed);
        std::vector<double> area(to.elements.size()), sum(to.elements.size()), value(from.elements.size());
        for (Index f = 0; f < element_count(source); ++f)
            value[static_cast<std::size_t>(source.numbering.element[static_cast<std::size_t>(f)])] =
                values(f, 0);
        for (const test::ExactOverlap& overlap : test::exact_overlaps(from, to)) {
            area[static_cast<std::size_t>(overlap.target)] += overlap.area;
            sum[static_cast<std::size_t>(overlap.target)] +=
                overlap.area * value[static_cast<std::size_t>(overlap.source)];
        }
        const Transfer transfer = carried(source, target, values);
        for (Index f = 0; f < element_count(target); ++f) {
            const auto e = static_cast<std::size_t>(target.numbering.element[static_cast<std::size_t>(f)]);
            if (area[e] < 1e-6) {
                EXPECT_LT(transfer.covered[static_cast<std::size_t>(f)], 2e-6) << "seed " << seed;
                continue;
            }
            EXPECT_NEAR(transfer.covered[static_cast<std::size_t>(f)], area[e], kMean * area[e])
                << "seed " << seed;
            EXPECT_NEAR(transfer.values(f, 0), sum[e] / area[e], kMean) << "seed " << seed;
            ++compared;
        }
    }
    EXPECT_GT(compared, 2000);
}

TEST(ConserveCells, KeepsConstantsBitForBitAndValuesInTheirRange)
{
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        const Mesh source = build_mesh(test::random_mesh(test::some_settings(seed)));
        const Mesh target = build_mesh(test::random_mesh(test::some_settings(3 + 5 * seed)));
        Matrix values = random_values(element_count(source), 2, seed);
        values.col(0).setConstant(1.0 / 3);
        if (seed % 2 == 0) // neighbouring numbers: rounding alone would leave their range
            values.col(1) = (values.col(1).array() > 0)
                                .select(Matrix::Constant(values.rows(), 1, 0.99), std::nextafter(0.99, 1));
        const Transfer transfer = carried(source, target, values);
        for (Index f = 0; f < element_count(target); ++f) {
            const bool covered = transfer.covered[static_cast<std::size_t>(f)] > 0;
            EXPECT_EQ(transfer.values(f, 0), covered ? 1.0 / 3 : 0);
            EXPECT_GE(transfer.values(f, 1), covered ? values.col(1).minCoeff() : 0);
            EXPECT_LE(transfer.values(f, 1), covered ? values.col(1).maxCoeff() : 0);
        }
    }
}

TEST(ConserveCells, OntoTheMeshItselfGivesEveryBitBack)
{
    for (const MeshData& data : {test::uneven_square(20), test::quad_square(20), test::touching_squares(5),
                                 test::random_mesh({.vertices = 300, .quads = 0.5, .holes = 0.2})}) {
        const Mesh mesh = build_mesh(data);
        Matrix values = random_values(element_count(mesh), 9, 8);
        values.col(0) *= std::numeric_limits<double>::max();
        values.col(1) *= std::numeric_limits<double>::min();
        const Matrix back = carried(mesh, mesh, values).values;
        EXPECT_EQ(
            std::memcmp(back.data(), values.data(), sizeof(double) * static_cast<std::size_t>(values.size())),
            0);
    }
}

TEST(ConserveCells, TellsWhatIsCoveredWhereMeshesOverlapInPart)
{
    constexpr double kSum = 1e-13;                               // of a thousand areas
    const Mesh source = build_mesh(rectangle(0.25, -1, 2, 1.5)); // covers 0.75 x 0.5 of the unit square
    const Mesh target = build_mesh(test::quad_square(30));
    const Transfer transfer = carried(source, target, Matrix::Constant(1, 1, 7));
    EXPECT_NEAR(transfer.covered_area, 0.375, kSum);
    EXPECT_NEAR(transfer.target_area, 1, kSum);
    EXPECT_NEAR(transfer.source_area, 3, kSum);
    for (Index f = 0; f < element_count(target); ++f) {
        const Element e = element_corners(target, f);
        double right = 0, bottom = 1;
        for (const Index v : e) {
            right = std::max(right, points(target)(v, 0));
            bottom = std::min(bottom, points(target)(v, 1));
        }
        const bool covered = transfer.covered[static_cast<std::size_t>(f)] > 0;
        EXPECT_EQ(transfer.values(f, 0), covered ? 7 : 0);
        EXPECT_EQ(covered, right > 0.25 && bottom < 0.5);
    }
}

TEST(ConserveCells, PreservesTheIntegralFarFromTheOriginAndInAnyUnit)
{
    for (const double scale : {1e-8, 1.0, 1e8}) {
        MeshData from = test::uneven_square(30), to = test::quad_square(17);
        for (MeshData* data : {&from, &to}) {
            data->points.leftCols(2).array() += 64; // rounds the corners, those of the square to the same
            data->points *= scale;
        }
        const Mesh source = build_mesh(from), target = build_mesh(to);
        const Matrix values = random_values(element_count(source), 1, 4);
        const Transfer transfer = carried(source, target, values);
        EXPECT_NEAR(integral(transfer)[0], integral(source, values)[0], kConserved * scale * scale);
    }
}

TEST(ConserveCells, IsFirstOrderForSmoothFunctions)
{
    const auto smooth = [](double x, double y) { return std::sin(3 * x) * std::exp(y); };
    const auto at_centres = [&](const Mesh& mesh) {
        Matrix values(element_count(mesh), 1);
        for (Index f = 0; f < element_count(mesh); ++f) {
            const Element e = element_corners(mesh, f);
            const auto p = points(mesh);
            const Eigen::RowVector3d centre = (p.row(e[0]) + p.row(e[1]) + p.row(e[2])) / 3;
            values(f, 0) = smooth(centre.x(), centre.y());
        }
        return values;
    };
    std::vector<double> errors;
    for (const Index cells : {10, 20, 40, 80}) {
        const Mesh source = build_mesh(test::uneven_square(cells));
        const Mesh target = build_mesh(test::uneven_square(6 * cells / 5));
        const Matrix error = carried(source, target, at_centres(source)).values - at_centres(target);
        errors.push_back(error.norm() / std::sqrt(static_cast<double>(error.rows())));
    }
    const double order = std::log2(errors.front() / errors.back()) / 3;
    EXPECT_GT(order, 0.9);
    EXPECT_LT(order, 1.2);
}

TEST(ConserveCells, GivesTheSameBytesForAnyThreadCount)
{
    const Mesh source = build_mesh(test::uneven_annulus(1, 3, 100));
    const Mesh target = build_mesh(test::annulus(0.8, 2.5, 90, 20));
    const Matrix values = random_values(element_count(source), 2, 1);
    set_thread_count(1);
    const Transfer one = carried(source, target, values);
    set_thread_count(5);
    const Transfer five = carried(source, target, values);
    set_thread_count(0);
    EXPECT_EQ(one.values, five.values);
    EXPECT_EQ(one.covered, five.covered);
    EXPECT_EQ(one.covered_area, five.covered_area);
    EXPECT_EQ(one.target_area, five.target_area);
}

TEST(ConserveCells, RefusesValuesOfAnotherMesh)
{
    const Mesh mesh = build_mesh(test::quad_square(2));
    EXPECT_EQ(test::message_of([&] { carried(mesh, mesh, Matrix::Zero(9, 1)); }),
              "there are 9 rows of element values, but the source has 4 elements");
}

} // namespace
