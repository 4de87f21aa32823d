#pragma once

#include "tools/picture/view.h"

#include <array>
#include <span>

namespace morph::picture {

/// Corners of an element on the canvas.
struct Outline {
    std::array<Pixel, 4> corner{};
    std::size_t count = 0;

    std::span<const Pixel> pixels() const { return {corner.data(), count}; }
};

Outline outline_of(const FlatMesh& flat, const View& view, Index face);

/// Where a vertex lies on the canvas.
inline Pixel place_of(const FlatMesh& flat, const View& view, Index vertex)
{
    return view.place(flat.place(vertex, 0), flat.place(vertex, 1));
}

double area_of(const Outline& outline);
double longest_side(const Outline& outline);

/// Faces of a surface from the farthest to the nearest.
std::vector<Index> far_to_near(const FlatMesh& flat, std::vector<Index> faces);

/// How bright a face of a surface is, in (0, 1]: 1 when it faces the reader.
double light_on(const FlatMesh& flat, Index face);

} // namespace morph::picture
