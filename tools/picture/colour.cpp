#include "tools/picture/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morph::picture {

namespace {

constexpr Colour rgb(int red, int green, int blue)
{
    return {red / 255.0, green / 255.0, blue / 255.0};
}

constexpr std::array<Colour, 9> kMap{rgb(68, 1, 84),    rgb(71, 44, 122),  rgb(59, 81, 139),
                                     rgb(44, 113, 142), rgb(33, 144, 141), rgb(39, 173, 129),
                                     rgb(92, 200, 99),  rgb(170, 220, 50), rgb(253, 231, 37)};

constexpr std::array<Colour, 8> kMarkers{rgb(0, 90, 170),   rgb(230, 145, 0),  rgb(0, 145, 105),
                                         rgb(190, 95, 155), rgb(70, 165, 220), rgb(120, 85, 30),
                                         rgb(115, 75, 175), rgb(105, 115, 125)};

} // namespace

Colour mixed(const Colour& from, const Colour& to, double fraction)
{
    const auto mix = [fraction](double a, double b) { return a + fraction * (b - a); };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue),
            mix(from.alpha, to.alpha)};
}

Colour with_alpha(Colour colour, double alpha)
{
    colour.alpha = alpha;
    return colour;
}

Colour colour_of(double value)
{
    const double place = std::clamp(value, 0.0, 1.0) * (kMap.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kMap.size() - 2);
    return mixed(kMap[below], kMap[below + 1], place - static_cast<double>(below));
}

Colour marker_colour(std::size_t number)
{
    return kMarkers[number % kMarkers.size()];
}

} // namespace morph::picture
