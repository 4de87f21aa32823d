#include "libmorph/geometry/misplaced_loop.h"

#include "libmorph/core/predicates.h"

#include <algorithm>

namespace morph {

namespace {

PlanePoint place(const Eigen::Ref<const Points>& points, Index v)
{
    return {points(v, 0), points(v, 1)};
}

/// How often a loop winds around the points of the open edge from @p p to @p q that are nearest to p: other
/// than p, none of them is on a loop that the edge's own only touches.
int winding_beside(PlanePoint p, PlanePoint q, const Eigen::Ref<const Points>& points,
                   const std::vector<Index>& loop)
{
    const auto is_above = [&](PlanePoint a) { return a.y > p.y || (a.y == p.y && q.y <= p.y); };
    int winding = 0; // what crosses a ray to the left
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const PlanePoint a = place(points, loop[i]);
        const PlanePoint b = place(points, loop[(i + 1) % loop.size()]);
        const int upward = static_cast<int>(is_above(b)) - static_cast<int>(is_above(a));
        if (upward == 0)
            continue;
        const int side = orientation(a, b, p);
        if ((side != 0 ? side : orientation(a, b, q)) * upward < 0)
            winding -= upward;
    }
    return winding;
}

} // namespace

int loop_orientation(const Eigen::Ref<const Points>& points, const std::vector<Index>& loop)
{
    const auto leftmost = std::min_element(loop.begin(), loop.end(), [&](Index v, Index w) {
        return std::pair(points(v, 0), points(v, 1)) < std::pair(points(w, 0), points(w, 1));
    });
    const std::size_t n = loop.size(), i = static_cast<std::size_t>(leftmost - loop.begin());
    return orientation(place(points, loop[(i + n - 1) % n]), place(points, loop[i]),
                       place(points, loop[(i + 1) % n]));
}

std::optional<std::size_t> find_misplaced_loop(const Eigen::Ref<const Points>& points,
                                               const std::vector<std::vector<Index>>& loops)
{
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const PlanePoint p = place(points, loops[l][0]), q = place(points, loops[l][1]);
        int outside = 0; // windings of the boundary around points just outside of this loop
        for (const std::vector<Index>& other : loops)
            if (&other != &loops[l])
                outside += winding_beside(p, q, points, other);
        if (outside != (loop_orientation(points, loops[l]) > 0 ? 0 : 1))
            return l;
    }
    return std::nullopt;
}

} // namespace morph
