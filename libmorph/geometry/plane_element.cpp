#include "libmorph/geometry/plane_element.h"

#include <algorithm>

namespace morph {

namespace {

int corner_sign(const PlaneElement& quad, std::size_t k)
{
    return orientation(quad.corner[(k + 3) % 4], quad.corner[k], quad.corner[(k + 1) % 4]);
}

bool between(double a, double b, double c, double x)
{
    const auto [low, high] = std::minmax({a, b, c});
    return low <= x && x <= high;
}

} // namespace

PlaneElement plane_element(const Mesh& mesh, Index face)
{
    PlaneElement element{{}, 0};
    const HalfedgeHandle first = mesh.kernel.halfedge_handle(FaceHandle(face));
    HalfedgeHandle side = first;
    do {
        const auto& p = mesh.kernel.point(mesh.kernel.to_vertex_handle(side));
        element.corner[static_cast<std::size_t>(element.corners++)] = {p[0], p[1]};
        side = mesh.kernel.next_halfedge_handle(side);
    } while (side != first);
    return element;
}

std::array<std::array<int, 3>, 2> halves(Diagonal diagonal)
{
    if (diagonal == Diagonal::first_third)
        return {{{0, 1, 2}, {0, 2, 3}}};
    return {{{1, 2, 3}, {1, 3, 0}}};
}

Diagonal inner_diagonal(const PlaneElement& quad)
{
    // The halves 1 2 3 and 1 3 4 are the corners at 2 and 4, the others those at 3 and 1.
    const bool first = corner_sign(quad, 1) * corner_sign(quad, 3) >= 0;
    const bool second = corner_sign(quad, 0) * corner_sign(quad, 2) >= 0;
    return second && !first ? Diagonal::second_fourth : Diagonal::first_third;
}

bool is_convex(const PlaneElement& quad)
{
    const int sign = corner_sign(quad, 0);
    return sign != 0 && corner_sign(quad, 1) == sign && corner_sign(quad, 2) == sign &&
           corner_sign(quad, 3) == sign;
}

bool triangle_contains(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint p)
{
    const auto [low, high] = std::minmax({orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)});
    if (low < 0 && high > 0)
        return false;
    if (low != 0 || high != 0)
        return true;
    return between(a.x, b.x, c.x, p.x) && between(a.y, b.y, c.y, p.y); // all on one line
}

bool contains(const PlaneElement& element, PlanePoint p)
{
    const auto& [a, b, c, d] = element.corner;
    if (element.corners == 3)
        return triangle_contains(a, b, c, p);
    const auto [first, second] = halves(inner_diagonal(element));
    const auto half_contains = [&](const std::array<int, 3>& half) {
        const auto at = [&](std::size_t k) { return element.corner[static_cast<std::size_t>(half[k])]; };
        return triangle_contains(at(0), at(1), at(2), p);
    };
    return half_contains(first) || half_contains(second);
}

} // namespace morph
