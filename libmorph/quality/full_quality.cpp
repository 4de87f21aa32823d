#include "libmorph/quality/full_quality.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <limits>

namespace morph {

namespace {

double distance_to_segment(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const Eigen::Vector3d along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((x - a).dot(along) / length2, 0.0, 1.0) : 0;
    return (x - a - t * along).norm();
}

} // namespace

ElementPlace element_place(const Mesh& mesh, const PositionsView& positions, Index face)
{
    if (positions.rows() != vertex_count(mesh))
        throw InputError("there are " + std::to_string(positions.rows()) + " positions, but the mesh has " +
                         std::to_string(vertex_count(mesh)) + " vertices");
    const Element element = element_corners(mesh, face);
    ElementPlace place;
    place.corners = corner_count(element);
    for (int k = 0; k < place.corners; ++k)
        place.centroid += positions.row(element[static_cast<std::size_t>(k)]).transpose() / place.corners;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Marker& marker : mesh.markers)
        for (const auto& [from, to] : marker.edges) {
            const double distance =
                distance_to_segment(place.centroid, positions.row(from), positions.row(to));
            if (distance >= nearest)
                continue;
            nearest = place.marker_distance = distance;
            place.nearest_marker = marker.name;
        }
    return place;
}

FullQuality full_quality(const Mesh& mesh, const PositionsView* reference)
{
    FullQuality quality;
    quality.summary =
        reference == nullptr ? quality_report(mesh) : quality_report(mesh, points(mesh), *reference);
    for (const WorstElement& worst : quality.summary.worst)
        quality.worst_places.push_back(element_place(mesh, points(mesh), worst.face));
    quality.walls = wall_quality(mesh, points(mesh), reference);
    return quality;
}

} // namespace morph
