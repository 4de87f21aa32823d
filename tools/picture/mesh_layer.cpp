#include "tools/picture/mesh_layer.h"

#include "libmorph/core/error.h"
#include "tools/picture/clip.h"
#include "tools/picture/element_tiles.h"
#include "tools/picture/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace morph::picture {

namespace {

constexpr double kEdgeWidth = 0.5;
constexpr double kMarkerWidth = 1.8;
constexpr std::size_t kSvgElements = 200000;
constexpr std::size_t kFadeSteps = 8; // edges of like opacity are stroked together

constexpr double kOffPaper = 50; // canvas units beyond the view that are still drawn

/// A few hundred at a time: cairo slows down on long paths.
void stroke_in_parts(Canvas& canvas, std::span<const Segment> segments, double width, const Colour& colour)
{
    constexpr std::size_t kTogether = 500;
    for (std::size_t begin = 0; begin < segments.size(); begin += kTogether)
        canvas.stroke(segments.subspan(begin, std::min(kTogether, segments.size() - begin)), width, colour);
}

Colour colour_of_marker(const std::vector<std::string>& names, const std::string& name)
{
    const auto found = std::find(names.begin(), names.end(), name);
    return marker_colour(static_cast<std::size_t>(found - names.begin()));
}

/// Draws one mesh into one view; keeps what its passes share.
class MeshPainter {
public:
    MeshPainter(Canvas& canvas, const View& view, const FlatMesh& flat, const MeshStyle& style)
        : canvas_(canvas), view_(view), flat_(flat), style_(style), paper_(grown(view.area, kOffPaper))
    {
        find_visible();
    }

    void paint(const std::vector<Index>& inverted)
    {
        if (flat_.mesh->dimension == 2) {
            for (const Index f : visible_)
                fill(f, 1);
            if (style_.edges)
                stroke_edges();
            draw_markers(canvas_, view_, flat_, style_.markers, kMarkerWidth);
        } else {
            paint_surface();
        }
        paint_inverted(inverted);
    }

private:
    Outline outline(Index face) const { return outline_of(flat_, view_, face); }
    Pixel place(Index vertex) const { return place_of(flat_, view_, vertex); }

    void find_visible()
    {
        const auto count = static_cast<Index>(flat_.elements.size());
        opacity_.assign(flat_.elements.size(), 0);
        for (Index f = 0; f < count; ++f) {
            const Outline o = outline(f);
            if (!touches(o.pixels(), view_.area))
                continue;
            visible_.push_back(f);
            opacity_[static_cast<std::size_t>(f)] = edge_opacity(o);
        }
        if (canvas_.kind() == ImageKind::svg && visible_.size() > kSvgElements)
            throw InputError("the picture would hold " + std::to_string(visible_.size()) +
                             " elements, more than an SVG viewer can show (" + std::to_string(kSvgElements) +
                             "); write a .png, or zoom in");
    }

    /// From 0 for elements as thin as a pixel to 1 for those with room between their edges.
    double edge_opacity(const Outline& o) const
    {
        constexpr double kGone = 1.2; // pixels
        constexpr double kFull = 7;
        const double longest = longest_side(o);
        const double height = longest > 0 ? area_of(o) / longest * (o.count == 3 ? 2 : 1) : 0;
        return std::clamp((height * canvas_.scale() - kGone) / (kFull - kGone), 0.0, 1.0);
    }

    void tile(std::span<const Pixel> corners, const Colour& colour)
    {
        const auto polygon = clipped(corners, paper_);
        if (polygon.size() > 2)
            canvas_.fill_tile(polygon, colour);
    }

    Colour colour_at(double value) const
    {
        return std::isfinite(value) ? colour_of(style_.range.fraction(value)) : kNoValue;
    }

    void fill(Index face, double light)
    {
        const Outline o = outline(face);
        const auto shaded = [&](const Colour& colour) { return mixed(kInk, colour, light); };
        if (style_.field == nullptr) {
            const double dense = style_.edges ? 1 - opacity_[static_cast<std::size_t>(face)] : 0;
            tile(o.pixels(), shaded(mixed(kElement, kDenseElement, dense)));
        } else if (style_.field->location == FieldLocation::element) {
            tile(o.pixels(), shaded(colour_at(style_.field->values[face])));
        } else {
            fill_smoothly(face, o, shaded);
        }
    }

    template <class Shaded>
    void fill_smoothly(Index face, const Outline& o, const Shaded& shaded)
    {
        const Element& element = flat_.elements[static_cast<std::size_t>(face)];
        std::array<double, 4> fraction{};
        for (std::size_t k = 0; k < o.count; ++k)
            fraction[k] = style_.range.fraction(style_.field->values[element[k]]);
        const int most = canvas_.kind() == ImageKind::png
                             ? 16
                             : static_cast<int>(std::sqrt(double(kSvgElements) / double(visible_.size())));
        const int steps = tile_steps({fraction.data(), o.count}, longest_side(o), most);
        for_each_tile(o.pixels(), {fraction.data(), o.count}, steps,
                      [&](std::span<const Pixel> corners, double value) {
                          tile(corners, shaded(std::isfinite(value) ? colour_of(value) : kNoValue));
                      });
    }

    void stroke_edges()
    {
        std::array<std::vector<Segment>, kFadeSteps + 1> fading;
        const Kernel& kernel = flat_.mesh->kernel;
        for (const EdgeHandle e : kernel.edges()) {
            const HalfedgeHandle h = kernel.halfedge_handle(e, 0);
            const auto step = static_cast<std::size_t>(std::lround(edge_opacity(h) * kFadeSteps));
            if (step == 0)
                continue;
            const Segment whole{place(kernel.from_vertex_handle(h).idx()),
                                place(kernel.to_vertex_handle(h).idx())};
            if (const auto part = clipped(whole, paper_))
                fading[step].push_back(*part);
        }
        const Colour colour = style_.field == nullptr ? kMeshEdge : kInk;
        const double darkest = style_.field == nullptr ? 0.85 : 0.45;
        for (std::size_t step = 1; step <= kFadeSteps; ++step)
            stroke_in_parts(canvas_, fading[step], kEdgeWidth,
                            with_alpha(colour, darkest * double(step) / kFadeSteps));
    }

    /// That of the larger neighbour: a sliver does not wipe out the edges around it.
    double edge_opacity(HalfedgeHandle h) const
    {
        const Kernel& kernel = flat_.mesh->kernel;
        double opacity = 0;
        for (const HalfedgeHandle side : {h, kernel.opposite_halfedge_handle(h)})
            if (!kernel.is_boundary(side))
                opacity =
                    std::max(opacity, opacity_[static_cast<std::size_t>(kernel.face_handle(side).idx())]);
        return opacity;
    }

    /// Elements from the farthest to the nearest, each with its own edges and marker lines.
    void paint_surface()
    {
        const auto marked = marked_edges();
        for (const Index f : far_to_near(flat_, visible_)) {
            fill(f, light_on(flat_, f));
            const double opacity = opacity_[static_cast<std::size_t>(f)];
            if (style_.edges && opacity > 0)
                canvas_.stroke_loop(clipped(outline(f).pixels(), paper_), kEdgeWidth,
                                    with_alpha(kMeshEdge, 0.85 * opacity));
            stroke_marked(f, marked);
        }
    }

    using EdgeColours = std::map<std::array<Index, 2>, Colour>;

    static std::array<Index, 2> edge_key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

    EdgeColours marked_edges() const
    {
        EdgeColours marked;
        for (const Marker& marker : flat_.mesh->markers)
            for (const auto& [from, to] : marker.edges)
                marked[edge_key(from, to)] = colour_of_marker(style_.markers, marker.name);
        return marked;
    }

    void stroke_marked(Index face, const EdgeColours& marked)
    {
        const Element& element = flat_.elements[static_cast<std::size_t>(face)];
        const auto count = static_cast<std::size_t>(corner_count(element));
        for (std::size_t k = 0; k < count && !marked.empty(); ++k) {
            const Index from = element[k];
            const Index to = element[(k + 1) % count];
            const auto found = marked.find(edge_key(from, to));
            const auto part = clipped(Segment{place(from), place(to)}, paper_);
            if (found != marked.end() && part)
                canvas_.stroke({&*part, 1}, kMarkerWidth, found->second);
        }
    }

    void paint_inverted(const std::vector<Index>& inverted)
    {
        constexpr double kTooSmall = 7;
        std::set<std::array<long, 2>> ringed;
        for (const Index f : inverted) {
            const Outline o = outline(f);
            if (!touches(o.pixels(), view_.area))
                continue;
            const auto polygon = clipped(o.pixels(), paper_);
            canvas_.fill_shape(polygon, kInverted);
            canvas_.stroke_loop(polygon, 0.8, kInverted);
            const Pixel at = o.corner[0];
            const std::array<long, 2> cell{std::lround(at.x / kTooSmall), std::lround(at.y / kTooSmall)};
            if (longest_side(o) < kTooSmall && ringed.insert(cell).second)
                canvas_.ring(at, 5, 1.3, kInverted);
        }
    }

    Canvas& canvas_;
    const View& view_;
    const FlatMesh& flat_;
    const MeshStyle& style_;
    Rectangle paper_;
    std::vector<Index> visible_;
    std::vector<double> opacity_;
};

} // namespace

void draw_markers(Canvas& canvas, const View& view, const FlatMesh& flat,
                  const std::vector<std::string>& names, double width)
{
    const Rectangle paper = grown(view.area, kOffPaper);
    for (const Marker& marker : flat.mesh->markers) {
        std::vector<Segment> lines;
        for (const auto& [from, to] : marker.edges)
            if (const auto part =
                    clipped(Segment{place_of(flat, view, from), place_of(flat, view, to)}, paper))
                lines.push_back(*part);
        stroke_in_parts(canvas, lines, width, colour_of_marker(names, marker.name));
    }
}

void draw_mesh(Canvas& canvas, const View& view, const FlatMesh& flat, const MeshStyle& style,
               const std::vector<Index>& inverted)
{
    canvas.clip(view.area);
    MeshPainter(canvas, view, flat, style).paint(inverted);
    canvas.unclip();
}

} // namespace morph::picture
