#include "libmorph/quality/element_metrics.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/full_quality.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morph {
namespace {

double twice_area(const MeshData& data, Index a, Index b, Index c)
{
    const auto& p = data.points;
    return (p(b, 0) - p(a, 0)) * (p(c, 1) - p(a, 1)) - (p(b, 1) - p(a, 1)) * (p(c, 0) - p(a, 0));
}

/// The value of a metric for each element.
Matrix values_of(const std::vector<Field>& metrics, const std::string& name)
{
    const Field* field = find_field(metrics, name, FieldLocation::element);
    EXPECT_NE(field, nullptr) << name;
    return field == nullptr ? Matrix() : field->values;
}

/// An even grid of 4 x 4 quads, 0.25 wide.
MeshData even_grid(double height)
{
    MeshData mesh = test::quad_square(4);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        mesh.points.row(v) << 0.25 * (v % 5), height * std::floor(v / 5.0), 0;
    return mesh;
}

TEST(ElementMetrics, AreThoseOfElementQualityByTheNumbersOfTheFile)
{
    const Mesh mesh = build_mesh(test::uneven_square(5));
    const auto quality = element_quality(mesh, points(mesh));
    const std::vector<Field> metrics = element_metrics(mesh);
    for (std::size_t f = 0; f < quality.size(); ++f) {
        const Index id = mesh.numbering.element[f];
        EXPECT_EQ(values_of(metrics, "area")(id, 0), quality[f].area);
        EXPECT_EQ(values_of(metrics, "scaled_jacobian")(id, 0), quality[f].scaled_jacobian);
        EXPECT_EQ(values_of(metrics, "inverted")(id, 0), 0);
    }
    EXPECT_EQ(find_field(metrics, "size_skew", FieldLocation::element), nullptr);
}

TEST(ElementMetrics, ListCornerJacobiansInTheOrderOfTheFilesCorners)
{
    MeshData mesh = test::quad_square(2);
    mesh.points.row(4) = Eigen::RowVector3d(0.6, 0.35, 0); // the middle one: all corners differ
    for (Element& element : mesh.elements)
        std::swap(element[1], element[3]); // clockwise, as some files list them
    const std::vector<Field> metrics = element_metrics(build_mesh(mesh));
    for (std::size_t e = 0; e < 4; ++e)
        for (std::size_t k = 0; k < 4; ++k) {
            const Element& q = mesh.elements[e];
            const Matrix values = values_of(metrics, "corner_jacobian_" + std::to_string(k + 1));
            EXPECT_DOUBLE_EQ(values(static_cast<Index>(e), 0),
                             -twice_area(mesh, q[k], q[(k + 1) % 4], q[(k + 3) % 4]));
        }
}

TEST(ElementMetrics, OfCellsNextToSeveralWallsAreTheSmallestHeightAndTheLargestAngle)
{
    const MeshData data = even_grid(0.5); // columns twice as high as wide
    const std::vector<Field> metrics = element_metrics(build_mesh(data));
    const Matrix height = values_of(metrics, "first_cell_height");
    EXPECT_EQ(find_field(metrics, "height_change", FieldLocation::element), nullptr);
    for (std::size_t e = 0; e < data.elements.size(); ++e) {
        Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
        for (const Index v : data.elements[e])
            centroid += data.points.row(v) / 4;
        const bool beside_left_or_right = std::abs(centroid.x() - 0.5) > 0.25;
        const bool beside_bottom_or_top = std::abs(centroid.y() - 1) > 0.5;
        const double value = height(static_cast<Index>(e), 0);
        if (beside_left_or_right) // in the corners the smaller of both
            EXPECT_DOUBLE_EQ(value, 0.25);
        else if (beside_bottom_or_top)
            EXPECT_DOUBLE_EQ(value, 0.5);
        else
            EXPECT_TRUE(std::isnan(value));
    }
}

TEST(ElementMetrics, CompareWithTheMeshBeforeItWasMoved)
{
    Mesh mesh = build_mesh(even_grid(0.25));
    const Points before = points(mesh);
    points(mesh) *= 2; // squares still, of four times the area: f_ss = sqrt(1/4)
    const PositionsView reference = before;
    const std::vector<Field> metrics = element_metrics(mesh, &reference);
    EXPECT_TRUE(values_of(metrics, "size_skew").isApproxToConstant(0.5));
    const Matrix change = values_of(metrics, "height_change");
    for (Index e = 0; e < change.rows(); ++e)
        EXPECT_TRUE(std::isnan(change(e, 0)) || std::abs(change(e, 0) - 1) < 1e-12);
}

TEST(FullQuality, HasThePlacesOfTheWorstElementsAndTheCellsNextToWalls)
{
    MeshData data = even_grid(0.25);
    data.points.row(6) << 0.45, 0.25, 0; // the inner vertex next to the lower left corner
    Mesh mesh = build_mesh(data);
    const FullQuality quality = full_quality(mesh);
    ASSERT_EQ(quality.worst_places.size(), quality.summary.worst.size());
    for (std::size_t i = 0; i < quality.worst_places.size(); ++i) {
        const ElementPlace place = element_place(mesh, points(mesh), quality.summary.worst[i].face);
        EXPECT_EQ(quality.worst_places[i].centroid, place.centroid);
        EXPECT_EQ(quality.worst_places[i].nearest_marker, place.nearest_marker);
    }
    ASSERT_EQ(quality.walls.size(), 4U);
    for (const WallQuality& wall : quality.walls) {
        EXPECT_EQ(wall.cells, 4);
        EXPECT_FALSE(wall.change.has_value());
    }
    EXPECT_FALSE(quality.summary.size_skew.has_value());
}

TEST(FullQuality, ComparesWithTheMeshBeforeItWasMoved)
{
    Mesh mesh = build_mesh(even_grid(0.25));
    const Points before = points(mesh);
    points(mesh).col(1) *= 0.9;
    const PositionsView reference = before;
    const FullQuality quality = full_quality(mesh, &reference);
    ASSERT_TRUE(quality.summary.size_skew.has_value());
    EXPECT_NEAR(quality.summary.size_skew->min, std::sqrt(0.9) * 1, 1e-12);
    EXPECT_NEAR(quality.walls[0].change->height.value, 0.1, 1e-12);
}

} // namespace
} // namespace morph
