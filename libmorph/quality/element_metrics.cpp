#include "libmorph/quality/element_metrics.h"

#include "libmorph/quality/wall.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace morph {

namespace {

/// Collects fields of one value per element.
class MetricFields {
public:
    explicit MetricFields(const Mesh& mesh) : mesh_(mesh) {}

    /// A field of @p value of each entry of @p all, which are in the order of the mesh.
    template <class Value>
    void add(const std::string& name, const std::vector<ElementQuality>& all, const Value& value)
    {
        Matrix& values = new_field(name);
        for (std::size_t f = 0; f < all.size(); ++f)
            values(mesh_.numbering.element[f], 0) = value(all[f], f);
    }

    /// A field without values yet, which are to be written by file number.
    Matrix& new_field(const std::string& name)
    {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        fields_.push_back({name, FieldLocation::element, Matrix::Constant(element_count(mesh_), 1, kNone)});
        return fields_.back().values;
    }

    std::vector<Field> take() { return std::move(fields_); }

private:
    const Mesh& mesh_;
    std::vector<Field> fields_;
};

/// The Jacobian of a corner, counted as the file lists them.
double corner_jacobian(const Mesh& mesh, const ElementQuality& quality, std::size_t face, std::size_t corner)
{
    return quality.jacobian[mesh.numbering.reversed[face] ? (4 - corner) % 4 : corner];
}

void add_shape(MetricFields& fields, const Mesh& mesh, const PositionsView* reference)
{
    const auto all = element_quality(mesh, points(mesh), reference);
    const auto add = [&](const char* name, double ElementQuality::*value) {
        fields.add(name, all, [&](const ElementQuality& q, std::size_t) { return q.*value; });
    };
    add("area", &ElementQuality::area);
    add("min_corner_jacobian", &ElementQuality::min_jacobian);
    add("scaled_jacobian", &ElementQuality::scaled_jacobian);
    add("min_angle", &ElementQuality::min_angle);
    add("max_angle", &ElementQuality::max_angle);
    add("aspect_ratio", &ElementQuality::aspect_ratio);
    if (reference != nullptr)
        add("size_skew", &ElementQuality::size_skew);
    for (std::size_t corner = 0; corner < 4; ++corner)
        fields.add(
            "corner_jacobian_" + std::to_string(corner + 1), all,
            [&](const ElementQuality& q, std::size_t f) { return corner_jacobian(mesh, q, f, corner); });
    fields.add("inverted", all, [](const ElementQuality& q, std::size_t) { return q.inverted ? 1 : 0; });
}

using Cells = std::vector<WallCell>;

Cells all_wall_cells(const Mesh& mesh, const PositionsView& positions)
{
    Cells all;
    for (const Marker& marker : mesh.markers) {
        const Cells cells = wall_cells(mesh, marker, positions);
        all.insert(all.end(), cells.begin(), cells.end());
    }
    return all;
}

template <class Value, class Choice>
void add_wall_field(MetricFields& fields, const std::string& name, const Mesh& mesh, const Cells& cells,
                    const Value& value, const Choice& choice)
{
    Matrix& values = fields.new_field(name);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        double& chosen = values(mesh.numbering.element[static_cast<std::size_t>(cells[i].face)], 0);
        chosen = choice(chosen, value(i)); // fmin and fmax ignore a NaN
    }
}

void add_walls(MetricFields& fields, const Mesh& mesh, const PositionsView* reference)
{
    const auto smaller = [](double a, double b) { return std::fmin(a, b); };
    const auto larger = [](double a, double b) { return std::fmax(a, b); };
    const Cells now = all_wall_cells(mesh, points(mesh));
    if (now.empty())
        return;
    add_wall_field(
        fields, "first_cell_height", mesh, now, [&](std::size_t i) { return now[i].height; }, smaller);
    add_wall_field(
        fields, "orthogonality", mesh, now, [&](std::size_t i) { return now[i].angle; }, larger);
    if (reference == nullptr)
        return;
    const Cells before = all_wall_cells(mesh, *reference);
    add_wall_field(
        fields, "height_change", mesh, now, [&](std::size_t i) { return height_change(before[i], now[i]); },
        larger);
    add_wall_field(
        fields, "orthogonality_change", mesh, now,
        [&](std::size_t i) { return angle_change(before[i], now[i]); }, larger);
}

} // namespace

std::vector<Field> element_metrics(const Mesh& mesh, const PositionsView* reference)
{
    MetricFields fields(mesh);
    add_shape(fields, mesh, reference);
    add_walls(fields, mesh, reference);
    return fields.take();
}

} // namespace morph
