#include "libmorph/remesh/remesh_state.h"

#include "libmorph/core/predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

PlanePoint in_plane(const Eigen::Vector3d& p)
{
    return {p.x(), p.y()};
}

} // namespace

double triangle_quality(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        bool planar)
{
    constexpr double kScale = 2 * 1.7320508075688772; // 4 sqrt(3) area, of twice the area
    const Eigen::Vector3d ab = b - a, ac = c - a, bc = c - b;
    const double sides = ab.squaredNorm() + ac.squaredNorm() + bc.squaredNorm();
    const double area2 = planar ? ab.x() * ac.y() - ab.y() * ac.x() : ab.cross(ac).norm();
    return sides > 0 ? kScale * area2 / sides : 0;
}

double triangle_quality(const RemeshState& state, Index t)
{
    const CornerTable& table = state.table;
    return triangle_quality(table.point(table.corner(t, 0)), table.point(table.corner(t, 1)),
                            table.point(table.corner(t, 2)), state.planar);
}

double relative_length(const CornerTable& table, Index a, Index b)
{
    const TableVertex &p = table.vertices[at(a)], &q = table.vertices[at(b)];
    return 2 * (p.point - q.point).norm() / (p.size + q.size);
}

Eigen::Vector3d triangle_normal(const RemeshState& state, Index t)
{
    if (state.planar)
        return Eigen::Vector3d::Zero();
    const CornerTable& table = state.table;
    const Eigen::Vector3d& a = table.point(table.corner(t, 0));
    return (table.point(table.corner(t, 1)) - a).cross(table.point(table.corner(t, 2)) - a);
}

Eigen::Vector3d surface_normal(const RemeshState& state, Index t)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    if (state.planar)
        return sum;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (const TableVertex& vertex = state.table.vertices[at(state.table.from[at(h)])];
            vertex.curve == kFreeVertex)
            sum += state.background.normal(vertex.below);
    return sum.isZero(0) ? triangle_normal(state, t).normalized() : sum.normalized();
}

bool may_replace(const RemeshState& state, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c, const Eigen::Vector3d& surface)
{
    constexpr double kCosine = 0.5;
    if (state.planar)
        return orientation(in_plane(a), in_plane(b), in_plane(c)) > 0;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 && normal.dot(surface) >= kCosine * length;
}

std::array<double, 2> edge_parameters(const RemeshState& state, Index h)
{
    const CornerTable& table = state.table;
    const Index mark = table.tag[at(h)], curve = mark / 2;
    const bool against = mark % 2 == 1;
    const FeatureCurve& line = state.curves[at(curve)];
    const TableVertex& first = table.vertices[at(against ? table.to(h) : table.from[at(h)])];
    const TableVertex& last = table.vertices[at(against ? table.from[at(h)] : table.to(h))];
    const double low = first.curve == curve ? first.u : line.begin();
    double high = last.curve == curve ? last.u : line.end();
    if (high <= low && line.closed())
        high += line.period();
    return against ? std::array{high, low} : std::array{low, high};
}

double star_quality(const RemeshState& state, Index vertex, const Eigen::Vector3d& point)
{
    const CornerTable& table = state.table;
    double worst = 1;
    table.around(vertex, [&](Index h) {
        if (worst < 0)
            return;
        const Eigen::Vector3d &b = table.point(table.to(h)), &c = table.point(table.apex(h));
        worst = may_replace(state, point, b, c, surface_normal(state, h / 3))
                    ? std::min(worst, triangle_quality(point, b, c, state.planar))
                    : -1;
    });
    return worst;
}

void put_at(const RemeshState& state, TableVertex& vertex, const Eigen::Vector3d& point)
{
    const BackgroundMesh::Place place = state.background.find(point, vertex.below);
    vertex.point = place.point;
    vertex.size = place.size;
    vertex.below = place.triangle;
}

void put_on_curve(const RemeshState& state, TableVertex& vertex, Index curve, double u)
{
    const FeatureCurve& line = state.curves[at(curve)];
    vertex.curve = curve;
    vertex.u = line.closed() ? u - std::floor((u - line.begin()) / line.period()) * line.period() : u;
    vertex.point = line.point(u);
    const BackgroundMesh::Place place = state.background.find(vertex.point, vertex.below);
    vertex.size = place.size;
    vertex.below = place.triangle;
}

} // namespace morph
