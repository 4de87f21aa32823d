#include "libmorph/quality/quality.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/full_quality.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace morph {
namespace {

// The report and the check sum some thousand terms of size one in different orders.
constexpr double kSumTol = 1e-12;

/// Triangles and quads side by side: the left third of a quad grid cut into triangles.
MeshData mixed_square(Index cells)
{
    MeshData mesh = test::quad_square(cells);
    std::vector<Element> elements;
    for (const Element& q : mesh.elements)
        if (mesh.points(q[0], 0) < 0.35) {
            elements.push_back({q[0], q[1], q[2], -1});
            elements.push_back({q[0], q[2], q[3], -1});
        } else {
            elements.push_back(q);
        }
    mesh.elements = elements;
    return mesh;
}

/// Every vertex moved by up to @p amount in x and y, the same for the same seed.
Points shaken(const Points& points, double amount, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amount, amount);
    Points moved = points;
    for (Index i = 0; i < moved.rows(); ++i) {
        moved(i, 0) += shift(random);
        moved(i, 1) += shift(random);
    }
    return moved;
}

/// Vertices and elements listed in a random order.
MeshData shuffled(const MeshData& mesh, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Index> place(static_cast<std::size_t>(mesh.points.rows()));
    for (std::size_t i = 0; i < place.size(); ++i)
        place[i] = static_cast<Index>(i);
    std::shuffle(place.begin(), place.end(), random);
    MeshData result;
    result.points.resize(mesh.points.rows(), 3);
    for (Index i = 0; i < mesh.points.rows(); ++i)
        result.points.row(place[static_cast<std::size_t>(i)]) = mesh.points.row(i);
    for (Element element : mesh.elements) {
        for (int k = 0; k < corner_count(element); ++k)
            element[static_cast<std::size_t>(k)] =
                place[static_cast<std::size_t>(element[static_cast<std::size_t>(k)])];
        result.elements.push_back(element);
    }
    std::shuffle(result.elements.begin(), result.elements.end(), random);
    return result;
}

/// File numbers of the elements with a corner that does not turn left, in extended precision: exact enough
/// for coordinates that are random in their last digits.
std::vector<Index> tangled(const MeshData& data, const Points& points)
{
    std::vector<Index> found;
    for (std::size_t e = 0; e < data.elements.size(); ++e) {
        const Element& element = data.elements[e];
        const int n = corner_count(element);
        bool good = true;
        for (int k = 0; k < n; ++k) {
            const auto at = [&](int corner, int axis) {
                return static_cast<long double>(
                    points(element[static_cast<std::size_t>((k + corner) % n)], axis));
            };
            const int before = n - 1;
            good = good && (at(1, 0) - at(0, 0)) * (at(before, 1) - at(0, 1)) >
                               (at(1, 1) - at(0, 1)) * (at(before, 0) - at(0, 0));
        }
        if (!good)
            found.push_back(static_cast<Index>(e));
    }
    return found;
}

/// Points given in the file's order, in the order of the mesh.
Points in_mesh_order(const Mesh& mesh, const Points& file_points)
{
    Points result(vertex_count(mesh), 3);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        result.row(v) = file_points.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    return result;
}

TEST(QualityReport, CountsElementsOfBothKinds)
{
    const QualityReport report = quality_report(build_mesh(mixed_square(10)));
    EXPECT_EQ(report.vertices, 121);
    EXPECT_EQ(report.triangles, 80);
    EXPECT_EQ(report.quads, 60);
    EXPECT_EQ(report.inverted, 0);
    EXPECT_EQ(report.negative_area, 0);
    EXPECT_TRUE(report.inverted_elements.empty());
    EXPECT_FALSE(report.size_skew.has_value());
}

TEST(QualityReport, OfOneSquareIsIdeal)
{
    const Mesh mesh = build_mesh(test::quad_square(1));
    const Points positions = points(mesh);
    const QualityReport report = quality_report(mesh, positions, positions);
    EXPECT_DOUBLE_EQ(report.min_scaled_jacobian, 1);
    EXPECT_DOUBLE_EQ(report.mean_scaled_jacobian, 1);
    EXPECT_DOUBLE_EQ(report.min_angle, 90);
    EXPECT_DOUBLE_EQ(report.max_angle, 90);
    EXPECT_DOUBLE_EQ(report.max_aspect_ratio, 1);
    ASSERT_TRUE(report.size_skew.has_value());
    EXPECT_DOUBLE_EQ(report.size_skew->min, 1);
    EXPECT_DOUBLE_EQ(report.size_skew->mean, 1);
}

TEST(QualityReport, SumsUpWhatTheElementsSay)
{
    const Mesh mesh = build_mesh(mixed_square(100)); // several blocks of elements
    const Points moved = shaken(points(mesh), 0.004, 5);
    const Points reference = points(mesh);
    const PositionsView view = reference;
    const QualityReport report = quality_report(mesh, moved, reference);
    const auto elements = element_quality(mesh, moved, &view);
    double sum = 0;
    double skew_sum = 0;
    double worst_angle = 360;
    Index inverted = 0;
    Index negative = 0;
    for (const ElementQuality& q : elements) {
        sum += q.scaled_jacobian;
        skew_sum += q.size_skew;
        worst_angle = std::min(worst_angle, q.min_angle);
        inverted += q.inverted ? 1 : 0;
        negative += q.area < 0 ? 1 : 0;
    }
    const auto count = static_cast<double>(elements.size());
    EXPECT_NEAR(report.mean_scaled_jacobian, sum / count, kSumTol);
    EXPECT_NEAR(report.size_skew->mean, skew_sum / count, kSumTol);
    EXPECT_EQ(report.min_angle, worst_angle);
    EXPECT_EQ(report.inverted, inverted);
    EXPECT_EQ(report.negative_area, negative);
    EXPECT_GT(inverted, negative) << "some quads must be inverted with positive area";
    EXPECT_GT(negative, 0);
}

TEST(QualityReport, NamesTheInvertedElementsByTheirNumberInAShuffledFile)
{
    const MeshData data = shuffled(mixed_square(20), 7);
    const Mesh mesh = build_mesh(data);
    const Points moved = shaken(data.points, 0.02, 11);
    const std::vector<Index> expected = tangled(data, moved);
    ASSERT_GT(expected.size(), 10U);
    const Points positions = in_mesh_order(mesh, moved);
    const QualityReport report = quality_report(mesh, positions);
    EXPECT_EQ(report.inverted_elements, expected);
    std::vector<Index> faces = inverted_elements(mesh, positions);
    for (Index& face : faces)
        face = mesh.numbering.element[static_cast<std::size_t>(face)];
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(faces, expected);
}

TEST(QualityReport, ListsAThousandInvertedElementsButCountsThemAll)
{
    const Mesh mesh = build_mesh(test::uneven_square(40));
    Points mirrored = points(mesh);
    mirrored.col(0) *= -1;
    const QualityReport report = quality_report(mesh, mirrored);
    EXPECT_EQ(report.inverted, 3200);
    EXPECT_EQ(report.negative_area, 3200);
    ASSERT_EQ(report.inverted_elements.size(), kListedElements);
    for (std::size_t i = 0; i < kListedElements; ++i)
        EXPECT_EQ(report.inverted_elements[i], static_cast<Index>(i));
}

TEST(QualityReport, CountsElementsByScaledJacobianAndSmallestAngle)
{
    const Mesh mesh = build_mesh(mixed_square(100)); // several blocks of elements
    const Points moved = shaken(points(mesh), 0.004, 5);
    const QualityReport report = quality_report(mesh, moved);
    for (std::size_t bin = 0; bin < 10; ++bin) {
        Index expected = 0;
        for (const ElementQuality& q : element_quality(mesh, moved))
            expected += !q.inverted && std::floor(q.scaled_jacobian * 10) == static_cast<double>(bin) ? 1 : 0;
        EXPECT_EQ(report.scaled_jacobian_counts[bin], expected) << bin;
    }
    for (std::size_t bin = 0; bin < 9; ++bin) {
        Index expected = 0;
        for (const ElementQuality& q : element_quality(mesh, moved))
            expected += !q.inverted && std::floor(q.min_angle / 10) == static_cast<double>(bin) ? 1 : 0;
        EXPECT_EQ(report.min_angle_counts[bin], expected) << bin;
    }
}

TEST(QualityReport, CountsIdealElementsInTheLastBins)
{
    const QualityReport report = quality_report(build_mesh(test::quad_square(1)));
    EXPECT_EQ(report.scaled_jacobian_counts.back(), 1);
    EXPECT_EQ(report.min_angle_counts.back(), 1);
}

TEST(QualityReport, RanksTheWorstElementsOfAShuffledFile)
{
    const MeshData data = shuffled(mixed_square(100), 7);
    const Mesh mesh = build_mesh(data);
    const Points moved = in_mesh_order(mesh, shaken(data.points, 0.004, 5));
    const auto all = element_quality(mesh, moved);
    std::vector<std::pair<double, Index>> ranked;
    for (std::size_t f = 0; f < all.size(); ++f)
        ranked.emplace_back(all[f].scaled_jacobian, mesh.numbering.element[f]);
    std::sort(ranked.begin(), ranked.end());
    const QualityReport report = quality_report(mesh, moved);
    ASSERT_EQ(report.worst.size(), kWorstElements);
    for (std::size_t i = 0; i < kWorstElements; ++i) {
        EXPECT_EQ(report.worst[i].element, ranked[i].second);
        EXPECT_EQ(report.worst[i].quality.scaled_jacobian, ranked[i].first);
        EXPECT_EQ(mesh.numbering.element[static_cast<std::size_t>(report.worst[i].face)], ranked[i].second);
    }
}

TEST(QualityReport, RanksEquallyBadElementsByTheirNumber)
{
    const Mesh mesh = build_mesh(shuffled(test::quad_square(100), 3));
    const QualityReport report = quality_report(mesh, Points::Zero(vertex_count(mesh), 3));
    for (std::size_t i = 0; i < kWorstElements; ++i)
        EXPECT_EQ(report.worst.at(i).element, static_cast<Index>(i));
}

TEST(ElementQuality, HasTheJacobianOfEveryCorner)
{
    MeshData data = test::quad_square(1);
    data.points.row(2) = Eigen::RowVector3d(0.5, 0.25, 0); // whichever corner: found again below
    const Mesh mesh = build_mesh(data);
    const Element element = element_corners(mesh, 0);
    const ElementQuality q = element_quality(mesh, points(mesh)).at(0);
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::RowVector3d corner = points(mesh).row(element[k]);
        const Eigen::RowVector3d next = points(mesh).row(element[(k + 1) % 4]) - corner;
        const Eigen::RowVector3d previous = points(mesh).row(element[(k + 3) % 4]) - corner;
        EXPECT_DOUBLE_EQ(q.jacobian[k], next.x() * previous.y() - next.y() * previous.x());
    }
}

TEST(QualityReport, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(mixed_square(150));
    const Points moved = shaken(points(mesh), 0.003, 13);
    set_thread_count(1);
    const QualityReport one = quality_report(mesh, moved, points(mesh));
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        const QualityReport many = quality_report(mesh, moved, points(mesh));
        EXPECT_EQ(one.mean_scaled_jacobian, many.mean_scaled_jacobian);
        EXPECT_EQ(one.size_skew->mean, many.size_skew->mean);
        EXPECT_EQ(one.inverted_elements, many.inverted_elements);
        EXPECT_EQ(one.scaled_jacobian_counts, many.scaled_jacobian_counts);
        EXPECT_EQ(one.worst.back().element, many.worst.back().element);
    }
    set_thread_count(0);
}

TEST(QualityReport, OfAMeshWithoutElementsIsAllZero)
{
    Mesh mesh;
    const QualityReport report = quality_report(mesh);
    EXPECT_EQ(report.triangles + report.quads, 0);
    EXPECT_EQ(report.min_scaled_jacobian, 0);
    EXPECT_EQ(report.mean_scaled_jacobian, 0);
    EXPECT_EQ(report.min_angle, 0);
}

TEST(MinAngle, OfAMeshThatIsNotBuiltYetIsThatOfTheReport)
{
    for (const MeshData& data : {test::uneven_square(6), test::quad_square(6)})
        EXPECT_NEAR(min_angle(data), quality_report(build_mesh(data)).min_angle, 1e-12);
    EXPECT_EQ(min_angle(MeshData{}), 180);
}

TEST(ElementPlace, IsTheMeanOfTheCornersWithTheNearestMarker)
{
    MeshData data = test::quad_square(4);
    const Mesh mesh = build_mesh(data);
    for (Index face = 0; face < element_count(mesh); ++face) {
        const auto place = element_place(mesh, points(mesh), face);
        EXPECT_EQ(place.corners, 4);
        const double x = place.centroid.x(), y = place.centroid.y();
        EXPECT_DOUBLE_EQ(place.marker_distance,
                         std::min({x, y, 1 - x, 1 - y})); // the sides of the unit square
        const std::map<std::string, double> sides{
            {"bottom", y}, {"right", 1 - x}, {"top", 1 - y}, {"left", x}};
        EXPECT_DOUBLE_EQ(sides.at(place.nearest_marker), place.marker_distance);
    }
}

TEST(ElementPlace, HasNoMarkerInAMeshWithoutAny)
{
    MeshData data = test::uneven_square(1);
    data.markers.clear();
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(element_place(mesh, points(mesh), 0).nearest_marker, "");
}

TEST(QualityReport, RefusesPositionsOfAnotherMesh)
{
    const Mesh mesh = build_mesh(test::uneven_square(2));
    EXPECT_THROW(quality_report(mesh, Points::Zero(8, 3)), InputError);
    EXPECT_THROW(quality_report(mesh, points(mesh), Points::Zero(10, 3)), InputError);
    EXPECT_THROW(element_quality(mesh, Points::Zero(8, 3)), InputError);
    EXPECT_THROW(element_place(mesh, Points::Zero(8, 3), 0), InputError);
}

} // namespace
} // namespace morph
