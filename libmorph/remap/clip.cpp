#include "libmorph/remap/clip.h"

namespace morph {

namespace {

PlanePoint difference(PlanePoint a, PlanePoint b)
{
    return {a.x - b.x, a.y - b.y};
}

/// Four times the signed area of triangle a b p: positive to the left of a b. Exactly the negative of that of
/// b a p, and exactly 0 where p is a or b.
double left_of(PlanePoint a, PlanePoint b, PlanePoint p)
{
    return (b.x - a.x) * ((p.y - a.y) + (p.y - b.y)) - (b.y - a.y) * ((p.x - a.x) + (p.x - b.x));
}

/// Where a segment crosses the line that its ends have these distances of opposite signs from.
PlanePoint crossing(PlanePoint p, double p_distance, PlanePoint q, double q_distance)
{
    const double t = p_distance / (p_distance - q_distance);
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

ConvexPolygon relative_to(PlanePoint origin, const ConvexPolygon& polygon)
{
    ConvexPolygon shifted = polygon;
    for (int k = 0; k < polygon.corners; ++k)
        shifted.corner[static_cast<std::size_t>(k)] = difference(polygon[k], origin);
    return shifted;
}

/// Where a polygon lies relative to a line.
struct Extent {
    bool left = false;
    bool right = false;
};

Extent extent(const ConvexPolygon& polygon, PlanePoint a, PlanePoint b)
{
    Extent found;
    for (int k = 0; k < polygon.corners; ++k) {
        const double distance = left_of(a, b, polygon[k]);
        found.left |= distance > 0;
        found.right |= distance < 0;
    }
    return found;
}

/// The part of a polygon to the left of a line; the side that the line cuts gets a number.
ConvexPolygon left_part(const ConvexPolygon& polygon, PlanePoint a, PlanePoint b, int side)
{
    ConvexPolygon part;
    double here = left_of(a, b, polygon[0]);
    const double first = here;
    for (int k = 0; k < polygon.corners; ++k) {
        const double next = k + 1 < polygon.corners ? left_of(a, b, polygon[k + 1]) : first;
        const int own = polygon.side[static_cast<std::size_t>(k)];
        if (here >= 0)
            part.add(polygon[k], here == 0 && next < 0 ? side : own);
        if (here > 0 && next < 0)
            part.add(crossing(polygon[k], here, polygon.after(k), next), side);
        if (here < 0 && next > 0)
            part.add(crossing(polygon[k], here, polygon.after(k), next), own);
        here = next;
    }
    return part;
}

} // namespace

// Two polygons of 4 corners have at most 8 in common. Where rounding makes one more it lies on a side, and
// leaving it out changes nothing beyond rounding.
void ConvexPolygon::add(PlanePoint p, int side_number)
{
    if (corners == kMaxCorners)
        return;
    corner[static_cast<std::size_t>(corners)] = p;
    side[static_cast<std::size_t>(corners)] = side_number;
    ++corners;
}

ConvexPolygon clip(const ConvexPolygon& subject, const ConvexPolygon& clipper)
{
    const PlanePoint origin = subject[0];
    ConvexPolygon common = relative_to(origin, subject);
    const ConvexPolygon knife = relative_to(origin, clipper);
    std::array<bool, ConvexPolygon::kMaxCorners> cuts{};
    for (int k = 0; k < knife.corners; ++k) {
        const Extent found = extent(common, knife[k], knife.after(k));
        if (!found.left)
            return {};
        cuts[static_cast<std::size_t>(k)] = found.right;
    }
    for (int k = 0; k < knife.corners; ++k)
        if (cuts[static_cast<std::size_t>(k)]) {
            common = left_part(common, knife[k], knife.after(k), knife.side[static_cast<std::size_t>(k)]);
            if (common.corners < 3)
                return {};
        }
    return common;
}

double area(const ConvexPolygon& polygon)
{
    double twice = 0;
    for (int k = 2; k < polygon.corners; ++k) {
        const PlanePoint a = difference(polygon[k - 1], polygon[0]), b = difference(polygon[k], polygon[0]);
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

} // namespace morph
