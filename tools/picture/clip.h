#pragma once

#include "tools/picture/canvas.h"

#include <optional>
#include <vector>

namespace morph::picture {

/// Whether the bounding box of the corners touches the area.
bool touches(std::span<const Pixel> corners, const Rectangle& area);

/// The part of a polygon inside the area [Sutherland and Hodgman 1974, Communications of the ACM 17, 32-42].
/// Keeps coordinates far outside the paper, which cairo cannot hold, away from it.
std::vector<Pixel> clipped(std::span<const Pixel> corners, const Rectangle& area);

/// The part of a segment inside the area, if any.
std::optional<Segment> clipped(const Segment& segment, const Rectangle& area);

/// The area made larger by @p margin all around.
Rectangle grown(const Rectangle& area, double margin);

} // namespace morph::picture
