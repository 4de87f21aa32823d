#include "libmorph/remesh/background_mesh.h"

#include "libmorph/geometry/closest_on_triangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace morph {

namespace {

constexpr int kLongestWalk = 1000; // between places near each other some 3 steps are usual
constexpr int kWalkBeforeJump = 30;

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p)
{
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

std::array<Eigen::Vector3d, 3> corners(const CornerTable& table, Index t)
{
    return {table.point(table.corner(t, 0)), table.point(table.corner(t, 1)),
            table.point(table.corner(t, 2))};
}

} // namespace

double BackgroundMesh::size_at(Index t, const Eigen::Vector3d& p) const
{
    const auto c = corners(table_, t);
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
        const double share = planar_ ? std::max(cross(a, b, p), 0.0) : (a - p).cross(b - p).norm();
        sum += share;
        size += share * table_.vertices[at(table_.from[at(CornerTable::halfedge(t)) + k])].size;
    }
    return sum > 0 ? size / sum : table_.vertices[at(table_.corner(t, 0))].size;
}

bool BackgroundMesh::walk(const Eigen::Vector3d& p, Index& t, int longest) const
{
    Index came_from = -1;
    for (int step = 0; step < longest; ++step) {
        const auto c = corners(table_, t);
        Index onward = -1;
        bool at_border = false;
        for (std::size_t k = 0; k < 3 && onward < 0; ++k) {
            const Index beyond = table_.twin[at(CornerTable::halfedge(t)) + k];
            if ((beyond >= 0 && beyond / 3 == came_from) || cross(c[k], c[(k + 1) % 3], p) >= 0)
                continue;
            at_border = at_border || beyond < 0;
            onward = beyond < 0 ? -1 : beyond / 3;
        }
        if (onward < 0)
            return !at_border;
        came_from = t;
        t = onward;
    }
    return false;
}

BackgroundMesh::Place BackgroundMesh::find_in_plane(const Eigen::Vector3d& p, Index near) const
{
    Index t = near;
    if (!walk(p, t, jump_ ? kWalkBeforeJump : kLongestWalk) && jump_)
        if (const Index there = jump_(p); there >= 0)
            t = there;
    return {t, p, size_at(t, p)};
}

BackgroundMesh::Place BackgroundMesh::find_closest(const Eigen::Vector3d& p, Index near) const
{
    Index t = near;
    TrianglePoint best = closest_on_triangle(corners(table_, t), p);
    for (int step = 0; step < kLongestWalk; ++step) {
        const Index here = t;
        // Every triangle around a corner, so that no fan of thin ones stops the descent.
        for (int k = 0; k < 3; ++k)
            table_.around(table_.corner(here, k), [&](Index out) {
                const TrianglePoint found = closest_on_triangle(corners(table_, out / 3), p);
                if (found.distance2 < best.distance2) {
                    best = found;
                    t = out / 3;
                }
            });
        if (t == here)
            break;
    }
    return {t, best.point, size_at(t, best.point)};
}

BackgroundMesh::Place BackgroundMesh::find(const Eigen::Vector3d& point, Index near) const
{
    return planar_ ? find_in_plane(point, near) : find_closest(point, near);
}

void BackgroundMesh::find_normals(const std::vector<Index>& tag)
{
    constexpr int kRings = 2;
    normals_.clear();
    for (Index t = 0; t < table_.triangle_slots(); ++t) {
        const auto c = corners(table_, t);
        normals_.push_back((c[1] - c[0]).cross(c[2] - c[0]));
    }
    for (int ring = 0; ring < kRings; ++ring) {
        const std::vector<Eigen::Vector3d> before = normals_;
        for (std::size_t h = 0; h < tag.size(); ++h)
            if (tag[h] == kNoTag && table_.twin[h] >= 0)
                normals_[h / 3] += before[at(table_.twin[h] / 3)];
    }
    for (Eigen::Vector3d& normal : normals_)
        normal.normalize();
}

Eigen::Vector3d BackgroundMesh::normal(Index t) const
{
    return normals_.empty() ? Eigen::Vector3d::Zero() : normals_[at(t)];
}

} // namespace morph
