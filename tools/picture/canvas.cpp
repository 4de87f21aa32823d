#include "tools/picture/canvas.h"

#include "libmorph/core/error.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <numbers>

namespace morph::picture {

namespace {

constexpr const char* kFont = "DejaVu Sans"; // what fontconfig brings along on Debian; others fall back

cairo_status_t collect(void* bytes, const unsigned char* data, unsigned int length)
{
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

/// Length of the UTF-8 character at @p at, 0 if there is none.
std::size_t character_length(const std::string& text, std::size_t at)
{
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const unsigned first = byte(at);
    if (first < 0x80)
        return first >= 0x20 && first != 0x7f ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4)
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xc0U) != 0x80U)
            return 0;
    const unsigned second = byte(at + 1);
    const bool forbidden = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                           (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return forbidden ? 0 : length;
}

/// cairo stops drawing for good at the first byte that is no UTF-8.
std::string printable(const std::string& text)
{
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text, at);
        clean += length == 0 ? "?" : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return clean;
}

} // namespace

struct Canvas::Implementation {
    ImageKind kind = ImageKind::png;
    double scale = 1;
    std::string bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* context = nullptr;

    ~Implementation()
    {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }

    void use(const Colour& colour) const
    {
        cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.alpha);
    }

    void trace(std::span<const Pixel> corners) const
    {
        for (const Pixel& p : corners)
            cairo_line_to(context, p.x, p.y);
        cairo_close_path(context);
    }

    void use(const TextStyle& style) const
    {
        cairo_select_font_face(context, kFont, CAIRO_FONT_SLANT_NORMAL,
                               style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context, style.size);
        use(style.colour);
    }
};

Canvas::Canvas(ImageKind kind, double width, double height, double scale)
    : cairo_(std::make_unique<Implementation>())
{
    const double w = std::round(width * scale);
    const double h = std::round(height * scale);
    cairo_->kind = kind;
    cairo_->scale = scale;
    cairo_->surface =
        kind == ImageKind::png
            ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(w), static_cast<int>(h))
            : cairo_svg_surface_create_for_stream(collect, &cairo_->bytes, w, h);
    cairo_->context = cairo_create(cairo_->surface);
    cairo_scale(cairo_->context, scale, scale);
    cairo_set_line_join(cairo_->context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_->context, CAIRO_LINE_CAP_ROUND);
    fill({0, 0, width + 1, height + 1}, kPaper);
}

Canvas::~Canvas() = default;

ImageKind Canvas::kind() const
{
    return cairo_->kind;
}

double Canvas::scale() const
{
    return cairo_->scale;
}

void Canvas::fill_tile(std::span<const Pixel> corners, const Colour& colour)
{
    cairo_t* c = cairo_->context;
    cairo_->use(colour);
    cairo_->trace(corners);
    if (cairo_->kind == ImageKind::png) {
        cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
        cairo_fill(c);
        cairo_set_antialias(c, CAIRO_ANTIALIAS_DEFAULT);
        return;
    }
    cairo_fill_preserve(c); // viewers smooth every tile: a hairline of its colour closes the seams
    cairo_set_line_width(c, 0.3);
    cairo_stroke(c);
}

void Canvas::fill_shape(std::span<const Pixel> corners, const Colour& colour)
{
    cairo_->use(colour);
    cairo_->trace(corners);
    cairo_fill(cairo_->context);
}

void Canvas::fill_loops(std::span<const std::vector<Pixel>> loops, const Colour& colour)
{
    cairo_->use(colour);
    for (const auto& loop : loops) {
        cairo_new_sub_path(cairo_->context);
        cairo_->trace(loop);
    }
    cairo_set_fill_rule(cairo_->context, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(cairo_->context);
    cairo_set_fill_rule(cairo_->context, CAIRO_FILL_RULE_WINDING);
}

void Canvas::fill(const Rectangle& area, const Colour& colour)
{
    cairo_->use(colour);
    cairo_rectangle(cairo_->context, area.x, area.y, area.width, area.height);
    cairo_fill(cairo_->context);
}

void Canvas::outline(const Rectangle& area, double width, const Colour& colour)
{
    cairo_->use(colour);
    cairo_set_line_width(cairo_->context, width);
    cairo_rectangle(cairo_->context, area.x, area.y, area.width, area.height);
    cairo_stroke(cairo_->context);
}

void Canvas::stroke(std::span<const Segment> segments, double width, const Colour& colour)
{
    cairo_->use(colour);
    cairo_set_line_width(cairo_->context, width);
    for (const Segment& segment : segments) {
        cairo_move_to(cairo_->context, segment[0].x, segment[0].y);
        cairo_line_to(cairo_->context, segment[1].x, segment[1].y);
    }
    cairo_stroke(cairo_->context);
}

void Canvas::stroke_loop(std::span<const Pixel> corners, double width, const Colour& colour)
{
    cairo_->use(colour);
    cairo_set_line_width(cairo_->context, width);
    cairo_->trace(corners);
    cairo_stroke(cairo_->context);
}

void Canvas::ring(const Pixel& centre, double radius, double width, const Colour& colour)
{
    cairo_->use(colour);
    cairo_set_line_width(cairo_->context, width);
    cairo_new_sub_path(cairo_->context);
    cairo_arc(cairo_->context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(cairo_->context);
}

void Canvas::text(const Pixel& place, const std::string& words, const TextStyle& style)
{
    const double shift = style.align == Align::left ? 0 : style.align == Align::centre ? 0.5 : 1;
    const double width = shift > 0 ? text_width(words, style) : 0;
    cairo_->use(style);
    cairo_move_to(cairo_->context, place.x - shift * width, place.y);
    cairo_show_text(cairo_->context, printable(words).c_str());
    cairo_new_path(cairo_->context);
}

double Canvas::text_width(const std::string& words, const TextStyle& style)
{
    cairo_text_extents_t extents;
    cairo_->use(style);
    cairo_text_extents(cairo_->context, printable(words).c_str(), &extents);
    return extents.x_advance;
}

std::string Canvas::fitted(const std::string& words, const TextStyle& style, double width)
{
    if (text_width(words, style) <= width)
        return words;
    std::string shorter = printable(words);
    while (!shorter.empty() && text_width(shorter + "\u2026", style) > width) {
        while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xc0U) == 0x80U)
            shorter.pop_back();
        if (!shorter.empty())
            shorter.pop_back();
    }
    return shorter + "\u2026";
}

void Canvas::clip(const Rectangle& area)
{
    cairo_save(cairo_->context);
    cairo_rectangle(cairo_->context, area.x, area.y, area.width, area.height);
    cairo_clip(cairo_->context);
}

void Canvas::unclip()
{
    cairo_restore(cairo_->context);
}

std::string Canvas::finish()
{
    cairo_status_t status = cairo_status(cairo_->context);
    if (status == CAIRO_STATUS_SUCCESS && cairo_->kind == ImageKind::png)
        status = cairo_surface_write_to_png_stream(cairo_->surface, collect, &cairo_->bytes);
    cairo_surface_finish(cairo_->surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(cairo_->surface);
    if (status != CAIRO_STATUS_SUCCESS)
        throw SolverError(std::string("the picture could not be made: ") + cairo_status_to_string(status));
    return std::move(cairo_->bytes);
}

} // namespace morph::picture
