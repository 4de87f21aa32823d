#pragma once

#include <cstddef>

namespace morph::picture {

/// Red, green, blue and opacity in [0, 1].
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
};

inline constexpr Colour kPaper{1, 1, 1};
inline constexpr Colour kInk{0.13, 0.16, 0.20};
inline constexpr Colour kFaintInk{0.42, 0.46, 0.52};
inline constexpr Colour kFrame{0.78, 0.80, 0.83};
inline constexpr Colour kElement{0.945, 0.955, 0.970};      ///< elements without a field
inline constexpr Colour kDenseElement{0.700, 0.735, 0.785}; ///< the same, too small for their edges to show
inline constexpr Colour kMeshEdge{0.30, 0.36, 0.45};
inline constexpr Colour kNoValue{0.80, 0.80, 0.80};     ///< where a field is not finite
inline constexpr Colour kInverted{0.878, 0.051, 0.102}; ///< nothing else in a picture is red

/// The first colour towards the second by @p fraction.
Colour mixed(const Colour& from, const Colour& to, double fraction);

Colour with_alpha(Colour colour, double alpha);

/// Colour of a value in [0, 1]: dark violet over green to yellow, even steps looking evenly different
/// (control colours of viridis, van der Walt and Smith 2015). Values outside are clamped.
Colour colour_of(double value);

/// Colour of the marker with this number; they repeat after eight. Distinct also to colour-blind readers
/// (after Okabe and Ito 2008, its red left out).
Colour marker_colour(std::size_t number);

} // namespace morph::picture
