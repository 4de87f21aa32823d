#include "libmorph/core/space_curve.h"

#include <algorithm>
#include <numeric>

namespace morph {

std::vector<Index> hilbert_order(const Points& points, int)
{
    std::vector<Index> order(static_cast<std::size_t>(points.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return points(a, 0) < points(b, 0); });
    return order;
}

} // namespace morph
