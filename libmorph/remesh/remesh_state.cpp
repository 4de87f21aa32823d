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

double triangle_quality(const RemeshState& made, Index t)
{
    const CornerTable& net = made.net;
    return triangle_quality(net.point(net.from[at(3 * t)]), net.point(net.from[at(3 * t + 1)]),
                            net.point(net.from[at(3 * t + 2)]), made.planar);
}

double relative_length(const CornerTable& net, Index a, Index b)
{
    const TableVertex &p = net.vertices[at(a)], &q = net.vertices[at(b)];
    return 2 * (p.point - q.point).norm() / (p.size + q.size);
}

Eigen::Vector3d net_normal(const RemeshState& made, Index t)
{
    if (made.planar)
        return Eigen::Vector3d::Zero();
    const CornerTable& net = made.net;
    const Eigen::Vector3d& a = net.point(net.from[at(3 * t)]);
    return (net.point(net.from[at(3 * t + 1)]) - a).cross(net.point(net.from[at(3 * t + 2)]) - a);
}

Eigen::Vector3d surface_normal(const RemeshState& made, Index t)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    if (made.planar)
        return sum;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (const TableVertex& vertex = made.net.vertices[at(made.net.from[at(h)])];
            vertex.curve == kFreeVertex)
            sum += made.underlay.normal(vertex.below);
    return sum.isZero(0) ? net_normal(made, t).normalized() : sum.normalized();
}

bool may_replace(const RemeshState& made, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c, const Eigen::Vector3d& surface)
{
    constexpr double kCosine = 0.5;
    if (made.planar)
        return orientation(in_plane(a), in_plane(b), in_plane(c)) > 0;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 && normal.dot(surface) >= kCosine * length;
}

std::array<double, 2> edge_parameters(const RemeshState& made, Index h)
{
    const CornerTable& net = made.net;
    const Index mark = net.tag[at(h)], curve = mark / 2;
    const bool against = mark % 2 == 1;
    const FeatureCurve& line = made.curves[at(curve)];
    const TableVertex& first = net.vertices[at(against ? net.to(h) : net.from[at(h)])];
    const TableVertex& last = net.vertices[at(against ? net.from[at(h)] : net.to(h))];
    const double low = first.curve == curve ? first.u : line.begin();
    double high = last.curve == curve ? last.u : line.end();
    if (high <= low && line.closed())
        high += line.period();
    return against ? std::array{high, low} : std::array{low, high};
}

double star_quality(const RemeshState& made, Index vertex, const Eigen::Vector3d& point)
{
    const CornerTable& net = made.net;
    double worst = 1;
    net.around(vertex, [&](Index h) {
        if (worst < 0)
            return;
        const Eigen::Vector3d &b = net.point(net.to(h)), &c = net.point(net.apex(h));
        worst = may_replace(made, point, b, c, surface_normal(made, h / 3))
                    ? std::min(worst, triangle_quality(point, b, c, made.planar))
                    : -1;
    });
    return worst;
}

void place_free(const RemeshState& made, TableVertex& vertex, const Eigen::Vector3d& point)
{
    const BackgroundMesh::Place place = made.underlay.find(point, vertex.below);
    vertex.point = place.point;
    vertex.size = place.size;
    vertex.below = place.triangle;
}

void parametrize_marker(const RemeshState& made, TableVertex& vertex, Index curve, double u)
{
    const FeatureCurve& line = made.curves[at(curve)];
    vertex.curve = curve;
    vertex.u = line.closed() ? u - std::floor((u - line.begin()) / line.period()) * line.period() : u;
    vertex.point = line.point(u);
    const BackgroundMesh::Place place = made.underlay.find(vertex.point, vertex.below);
    vertex.size = place.size;
    vertex.below = place.triangle;
}

} // namespace morph
