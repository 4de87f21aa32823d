#include "libmorph/geometry/edge_crossing.h"

#include "libmorph/core/predicates.h"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace morph {

namespace {

using Box = CGAL::Box_intersection_d::Box_d<double, 2, CGAL::Box_intersection_d::ID_EXPLICIT>;

/// A box with the number of its edge.
class EdgeBox : public Box {
public:
    EdgeBox(PlanePoint a, PlanePoint b, Index edge) : edge_(edge)
    {
        extend(std::array{a.x, a.y}.data());
        extend(std::array{b.x, b.y}.data());
    }
    Index edge() const { return edge_; }

private:
    Index edge_;
};

struct Segment {
    std::array<Index, 2> vertices;
    PlanePoint a, b;
};

/// c, on the line through a and b, lies between them or on one of them.
bool lies_between(PlanePoint a, PlanePoint b, PlanePoint c)
{
    return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
           c.y <= std::max(a.y, b.y);
}

/// Two segments without a common vertex have a common point.
bool meet(const Segment& s, const Segment& t)
{
    const int a = orientation(s.a, s.b, t.a), b = orientation(s.a, s.b, t.b);
    const int c = orientation(t.a, t.b, s.a), d = orientation(t.a, t.b, s.b);
    if (a * b < 0 && c * d < 0)
        return true;
    return (a == 0 && lies_between(s.a, s.b, t.a)) || (b == 0 && lies_between(s.a, s.b, t.b)) ||
           (c == 0 && lies_between(t.a, t.b, s.a)) || (d == 0 && lies_between(t.a, t.b, s.b));
}

/// Two segments from a common vertex go the same way.
bool overlap(PlanePoint common, PlanePoint b, PlanePoint c)
{
    return orientation(common, b, c) == 0 && (lies_between(common, b, c) || lies_between(common, c, b));
}

bool clash(const Segment& s, const Segment& t)
{
    const std::array<PlanePoint, 2> of_s{s.a, s.b};
    const std::array<PlanePoint, 2> of_t{t.a, t.b};
    int shared = 0;
    bool overlapping = false;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            if (s.vertices[i] == t.vertices[j]) {
                ++shared;
                overlapping = overlap(of_s[i], of_s[1 - i], of_t[1 - j]);
            }
    return shared == 0 ? meet(s, t) : shared == 1 && overlapping;
}

/// A point of both segments, to rounding.
Eigen::Vector2d meeting_point(const Segment& s, const Segment& t)
{
    const Eigen::Vector2d a(s.a.x, s.a.y), along(s.b.x - s.a.x, s.b.y - s.a.y);
    const Eigen::Vector2d c(t.a.x, t.a.y), other(t.b.x - t.a.x, t.b.y - t.a.y);
    const double cross = along.x() * other.y() - along.y() * other.x();
    if (cross == 0)
        return (a + c) / 2 + (along + other) / 4;
    const Eigen::Vector2d between = c - a;
    const double share = (between.x() * other.y() - between.y() * other.x()) / cross;
    return a + std::clamp(share, 0.0, 1.0) * along;
}

} // namespace

std::optional<EdgeCrossing> find_edge_crossing(const Eigen::Ref<const Points>& points,
                                               const std::vector<std::array<Index, 2>>& edges)
{
    std::vector<Segment> segments;
    std::vector<EdgeBox> boxes;
    for (const std::array<Index, 2>& edge : edges) {
        const PlanePoint a{points(edge[0], 0), points(edge[0], 1)};
        const PlanePoint b{points(edge[1], 0), points(edge[1], 1)};
        boxes.emplace_back(a, b, static_cast<Index>(segments.size()));
        segments.push_back({edge, a, b});
    }
    std::optional<std::array<Index, 2>> first;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const EdgeBox& one, const EdgeBox& other) {
        const std::array<Index, 2> pair{std::min(one.edge(), other.edge()),
                                        std::max(one.edge(), other.edge())};
        if (first && *first <= pair)
            return;
        if (clash(segments[static_cast<std::size_t>(pair[0])], segments[static_cast<std::size_t>(pair[1])]))
            first = pair;
    });
    if (!first)
        return std::nullopt;
    return EdgeCrossing{*first, meeting_point(segments[static_cast<std::size_t>((*first)[0])],
                                              segments[static_cast<std::size_t>((*first)[1])])};
}

} // namespace morph
