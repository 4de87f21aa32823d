#include "libmorph/geometry/mesh_parts.h"

#include "libmorph/geometry/closest_on_triangle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace morph {

MeshParts::MeshParts(const Mesh& mesh) : points_(points(mesh))
{
    if (mesh.dimension == 2)
        add_segments(mesh);
    else
        add_triangles(mesh);
}

void MeshParts::add_segments(const Mesh& mesh)
{
    std::vector<std::array<Index, 2>> segments;
    for (const Marker& marker : mesh.markers)
        segments.insert(segments.end(), marker.edges.begin(), marker.edges.end());
    for (const auto edge : mesh.kernel.edges())
        if (edge.is_boundary())
            segments.push_back({edge.v0().idx(), edge.v1().idx()});
    for (const auto& [a, b] : segments)
        parts_.push_back({a, b, b});
    segments_.emplace(points_, segments);
}

void MeshParts::add_triangles(const Mesh& mesh)
{
    for (const Element& e : element_table(mesh)) {
        first_.push_back(parts_.size());
        parts_.push_back({e[0], e[1], e[2]});
        if (e[3] >= 0)
            parts_.push_back({e[0], e[2], e[3]});
    }
    first_.push_back(parts_.size());
    triangles_.emplace(mesh);
}

Eigen::Vector3d MeshParts::corner(std::size_t part, std::size_t k) const
{
    return points_.row(parts_[part][k]);
}

ConvexPiece MeshParts::piece(std::size_t part) const
{
    ConvexPiece piece;
    for (std::size_t k = 0; k < 3; ++k)
        piece.add(corner(part, k));
    return piece;
}

double MeshParts::distance(std::size_t part, const Eigen::Vector3d& p) const
{
    return std::sqrt(closest_on_triangle({corner(part, 0), corner(part, 1), corner(part, 2)}, p).distance2);
}

MeshParts::Nearest MeshParts::nearest(const Eigen::Vector3d& p) const
{
    if (segments_) {
        const SegmentTree::Nearest found = segments_->nearest(p.x(), p.y());
        return {static_cast<std::size_t>(found.segment), found.distance};
    }
    const ElementTree::Closest found = triangles_->closest(p);
    const std::size_t first = first_[static_cast<std::size_t>(found.face)];
    const std::size_t last = first_[static_cast<std::size_t>(found.face) + 1] - 1;
    return {distance(last, p) < distance(first, p) ? last : first, found.distance};
}

Eigen::Vector3d MeshParts::normal_towards(std::size_t part, const Eigen::Vector3d& p) const
{
    const Eigen::Vector3d a = corner(part, 0), ab = corner(part, 1) - a, ac = corner(part, 2) - a;
    const Eigen::Vector3d normal = segments_ ? Eigen::Vector3d(-ab.y(), ab.x(), 0) : ab.cross(ac);
    return normal.dot(p - a) < 0 ? -normal.normalized() : normal.normalized();
}

MeshParts::Plane MeshParts::bisector(std::size_t one, std::size_t other, const Eigen::Vector3d& p) const
{
    const Eigen::Vector3d m = normal_towards(one, p), n = normal_towards(other, p);
    const Eigen::Vector3d normal = n - m;
    const double level = n.dot(corner(other, 0)) - m.dot(corner(one, 0));
    const double length2 = normal.squaredNorm();
    // Nearly parallel planes have no bisector that could be computed.
    constexpr double kParallel2 = 1e-20;
    if (length2 < kParallel2)
        return {p, Eigen::Vector3d::Zero()};
    return {p + (level - normal.dot(p)) / length2 * normal, normal};
}

std::vector<MeshParts::Plane> MeshParts::walls(std::size_t part) const
{
    const Eigen::Vector3d a = corner(part, 0), b = corner(part, 1), c = corner(part, 2);
    if (segments_)
        return {{a, b - a}, {b, a - b}};
    const Eigen::Vector3d up = (b - a).cross(c - a);
    if (up.isZero(0))
        return {};
    return {{a, up.cross(b - a)}, {b, up.cross(c - b)}, {c, up.cross(a - c)}};
}

} // namespace morph
