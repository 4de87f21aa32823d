#include "libmorph/pipeline/comparison.h"

#include "libmorph/core/error.h"
#include "libmorph/quality/smoothness.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

/// Where the nodes of the boundaries are against where their moved curves put them, residuals kept.
void measure_boundary(const Mesh& mesh, const PlacedBoundaries& placed, ComparisonRow& row)
{
    double squares = 0;
    std::size_t nodes = 0;
    for (std::size_t b = 0; b < placed.boundaries.size(); ++b) {
        const CurveBoundary& boundary = placed.boundaries[b];
        const Curve moved = moved_curve(placed, b, placed.displacements);
        const Points2& P = boundary.curve.definition().control_points;
        const double size = (P.colwise().maxCoeff() - P.colwise().minCoeff()).norm();
        for (std::size_t i = 0; i < boundary.vertices.size(); ++i) {
            const double u = boundary.parameters[i].u;
            const Eigen::Vector2d before = points(mesh).row(boundary.vertices[i]).head<2>().transpose();
            const Eigen::Vector2d after = row.moved.positions.row(boundary.vertices[i]).head<2>().transpose();
            const Eigen::Vector2d target = before + moved.point(u) - boundary.curve.point(u);
            const double error = (after - target).norm() / size;
            row.boundary_error = std::max(row.boundary_error, error);
            squares += error * error;
            ++nodes;
        }
    }
    row.rms_boundary_error = nodes == 0 ? 0 : std::sqrt(squares / static_cast<double>(nodes));
}

Index worst_element(const Mesh& mesh, const Points& positions)
{
    const std::vector<ElementQuality> quality = element_quality(mesh, positions);
    const auto worst = std::min_element(quality.begin(), quality.end(), [](const auto& a, const auto& b) {
        return a.scaled_jacobian < b.scaled_jacobian;
    });
    return static_cast<Index>(worst - quality.begin());
}

} // namespace

ComparisonRow compare(const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& motion,
                      const ComparedMethod& method)
{
    if (motion.curves.empty())
        throw InputError(motion.where +
                         "methods are compared by how well they follow curves, but there is no "
                         "[[boundary]]");
    ComparisonRow row;
    row.method = method.name;
    row.moved = method.move(mesh, placed, motion);
    measure_boundary(mesh, placed, row);
    row.quality = quality_report(mesh, row.moved.positions, points(mesh));
    row.energy = dirichlet_energy(mesh, points(mesh), row.moved.positions);
    row.worst_element = worst_element(mesh, row.moved.positions);
    return row;
}

} // namespace morph
