#include "tools/picture/element_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morph::picture {

namespace {

/// A point with the value there.
struct Sample {
    Pixel at;
    double value = 0;
};

Sample blend(const Sample& a, const Sample& b, double fraction)
{
    return {{a.at.x + fraction * (b.at.x - a.at.x), a.at.y + fraction * (b.at.y - a.at.y)},
            a.value + fraction * (b.value - a.value)};
}

void draw_tile(std::initializer_list<Sample> corners,
               const std::function<void(std::span<const Pixel>, double)>& draw)
{
    std::array<Pixel, 4> pixels;
    std::size_t count = 0;
    double sum = 0;
    for (const Sample& s : corners) {
        pixels[count++] = s.at;
        sum += s.value;
    }
    draw({pixels.data(), count}, sum / static_cast<double>(count));
}

} // namespace

int tile_steps(std::span<const double> corner_values, double longest_side, int most)
{
    constexpr double kColourSteps = 40; // a fortieth of the range is hardly seen
    constexpr double kSmallest = 2;     // canvas units
    const auto [low, high] = std::minmax_element(corner_values.begin(), corner_values.end());
    const double wanted = std::min(std::ceil((*high - *low) * kColourSteps), longest_side / kSmallest);
    return wanted > 1 ? static_cast<int>(std::min<double>(wanted, std::max(most, 1))) : 1;
}

void for_each_tile(std::span<const Pixel> corners, std::span<const double> values, int steps,
                   const std::function<void(std::span<const Pixel>, double)>& draw)
{
    const auto corner = [&](std::size_t k) { return Sample{corners[k], values[k]}; };
    const bool quad = corners.size() == 4;
    // Row i of the grid runs from one side to the other; in a triangle it shrinks to the third corner.
    const auto sample = [&](int i, int j) {
        const double along = double(i) / steps;
        const Sample left = blend(corner(0), corner(quad ? 3 : 2), along);
        const Sample right = blend(corner(1), corner(2), along);
        const int cells = quad ? steps : steps - i;
        return blend(left, right, cells > 0 ? double(j) / cells : 0);
    };
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < (quad ? steps : steps - i); ++j) {
            if (quad) {
                draw_tile({sample(i, j), sample(i, j + 1), sample(i + 1, j + 1), sample(i + 1, j)}, draw);
                continue;
            }
            draw_tile({sample(i, j), sample(i, j + 1), sample(i + 1, j)}, draw);
            if (j + 1 < steps - i)
                draw_tile({sample(i, j + 1), sample(i + 1, j + 1), sample(i + 1, j)}, draw);
        }
}

} // namespace morph::picture
