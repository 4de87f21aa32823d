#include "tools/picture/clip.h"

#include <algorithm>
#include <array>

namespace morph::picture {

namespace {

/// Signed distances to the four sides of the area, positive inside.
std::array<double, 4> inside(const Pixel& p, const Rectangle& area)
{
    return {p.x - area.x, area.x + area.width - p.x, p.y - area.y, area.y + area.height - p.y};
}

Pixel between(const Pixel& a, const Pixel& b, double fraction)
{
    return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y)};
}

} // namespace

bool touches(std::span<const Pixel> corners, const Rectangle& area)
{
    const auto [left, right] = std::minmax_element(corners.begin(), corners.end(),
                                                   [](const Pixel& a, const Pixel& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(),
                                                   [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
    return right->x >= area.x && left->x <= area.x + area.width && bottom->y >= area.y &&
           top->y <= area.y + area.height;
}

std::vector<Pixel> clipped(std::span<const Pixel> corners, const Rectangle& area)
{
    std::vector<Pixel> polygon(corners.begin(), corners.end());
    for (std::size_t side = 0; side < 4; ++side) {
        std::vector<Pixel> kept;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Pixel& from = polygon[k];
            const Pixel& to = polygon[(k + 1) % polygon.size()];
            const double a = inside(from, area)[side];
            const double b = inside(to, area)[side];
            if (a >= 0)
                kept.push_back(from);
            if ((a >= 0) != (b >= 0))
                kept.push_back(between(from, to, a / (a - b)));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

std::optional<Segment> clipped(const Segment& segment, const Rectangle& area)
{
    const auto from = inside(segment[0], area);
    const auto to = inside(segment[1], area);
    double first = 0;
    double last = 1;
    for (std::size_t side = 0; side < 4; ++side) {
        if (from[side] < 0 && to[side] < 0)
            return std::nullopt;
        if (from[side] < 0)
            first = std::max(first, from[side] / (from[side] - to[side]));
        else if (to[side] < 0)
            last = std::min(last, from[side] / (from[side] - to[side]));
    }
    if (first > last)
        return std::nullopt;
    return Segment{between(segment[0], segment[1], first), between(segment[0], segment[1], last)};
}

Rectangle grown(const Rectangle& area, double margin)
{
    return {area.x - margin, area.y - margin, area.width + 2 * margin, area.height + 2 * margin};
}

} // namespace morph::picture
