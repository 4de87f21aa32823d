#include "libmorph/remap/clip.h"

#include <algorithm>

namespace morph {

namespace {

/// Twice the area of triangle a b p: positive when p lies to the left of the line from a to b.
double left_of(PlanePoint a, PlanePoint b, PlanePoint p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// What of a polygon lies to the left of the line from a to b.
void keep_left(const ConvexPolygon& polygon, PlanePoint a, PlanePoint b, ConvexPolygon& kept)
{
    kept.clear();
    const auto corners = polygon.corners();
    if (corners.empty())
        return;
    PlanePoint from = corners.back();
    double from_side = left_of(a, b, from);
    for (const PlanePoint to : corners) {
        const double to_side = left_of(a, b, to);
        if ((from_side < 0 && to_side > 0) || (from_side > 0 && to_side < 0)) {
            const double t = from_side / (from_side - to_side);
            kept.add({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        }
        if (to_side >= 0)
            kept.add(to);
        from = to;
        from_side = to_side;
    }
}

void add_part(const PlaneElement& element, PlanePoint origin, std::array<int, 4> corner, int corners,
              ElementParts& parts)
{
    const auto at = [&](int k) {
        return element.corner[static_cast<std::size_t>(corner[static_cast<std::size_t>(k)])];
    };
    int sign = 0; // of the first corner that is not straight: all of a convex part turn the same way
    for (int k = 0; k < corners && sign == 0; ++k)
        sign = orientation(at(k), at((k + 1) % corners), at((k + 2) % corners));
    if (sign == 0)
        return;
    if (sign < 0)
        std::reverse(corner.begin(), corner.begin() + corners);
    ElementPart& part = parts.part[static_cast<std::size_t>(parts.count++)];
    part.corner = corner;
    part.corners = corners;
    part.polygon.clear();
    for (int k = 0; k < corners; ++k)
        part.polygon.add({at(k).x - origin.x, at(k).y - origin.y});
}

} // namespace

double area(const ConvexPolygon& polygon)
{
    const auto corners = polygon.corners();
    double twice = 0;
    for (std::size_t k = 2; k < corners.size(); ++k)
        twice += left_of(corners[0], corners[k - 1], corners[k]);
    return twice / 2;
}

ConvexPolygon intersection(const ConvexPolygon& one, const ConvexPolygon& other)
{
    ConvexPolygon kept = one, next;
    const auto corners = other.corners();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        keep_left(kept, corners[k], corners[(k + 1) % corners.size()], next);
        kept = next;
    }
    return kept;
}

ElementParts parts_of(const PlaneElement& element, PlanePoint origin, Parts parts)
{
    ElementParts found;
    if (element.corners == 3) {
        add_part(element, origin, {0, 1, 2, -1}, 3, found);
        return found;
    }
    const bool convex = is_convex(element);
    if (convex && parts == Parts::convex) {
        add_part(element, origin, {0, 1, 2, 3}, 4, found);
        return found;
    }
    const Diagonal diagonal = convex ? Diagonal::first_third : inner_diagonal(element);
    for (const auto& half : halves(diagonal))
        add_part(element, origin, {half[0], half[1], half[2], -1}, 3, found);
    return found;
}

} // namespace morph
