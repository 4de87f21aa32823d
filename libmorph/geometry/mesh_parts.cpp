#include "libmorph/geometry/mesh_parts.h"

#include "libmorph/geometry/closest_on_triangle.h"
#include "libmorph/mesh/boundary_loops.h"

#include <Eigen/Geometry>

#include <cmath>

namespace morph {

MeshParts::MeshParts(const Mesh& mesh) : points_(points(mesh)), planar_(mesh.dimension == 2)
{
    if (planar_)
        add_segments(mesh);
    else
        add_triangles(mesh);
    std::vector<BoxTree::Box> boxes(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part)
        boxes[part] = box_of(part);
    tree_ = BoxTree(boxes, 1, 0);
}

void MeshParts::add_segments(const Mesh& mesh)
{
    for (const Marker& marker : mesh.markers)
        for (const auto& [a, b] : marker.edges)
            parts_.push_back({a, b, b});
    for (const auto& [a, b] : boundary_edges(mesh))
        parts_.push_back({a, b, b});
}

void MeshParts::add_triangles(const Mesh& mesh)
{
    for (const Element& e : element_table(mesh)) {
        parts_.push_back({e[0], e[1], e[2]});
        if (e[3] >= 0)
            parts_.push_back({e[0], e[2], e[3]});
    }
}

BoxTree::Box MeshParts::box_of(std::size_t part) const
{
    BoxTree::Box box;
    for (std::size_t k = 0; k < 3; ++k)
        box.extend(corner(part, k));
    return box;
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

double MeshParts::distance2(std::size_t part, const Eigen::Vector3d& p) const
{
    return closest_on_triangle({corner(part, 0), corner(part, 1), corner(part, 2)}, p).distance2;
}

double MeshParts::distance(std::size_t part, const Eigen::Vector3d& p) const
{
    return std::sqrt(distance2(part, p));
}

MeshParts::Nearest MeshParts::nearest(const Eigen::Vector3d& p, std::size_t hint) const
{
    const auto to_box2 = [&](const BoxTree::Box& box) { return box.squaredExteriorDistance(p); };
    const auto to_part2 = [&](Index part) { return distance2(static_cast<std::size_t>(part), p); };
    const auto start = static_cast<Index>(hint);
    const BoxTree::Candidate best = tree_.least(to_box2, to_part2, {start, to_part2(start)});
    return {static_cast<std::size_t>(best.rank), std::sqrt(best.value)};
}

Eigen::Vector3d MeshParts::normal(std::size_t part) const
{
    const Eigen::Vector3d a = corner(part, 0), ab = corner(part, 1) - a, ac = corner(part, 2) - a;
    return planar_ ? Eigen::Vector3d(-ab.y(), ab.x(), 0) : ab.cross(ac);
}

Eigen::Vector3d MeshParts::normal_towards(std::size_t part, const Eigen::Vector3d& p) const
{
    const Eigen::Vector3d unit = normal(part).normalized();
    return unit.dot(p - corner(part, 0)) < 0 ? -unit : unit;
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
    if (planar_)
        return {{a, b - a}, {b, a - b}};
    const Eigen::Vector3d up = normal(part);
    if (up.isZero(0))
        return {};
    return {{a, up.cross(b - a)}, {b, up.cross(c - b)}, {c, up.cross(a - c)}};
}

} // namespace morph
