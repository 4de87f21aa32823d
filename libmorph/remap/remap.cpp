#include "libmorph/remap/remap.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/nearest_points.h"
#include "libmorph/remap/interpolate.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <string>

namespace morph {

namespace {

std::string number(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string place(const Eigen::Ref<const Points>& points, Index i)
{
    std::string text = "(" + number(points(i, 0)) + ", " + number(points(i, 1));
    return points(i, 2) == 0 ? text + ")" : text + ", " + number(points(i, 2)) + ")";
}

/// "(0, 0) to (2, 1)"
std::string extent(const Eigen::Ref<const Points>& points)
{
    Points corners(2, 3);
    corners << points.colwise().minCoeff(), points.colwise().maxCoeff();
    return place(corners, 0) + " to " + place(corners, 1);
}

void require_finite(const Mesh& source, const Field& field)
{
    if (field.values.allFinite())
        return;
    const bool nodal = field.location == FieldLocation::vertex;
    for (Eigen::Index i = 0; i < field.values.rows(); ++i)
        if (!field.values.row(i).allFinite()) {
            const auto& file_number = nodal ? source.numbering.vertex : source.numbering.element;
            throw InputError("field '" + field.name + "' of the source is not finite at " +
                             (nodal ? "vertex " : "element ") +
                             std::to_string(file_number[static_cast<std::size_t>(i)]));
        }
}

Points centres_of(const Mesh& mesh)
{
    Points centres(element_count(mesh), 3);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element element = element_corners(mesh, f);
        const int corners = corner_count(element);
        centres.row(f).setZero();
        for (int k = 0; k < corners; ++k)
            centres.row(f) += points(mesh).row(element[static_cast<std::size_t>(k)]) / corners;
    }
    return centres;
}

/// The vertices that some element has: others hold values that belong to nothing.
std::vector<Index> used_vertices(const Mesh& mesh)
{
    std::vector<Index> used;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!mesh.kernel.is_isolated(VertexHandle(v)))
            used.push_back(v);
    return used;
}

/// Copy the row that each target outside takes from the rows of another matrix.
void scatter(const std::vector<Index>& targets, const Matrix& from, Matrix& to)
{
    for (std::size_t i = 0; i < targets.size(); ++i)
        to.row(targets[i]) = from.row(static_cast<Eigen::Index>(i));
}

/// The values at the closest points of the source.
std::vector<Matrix> values_at_feet(const Mesh& source, const TargetLocations& targets,
                                   std::span<const Field* const> fields, QuadRule rule)
{
    ContainingElements feet;
    Points at(static_cast<Eigen::Index>(targets.outside.size()), 3);
    for (const ElementTree::Closest& foot : targets.outside_feet) {
        at.row(static_cast<Eigen::Index>(feet.face.size())) = foot.point.transpose();
        feet.face.push_back(foot.face);
    }
    feet.order.resize(feet.face.size());
    std::iota(feet.order.begin(), feet.order.end(), 0);
    return interpolate(source, feet, at, fields, rule);
}

/// Nodal values of the nearest vertices of the source; element fields are left empty.
std::vector<Matrix> values_of_nearest(const Mesh& source, const Points& targets,
                                      const std::vector<Index>& outside, std::span<const Field* const> fields)
{
    const std::vector<Index> used = used_vertices(source);
    std::vector<Matrix> values(fields.size());
    for (std::size_t f = 0; f < fields.size(); ++f)
        if (fields[f]->location == FieldLocation::vertex)
            values[f].resize(static_cast<Eigen::Index>(outside.size()), fields[f]->values.cols());
    const NearestPoints nearest(points(source)(used, Eigen::all));
    nearest.nearest(targets(outside, Eigen::all), 1,
                    [&](Index i, std::span<const NearestPoints::Neighbor> found) {
                        const Index vertex = used[static_cast<std::size_t>(found.front().point)];
                        for (std::size_t f = 0; f < fields.size(); ++f)
                            if (fields[f]->location == FieldLocation::vertex)
                                values[f].row(i) = fields[f]->values.row(vertex);
                    });
    return values;
}

} // namespace

Remapper::Remapper(const Locator& source, const Mesh& target, const RemapSettings& settings)
    : source_(source), target_(target), settings_(settings)
{
    if (element_count(source.source()) == 0)
        throw InputError("the source has no element to take values from");
    if (vertex_count(target) == 0)
        throw InputError("the target has no point to take values to");
    if (source.source().dimension == 2 && target.dimension == 3)
        throw InputError("the source is planar, but the target lies in space: some of its z are not 0");
}

const TargetLocations& Remapper::locations(FieldLocation location)
{
    const bool nodal = location == FieldLocation::vertex;
    std::optional<TargetLocations>& found = nodal ? vertices_ : centres_;
    if (!found)
        found = locate_targets(source_, nodal ? Points(points(target_)) : centres_of(target_));
    return *found;
}

FieldLocation Remapper::place_of(const Field& field) const
{
    return element_count(target_) == 0 ? FieldLocation::vertex : field.location;
}

Outside Remapper::outside() const
{
    return settings_.outside.value_or(source_.source().dimension == 2 ? Outside::idw : Outside::project);
}

std::vector<Field> Remapper::transfer(std::span<const Field* const> fields)
{
    std::vector<Field> transferred;
    for (const Field* field : fields) {
        require_finite(source_.source(), *field);
        if (find_field(transferred, field->name, place_of(*field)) != nullptr)
            throw InputError("the source has a nodal and an element field '" + field->name +
                             "', but a target without elements has room for one of them");
        transferred.push_back({field->name, place_of(*field), {}});
    }
    for (const FieldLocation location : {FieldLocation::vertex, FieldLocation::element}) {
        std::vector<const Field*> here;
        for (const Field* field : fields)
            if (place_of(*field) == location)
                here.push_back(field);
        if (here.empty())
            continue;
        std::vector<Matrix> values = values_at(location, here);
        auto next = values.begin();
        for (Field& field : transferred)
            if (field.location == location)
                field.values = std::move(*next++);
    }
    return transferred;
}

const std::optional<Conservation>& Remapper::conservation(FieldLocation location) const
{
    return location == FieldLocation::vertex ? nodal_conservation_ : element_conservation_;
}

std::vector<Matrix> Remapper::values_at(FieldLocation location, std::span<const Field* const> fields)
{
    const bool nodal = location == FieldLocation::vertex;
    if (!(nodal ? settings_.conserve_nodal : settings_.conserve_elements))
        return interpolated(location, fields);
    ConservedFields conserved = conserve_fields(source_, target_, fields);
    (nodal ? nodal_conservation_ : element_conservation_) = std::move(conserved.summary);
    if (!conserved.uncovered.empty()) {
        const std::vector<Matrix> others = interpolated(location, fields);
        for (std::size_t f = 0; f < fields.size(); ++f)
            for (const Index row : conserved.uncovered)
                conserved.values[f].row(row) = others[f].row(row);
    }
    return std::move(conserved.values);
}

std::vector<Matrix> Remapper::interpolated(FieldLocation location, std::span<const Field* const> fields)
{
    const TargetLocations& targets = locations(location);
    const Mesh& source = source_.source();
    const Points& at = source.dimension == 2 ? targets.points : targets.feet;
    if (targets.outside.size() == static_cast<std::size_t>(at.rows()))
        throw InputError("none of the " + std::to_string(at.rows()) +
                         (location == FieldLocation::vertex ? " targets" : " element centres of the target") +
                         " lies in the source: they span " + extent(targets.points) + ", the source " +
                         extent(points(source)));
    std::vector<Matrix> values = interpolate(source, targets.elements, at, fields, settings_.quads);
    if (!targets.outside.empty())
        fill_outside(targets, fields, values);
    return values;
}

void Remapper::fill_outside(const TargetLocations& targets, std::span<const Field* const> fields,
                            std::vector<Matrix>& values)
{
    if (outside() == Outside::fail) {
        const auto farthest =
            std::max_element(targets.outside_feet.begin(), targets.outside_feet.end(),
                             [](const auto& a, const auto& b) { return a.distance < b.distance; });
        const Index target =
            targets.outside[static_cast<std::size_t>(farthest - targets.outside_feet.begin())];
        throw InputError(std::to_string(targets.outside.size()) + " of " +
                         std::to_string(targets.points.rows()) +
                         " targets lie outside the source, the farthest at " + place(targets.points, target) +
                         " by " + number(farthest->distance));
    }
    if (outside() == Outside::idw) {
        std::vector<Index> inside;
        for (std::size_t i = 0; i < targets.elements.face.size(); ++i)
            if (targets.elements.face[i] >= 0)
                inside.push_back(static_cast<Index>(i));
        fill_by_inverse_distance(targets.points, inside, targets.outside, settings_.inverse_distance, values);
        return;
    }
    const Mesh& source = source_.source();
    // Element fields are constant around the closest point, so that projecting them takes the nearest
    // element.
    const std::vector<Matrix> feet = values_at_feet(source, targets, fields, settings_.quads);
    std::vector<Matrix> nearest;
    if (outside() == Outside::nearest)
        nearest = values_of_nearest(source, targets.points, targets.outside, fields);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        const bool take_vertex =
            outside() == Outside::nearest && fields[f]->location == FieldLocation::vertex;
        scatter(targets.outside, take_vertex ? nearest[f] : feet[f], values[f]);
    }
}

} // namespace morph
