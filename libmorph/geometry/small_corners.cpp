#include "libmorph/geometry/small_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morph {

namespace {

/// Angle at @p x from the direction of @p from counter-clockwise to that of @p to, in [0, 2 pi).
double angle_between(const Eigen::Vector2d& from, const Eigen::Vector2d& x, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d a = from - x;
    const Eigen::Vector2d b = to - x;
    const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

} // namespace

SmallCorners::SmallCorners(const std::vector<OutlineLoop>& loops)
{
    for (const OutlineLoop& loop : loops) {
        const std::size_t n = loop.nodes.size();
        std::vector<bool> small(n);
        // The domain is inside the box, outside the curves.
        const bool domain_left = loop.counter_clockwise == loop.is_box;
        for (std::size_t i = 0; i < n; ++i) {
            const Eigen::Vector2d& before = loop.nodes[(i + n - 1) % n].point;
            const Eigen::Vector2d& here = loop.nodes[i].point;
            const Eigen::Vector2d& after = loop.nodes[(i + 1) % n].point;
            const double angle =
                domain_left ? angle_between(after, here, before) : angle_between(before, here, after);
            small[i] = angle < kSmallCorner * std::numbers::pi / 180;
            if (small[i])
                discs_.push_back({here, std::max((before - here).norm(), (after - here).norm())});
        }
        small_.push_back(std::move(small));
    }
}

bool SmallCorners::is_small(Index loop, BoundaryPlace place) const
{
    return place.value >= 0 && place.value % 2 == 0 && small_[loop][place.value / 2];
}

bool SmallCorners::between(Index loop, BoundaryPlace a, BoundaryPlace b) const
{
    const auto places = static_cast<Index>(2 * small_[loop].size());
    const auto along = [places](Index from, Index to) { return (to - from + places) % places; };
    for (Index corner = a.value - 2; corner <= a.value + 2; ++corner) {
        const Index c = (corner + places) % places;
        if (!is_small(loop, {c}))
            continue;
        const Index past_a = along(c, a.value);
        const Index past_b = along(c, b.value);
        const bool a_after = past_a == 1 || past_a == 2;
        const bool b_after = past_b == 1 || past_b == 2;
        const bool a_before = past_a >= places - 2;
        const bool b_before = past_b >= places - 2;
        if ((a_after && b_before) || (a_before && b_after))
            return true;
    }
    return false;
}

} // namespace morph
