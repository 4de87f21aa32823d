#include "tools/picture/legend.h"

#include "tools/picture/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morph::picture {

namespace {

constexpr double kRow = 20;
constexpr double kSwatch = 18;
constexpr std::size_t kNamedMarkers = 8;
const TextStyle kLabel{.size = 12, .colour = kInk};
const TextStyle kTick{.size = 11, .colour = kFaintInk, .align = Align::centre};

/// Sets swatches with their labels one after the other, in as many rows as they need.
class SwatchRow {
public:
    SwatchRow(Canvas& canvas, const Rectangle& area)
        : canvas_(canvas), area_(area), x_(area.x), y_(area.y + 10)
    {
    }

    void line(const Colour& colour, const std::string& label)
    {
        const std::string words = begin(label);
        const Segment segment{Pixel{x_, y_}, Pixel{x_ + kSwatch, y_}};
        canvas_.stroke({&segment, 1}, 2.5, colour);
        end(words);
    }

    void patch(const Colour& colour, const std::string& label)
    {
        const std::string words = begin(label);
        canvas_.fill({x_ + 3, y_ - 5, 11, 11}, colour);
        end(words);
    }

    void words_only(const std::string& label)
    {
        canvas_.text({x_, y_ + 4}, begin(label), {.size = 12, .colour = kFaintInk});
    }

private:
    std::string begin(const std::string& label)
    {
        constexpr double kLongest = 180;
        std::string words = canvas_.fitted(label, kLabel, kLongest);
        if (x_ > area_.x && x_ + kSwatch + 8 + canvas_.text_width(words, kLabel) > area_.x + area_.width) {
            x_ = area_.x;
            y_ += kRow;
        }
        return words;
    }

    void end(const std::string& words)
    {
        canvas_.text({x_ + kSwatch + 7, y_ + 4}, words, kLabel);
        x_ += kSwatch + 7 + canvas_.text_width(words, kLabel) + 24;
    }

    Canvas& canvas_;
    Rectangle area_;
    double x_;
    double y_;
};

void draw_colour_bar(Canvas& canvas, const Rectangle& area, const Legend& legend)
{
    constexpr int kCells = 256;
    const Rectangle bar{area.x, area.y + 18, area.width, 11};
    canvas.text({area.x, area.y + 11}, canvas.fitted(legend.field, kLabel, area.width), kLabel);
    for (int i = 0; i < kCells; ++i) {
        const double left = bar.x + bar.width * i / kCells;
        const double right = bar.x + bar.width * (i + 1) / kCells;
        const std::array<Pixel, 4> cell{Pixel{left, bar.y}, Pixel{right, bar.y},
                                        Pixel{right, bar.y + bar.height}, Pixel{left, bar.y + bar.height}};
        canvas.fill_tile(cell, colour_of((i + 0.5) / kCells));
    }
    for (const double value : ticks(legend.range.low, legend.range.high, 6)) {
        const double x = bar.x + bar.width * legend.range.fraction(value);
        const Segment mark{Pixel{x, bar.y + bar.height}, Pixel{x, bar.y + bar.height + 4}};
        canvas.stroke({&mark, 1}, 0.8, kFaintInk);
        canvas.text({x, bar.y + bar.height + 16}, tick_label(value), kTick);
    }
}

} // namespace

double legend_height(const Legend& legend)
{
    if (!legend.field.empty())
        return 50;
    return legend.markers.empty() && !legend.inverted ? 0 : legend.markers.size() > 4 ? 2 * kRow : kRow;
}

void draw_legend(Canvas& canvas, const Rectangle& area, const Legend& legend)
{
    constexpr double kBar = 320;
    constexpr double kGap = 40;
    Rectangle left = area;
    if (!legend.field.empty()) {
        left.width -= kBar + kGap;
        draw_colour_bar(canvas, {area.x + area.width - kBar - 12, area.y, kBar, area.height}, legend);
    }
    SwatchRow row(canvas, left);
    if (legend.inverted)
        row.patch(kInverted, "inverted elements");
    for (std::size_t i = 0; i < std::min(kNamedMarkers, legend.markers.size()); ++i)
        row.line(marker_colour(i), legend.markers[i]);
    if (legend.markers.size() > kNamedMarkers)
        row.words_only("and " + std::to_string(legend.markers.size() - kNamedMarkers) + " more");
}

void draw_scale_bar(Canvas& canvas, const View& view)
{
    constexpr double kInset = 12;
    const double length = round_length(view.box.width() / 6);
    const double width = length * view.scale();
    const Pixel start{view.area.x + kInset, view.area.y + view.area.height - kInset};
    const TextStyle label{.size = 11, .colour = kInk, .align = Align::centre};
    const std::string words = tick_label(length);
    const double room = std::max(width, canvas.text_width(words, label)) + 12;
    canvas.fill({start.x - 6, start.y - 20, room, 26}, with_alpha(kPaper, 0.85));
    const std::vector<Segment> bar{
        {Pixel{start.x, start.y}, Pixel{start.x + width, start.y}},
        {Pixel{start.x, start.y - 3}, Pixel{start.x, start.y + 3}},
        {Pixel{start.x + width, start.y - 3}, Pixel{start.x + width, start.y + 3}}};
    canvas.stroke(bar, 1.2, kInk);
    canvas.text({start.x + width / 2, start.y - 7}, words, label);
}

} // namespace morph::picture
