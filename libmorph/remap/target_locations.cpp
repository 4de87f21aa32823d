#include "libmorph/remap/target_locations.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/space_curve.h"

#include <cmath>
#include <string>
#include <utility>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 512;

bool is_on_rim(const Mesh& mesh, const ElementTree::Closest& closest)
{
    if (closest.feature == 0)
        return false;
    const Element element = element_corners(mesh, closest.face);
    const auto corner = static_cast<std::size_t>(std::abs(closest.feature) - 1);
    const VertexHandle v(element[corner]);
    if (closest.feature < 0)
        return mesh.kernel.is_boundary(v);
    const auto next = (corner + 1) % static_cast<std::size_t>(corner_count(element));
    const HalfedgeHandle side = mesh.kernel.find_halfedge(v, VertexHandle(element[next]));
    return mesh.kernel.is_boundary(mesh.kernel.edge_handle(side));
}

void collect_outside(TargetLocations& result)
{
    for (std::size_t i = 0; i < result.elements.face.size(); ++i)
        if (result.elements.face[i] < 0)
            result.outside.push_back(static_cast<Index>(i));
}

TargetLocations locate_in_plane(const Locator& source, const Eigen::Ref<const Points>& targets)
{
    TargetLocations result;
    result.elements = source.locate(targets);
    collect_outside(result);
    result.outside_feet.resize(result.outside.size());
    parallel_for(result.outside.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result.outside_feet[i] = source.tree().closest(targets.row(result.outside[i]).transpose());
    });
    return result;
}

double size_of(const Mesh& mesh)
{
    const auto p = points(mesh);
    return (p.colwise().maxCoeff() - p.colwise().minCoeff()).norm();
}

TargetLocations locate_on_surface(const Locator& source, const Eigen::Ref<const Points>& targets)
{
    constexpr double kTouching = 1e-9; // of the surface's size: what rounding moves a point off a rim
    const double touching = kTouching * size_of(source.source());
    const auto n = static_cast<std::size_t>(targets.rows());
    TargetLocations result;
    result.elements.order = hilbert_order(targets, 3);
    result.elements.face.assign(n, -1);
    result.feet.resize(targets.rows(), 3);
    result.distance.resize(n);
    std::vector<Index> closest_face(n);
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index target = result.elements.order[i];
            const auto t = static_cast<std::size_t>(target);
            const ElementTree::Closest closest = source.tree().closest(targets.row(target).transpose());
            result.feet.row(target) = closest.point.transpose();
            result.distance[t] = closest.distance;
            closest_face[t] = closest.face;
            if (closest.distance <= touching || !is_on_rim(source.source(), closest))
                result.elements.face[t] = closest.face;
        }
    });
    collect_outside(result);
    for (const Index target : result.outside) {
        const auto t = static_cast<std::size_t>(target);
        result.outside_feet.push_back(
            {closest_face[t], result.feet.row(target).transpose(), result.distance[t], 0});
    }
    return result;
}

void require_finite(const Eigen::Ref<const Points>& targets)
{
    for (Eigen::Index i = 0; i < targets.rows(); ++i)
        if (!targets.row(i).allFinite())
            throw InputError("target " + std::to_string(i) + " has a coordinate that is not finite");
}

} // namespace

TargetLocations locate_targets(const Locator& source, Points targets)
{
    if (element_count(source.source()) == 0)
        throw InputError("the source has no element to take values from");
    const bool planar = source.source().dimension == 2;
    if (!planar)
        require_finite(targets);
    TargetLocations result = planar ? locate_in_plane(source, targets) : locate_on_surface(source, targets);
    result.points = std::move(targets);
    return result;
}

TargetCounts count_targets(const TargetLocations& locations, const std::vector<Index>& file_numbers)
{
    TargetCounts counts;
    counts.targets = locations.elements.face.size();
    counts.outside = locations.outside.size();
    for (std::size_t i = 0; i < locations.outside.size(); ++i) {
        const Index number = file_numbers[static_cast<std::size_t>(locations.outside[i])];
        const double distance = locations.outside_feet[i].distance;
        if (counts.farthest < 0 || distance > counts.distance ||
            (distance == counts.distance && number < counts.farthest)) {
            counts.farthest = number;
            counts.distance = distance;
            counts.where = locations.points.row(locations.outside[i]);
        }
    }
    return counts;
}

Matrix target_status(const TargetLocations& locations)
{
    Matrix status = Matrix::Zero(static_cast<Eigen::Index>(locations.elements.face.size()), 1);
    for (const Index target : locations.outside)
        status(target, 0) = 1;
    return status;
}

Matrix target_distances(const TargetLocations& locations)
{
    Matrix distance = Matrix::Zero(static_cast<Eigen::Index>(locations.elements.face.size()), 1);
    for (std::size_t i = 0; i < locations.distance.size(); ++i)
        distance(static_cast<Eigen::Index>(i), 0) = locations.distance[i];
    for (std::size_t i = 0; i < locations.outside.size(); ++i)
        distance(locations.outside[i], 0) = locations.outside_feet[i].distance;
    return distance;
}

} // namespace morph
