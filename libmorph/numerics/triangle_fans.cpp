#include "libmorph/numerics/triangle_fans.h"

#include <algorithm>
#include <numeric>

namespace morph {

namespace {

std::size_t corner_of(const Triangulation& triangulation, std::size_t t, Index vertex)
{
    const auto& corners = triangulation.corners[t];
    return 3 * t +
           static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

} // namespace

TriangleFans::TriangleFans(const Triangulation& triangulation) : of_corner_(3 * triangulation.corners.size())
{
    std::iota(of_corner_.begin(), of_corner_.end(),
              0); // a forest: each corner's parent, no later than itself
    for (std::size_t t = 0; t < triangulation.corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (const Index other = triangulation.neighbours[t][k]; other > static_cast<Index>(t))
                for (const std::size_t end : {(k + 1) % 3, (k + 2) % 3})
                    join(3 * t + end, corner_of(triangulation, static_cast<std::size_t>(other),
                                                triangulation.corners[t][end]));
    for (std::size_t c = 0; c < of_corner_.size(); ++c)
        of_corner_[c] = of_corner_[c] == c ? count_++ : of_corner_[of_corner_[c]];
}

std::size_t TriangleFans::root(std::size_t corner)
{
    while (of_corner_[corner] != corner)
        corner = of_corner_[corner] = of_corner_[of_corner_[corner]];
    return corner;
}

void TriangleFans::join(std::size_t a, std::size_t b)
{
    const std::size_t first = root(a), second = root(b);
    of_corner_[std::max(first, second)] = std::min(first, second);
}

} // namespace morph
