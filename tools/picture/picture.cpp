#include "tools/picture/picture.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/quality/quality.h"
#include "tools/picture/clip.h"
#include "tools/picture/legend.h"
#include "tools/picture/mesh_layer.h"
#include "tools/picture/ticks.h"

#include <algorithm>
#include <cmath>

namespace morph::picture {

namespace {

constexpr double kMargin = 24;
constexpr double kGap = 20;
constexpr double kTitle = 34;
constexpr double kCaption = 24;
constexpr double kLegendGap = 14;

/// A mesh made ready for all the panels it appears in.
struct Scene {
    FlatMesh flat;
    std::vector<Index> inverted;
    std::string caption;
};

/// One framed view of a scene.
struct Panel {
    const Scene* scene = nullptr;
    const ScalarField* field = nullptr;
    std::string caption;
    Box box;
    bool inset = false;
};

std::vector<Scene> make_scenes(const std::vector<Subject>& subjects)
{
    std::vector<Scene> scenes;
    for (const Subject& subject : subjects) {
        Scene scene{flattened(*subject.mesh), inverted_elements(*subject.mesh, points(*subject.mesh)),
                    subject.caption};
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

std::vector<ScalarField> make_fields(const std::vector<Subject>& subjects, const std::string& name)
{
    std::vector<ScalarField> fields;
    for (const Subject& subject : subjects) {
        if (name.empty())
            break;
        try {
            fields.push_back(scalar_field(*subject.mesh, name));
        } catch (const InputError& error) {
            throw InputError(subject.caption + ": " + error.what());
        }
    }
    return fields;
}

Box whole_domain(const std::vector<Scene>& scenes)
{
    Box box = scenes.front().flat.box;
    for (const Scene& scene : scenes)
        box = joined(box, scene.flat.box);
    return box;
}

/// The box around the bodies of all scenes, if each has some worth a view of their own.
std::optional<Box> all_bodies(const std::vector<Scene>& scenes)
{
    std::optional<Box> all;
    for (const Scene& scene : scenes) {
        const auto bodies = bodies_box(scene.flat);
        if (!bodies)
            return std::nullopt;
        all = all ? joined(*all, *bodies) : *bodies;
    }
    return all;
}

void require_zoom_shows_something(const Box& zoom, const Box& domain)
{
    const bool apart = zoom.xmin > domain.xmax || zoom.xmax < domain.xmin || zoom.ymin > domain.ymax ||
                       zoom.ymax < domain.ymin;
    const auto range = [](double low, double high) { return tick_label(low) + " to " + tick_label(high); };
    if (apart)
        throw InputError("the zoom box shows no part of the mesh, which spans x " +
                         range(domain.xmin, domain.xmax) + ", y " + range(domain.ymin, domain.ymax));
}

/// Around the element with the smallest scaled Jacobian: of the last scene with inverted ones, or, when even
/// the last scene must be valid.
std::optional<Box> worst_spot(const std::vector<Scene>& scenes, bool even_valid)
{
    auto scene =
        std::find_if(scenes.rbegin(), scenes.rend(), [](const Scene& s) { return !s.inverted.empty(); });
    if (scene == scenes.rend() && even_valid)
        scene = scenes.rbegin();
    if (scene == scenes.rend())
        return std::nullopt;
    const Index worst = quality_report(*scene->flat.mesh).worst.front().face;
    const Element& element = scene->flat.elements[static_cast<std::size_t>(worst)];
    const auto& place = scene->flat.place;
    Box box{place(element[0], 0), place(element[0], 1), place(element[0], 0), place(element[0], 1)};
    for (int k = 1; k < corner_count(element); ++k) {
        const Index v = element[static_cast<std::size_t>(k)];
        box = joined(box, {place(v, 0), place(v, 1), place(v, 0), place(v, 1)});
    }
    constexpr double kAround = 4;   // element sizes
    constexpr double kLeast = 1e-9; // of the domain, for an element that has shrunk to a point
    const Box& domain = scene->flat.box;
    const double least = kLeast * std::max(domain.width(), domain.height());
    box = joined(box, {box.xmin, box.ymin, box.xmin + least, box.ymin + least});
    return with_margin(box, kAround);
}

std::vector<std::string> marker_names(const std::vector<Scene>& scenes)
{
    std::vector<std::string> names;
    for (const Scene& scene : scenes)
        for (const Marker& marker : scene.flat.mesh->markers)
            if (!marker.edges.empty() && std::find(names.begin(), names.end(), marker.name) == names.end())
                names.push_back(marker.name);
    return names;
}

std::string close_up_caption(const Box& box)
{
    return "worst spot, around (" + tick_label((box.xmin + box.xmax) / 2) + ", " +
           tick_label((box.ymin + box.ymax) / 2) + ")";
}

/// Puts panels into a grid below the title and the legend below them.
class Composer {
public:
    Composer(const std::vector<Subject>& subjects, const PictureOptions& options)
        : options_(options), scenes_(make_scenes(subjects)), fields_(make_fields(subjects, options.field)),
          domain_(whole_domain(scenes_))
    {
        choose_views();
        legend_.markers = marker_names(scenes_);
        for (const Scene& scene : scenes_)
            legend_.inverted = legend_.inverted || !scene.inverted.empty();
        if (!fields_.empty()) {
            legend_.field = fields_.front().label;
            legend_.range = common_range(fields_);
        }
    }

    std::string draw(ImageKind kind)
    {
        const double width = columns_ == 1 ? 1000 : 1500;
        const double column = (width - 2 * kMargin - (columns_ - 1) * kGap) / double(columns_);
        const double row = std::round(column / aspect_);
        const double head = options_.title.empty() ? kMargin - 8 : kTitle + kMargin - 6;
        const auto rows = (panels_.size() + columns_ - 1) / columns_;
        const double foot = legend_height(legend_) > 0 ? legend_height(legend_) + kLegendGap : 0;
        const double height = head + double(rows) * (row + kCaption) + double(rows - 1) * 10 + foot + kMargin;
        const double pixels = options_.width > 0 ? options_.width : columns_ == 1 ? 1600 : 2100;
        Canvas canvas(kind, width, height, pixels / width);
        canvas.text({kMargin, kTitle + 2}, canvas.fitted(options_.title, kTitleStyle, width - 2 * kMargin),
                    kTitleStyle);
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const std::size_t above = i / columns_;
            const std::size_t left = i % columns_;
            const double x = kMargin + double(left) * (column + kGap);
            const double y = head + double(above) * (row + kCaption + 10) + kCaption;
            draw_panel(canvas, panels_[i], {x, y, column, row});
        }
        draw_legend(canvas, {kMargin, height - kMargin - legend_height(legend_), width - 2 * kMargin, 0},
                    legend_);
        return canvas.finish();
    }

private:
    inline static const TextStyle kTitleStyle{.size = 19, .bold = true};

    void choose_views()
    {
        constexpr double kAroundBodies = 0.3;
        const auto bodies = all_bodies(scenes_);
        Box main = with_margin(bodies.value_or(domain_), bodies ? kAroundBodies : 0.03);
        if (options_.zoom) {
            require_zoom_shows_something(*options_.zoom, domain_);
            main = *options_.zoom;
        }
        const auto spot = options_.zoom ? std::nullopt : worst_spot(scenes_, options_.close_up);
        columns_ = scenes_.size() == 2 || spot ? 2 : 1;
        aspect_ = std::clamp(main.width() / main.height(), columns_ == 1 ? 1.2 : 1.0, 2.0);
        for (std::size_t i = 0; i < scenes_.size(); ++i)
            panels_.push_back({&scenes_[i], field(i), scenes_[i].caption, with_aspect(main, aspect_),
                               bodies && !options_.zoom});
        for (std::size_t i = 0; spot && i < scenes_.size(); ++i)
            panels_.push_back(
                {&scenes_[i], field(i), close_up_caption(*spot), with_aspect(*spot, aspect_), false});
    }

    const ScalarField* field(std::size_t scene) const { return fields_.empty() ? nullptr : &fields_[scene]; }

    void draw_panel(Canvas& canvas, const Panel& panel, const Rectangle& area) const
    {
        const View view{panel.box, area};
        MeshStyle style{panel.field, legend_.range, options_.edges, legend_.markers};
        draw_mesh(canvas, view, panel.scene->flat, style, panel.scene->inverted);
        draw_scale_bar(canvas, view);
        if (panel.inset)
            draw_inset(canvas, view, *panel.scene);
        canvas.outline(area, 0.8, kFrame);
        draw_caption(canvas, panel, area);
    }

    static void draw_caption(Canvas& canvas, const Panel& panel, const Rectangle& area)
    {
        const TextStyle style{.size = 13, .colour = kInk};
        const TextStyle alarm{.size = 13, .colour = kInverted, .align = Align::right, .bold = true};
        const auto count = panel.scene->inverted.size();
        const bool counted = count > 0 && panel.caption == panel.scene->caption;
        const std::string words = counted ? std::to_string(count) + " inverted" : "";
        const double left = area.width - canvas.text_width(words, alarm) - 16;
        canvas.text({area.x, area.y - 8}, canvas.fitted(panel.caption, style, left), style);
        canvas.text({area.x + area.width, area.y - 8}, words, alarm);
    }

    /// The whole domain, small, with a frame around what the view shows.
    void draw_inset(Canvas& canvas, const View& view, const Scene& scene) const
    {
        const Box domain = with_margin(domain_, 0.06);
        const double aspect = domain.width() / domain.height();
        const double width = std::min(0.2 * view.area.width, 0.34 * view.area.height * aspect);
        const Rectangle area{view.area.x + view.area.width - width, view.area.y, width, width / aspect};
        const View small{domain, area};
        canvas.fill(area, kPaper);
        std::vector<std::vector<Pixel>> loops;
        for (const auto& loop : scene.flat.loops) {
            auto& pixels = loops.emplace_back();
            for (const Index v : loop)
                pixels.push_back(small.place(scene.flat.place(v, 0), scene.flat.place(v, 1)));
        }
        canvas.fill_loops(loops, kElement);
        draw_markers(canvas, small, scene.flat, legend_.markers, 1.2);
        draw_view_frame(canvas, small, view.box);
        canvas.outline(area, 0.8, kFrame);
    }

    static void draw_view_frame(Canvas& canvas, const View& small, const Box& shown)
    {
        constexpr double kSmallest = 6;
        const Pixel corner = small.place(shown.xmin, shown.ymax);
        Rectangle frame{corner.x, corner.y, shown.width() * small.scale(), shown.height() * small.scale()};
        if (frame.width < kSmallest)
            frame = grown(frame, (kSmallest - frame.width) / 2);
        canvas.clip(small.area);
        canvas.outline(frame, 1.2, kInk);
        canvas.unclip();
    }

    const PictureOptions& options_;
    std::vector<Scene> scenes_;
    std::vector<ScalarField> fields_;
    Box domain_;
    std::vector<Panel> panels_;
    Legend legend_;
    std::size_t columns_ = 1;
    double aspect_ = 1;
};

} // namespace

std::string draw_picture(const std::vector<Subject>& subjects, const PictureOptions& options, ImageKind kind)
{
    return Composer(subjects, options).draw(kind);
}

} // namespace morph::picture
