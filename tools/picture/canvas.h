#pragma once

#include "tools/picture/colour.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace morph::picture {

/// A place on the canvas, y downwards.
struct Pixel {
    double x = 0;
    double y = 0;
};

using Segment = std::array<Pixel, 2>;

struct Rectangle {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
};

enum class Align { left, centre, right };

struct TextStyle {
    double size = 12;
    Colour colour = kInk;
    Align align = Align::left;
    bool bold = false;
};

enum class ImageKind { png, svg };

/// Draws the same strokes, fills and text into a PNG or an SVG image in memory.
///
/// Lengths are in layout units; @p scale of them make a pixel (PNG) or a point (SVG).
class Canvas {
public:
    Canvas(ImageKind kind, double width, double height, double scale);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    ImageKind kind() const;
    double scale() const;

    /// Without smoothing in a PNG, so that no seam shows between neighbours; all pixels get covered once.
    void fill_tile(std::span<const Pixel> corners, const Colour& colour);
    /// Smoothed.
    void fill_shape(std::span<const Pixel> corners, const Colour& colour);
    /// The area inside an odd number of loops, smoothed.
    void fill_loops(std::span<const std::vector<Pixel>> loops, const Colour& colour);
    void fill(const Rectangle& area, const Colour& colour);
    void outline(const Rectangle& area, double width, const Colour& colour);
    void stroke(std::span<const Segment> segments, double width, const Colour& colour);
    void stroke_loop(std::span<const Pixel> corners, double width, const Colour& colour);
    void ring(const Pixel& centre, double radius, double width, const Colour& colour);

    /// Baseline at @p place. Bytes that are no UTF-8 are shown as '?'.
    void text(const Pixel& place, const std::string& words, const TextStyle& style);
    double text_width(const std::string& words, const TextStyle& style);
    /// The words, shortened with an ellipsis to fit into @p width.
    std::string fitted(const std::string& words, const TextStyle& style, double width);

    /// Draw only inside @p area until unclip().
    void clip(const Rectangle& area);
    void unclip();

    /// The finished image file.
    /// @throws SolverError  the image could not be made (out of memory)
    std::string finish();

private:
    struct Implementation;
    std::unique_ptr<Implementation> cairo_;
};

} // namespace morph::picture
