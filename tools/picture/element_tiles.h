#pragma once

#include "tools/picture/canvas.h"

#include <functional>
#include <span>

namespace morph::picture {

/// How many tiles a side of an element needs for a nodal field to look smooth: as many as its values (in
/// units of the colour range) and its size on the canvas ask for, from 1 to @p most.
int tile_steps(std::span<const double> corner_values, double longest_side, int most);

/// Cut a triangle or quad into tiles and call draw(corners, value in the middle) for each; the value is
/// linear in a triangle, bilinear in a quad.
void for_each_tile(std::span<const Pixel> corners, std::span<const double> values, int steps,
                   const std::function<void(std::span<const Pixel>, double)>& draw);

} // namespace morph::picture
