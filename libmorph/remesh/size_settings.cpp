#include "libmorph/remesh/size_settings.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/remesh/chord_size.h"
#include "libmorph/remesh/target_size.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace morph {

namespace {

const Field& nodal_field(const Mesh& mesh, const std::string& name, const std::string& where)
{
    const Field* field = find_field(mesh.fields, name, FieldLocation::vertex);
    if (field != nullptr)
        return *field;
    std::vector<std::string> names;
    for (const Field& f : mesh.fields)
        if (f.location == FieldLocation::vertex)
            names.push_back(f.name);
    throw InputError((where.empty() ? "the mesh " : where) + "has no nodal field '" + name + "'" +
                     did_you_mean(name, names));
}

/// The vertex of an element that comes first in the file of those with a value that is not right; -1: none.
template <typename Right>
Index first_wrong(const Mesh& mesh, const Matrix& values, const Right& right)
{
    Index first = -1;
    const auto number = [&](Index v) { return mesh.numbering.vertex[static_cast<std::size_t>(v)]; };
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!mesh.kernel.is_isolated(VertexHandle(v)) &&
            !std::all_of(values.row(v).begin(), values.row(v).end(), right) &&
            (first < 0 || number(v) < number(first)))
            first = v;
    return first;
}

std::string place_of(const Mesh& mesh, const std::string& field, Index vertex, const std::string& where)
{
    return where + "field '" + field + "': vertex " +
           std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(vertex)]);
}

Eigen::VectorXd sizes_of_field(const Mesh& mesh, const std::string& name, const std::string& where)
{
    const Field& field = nodal_field(mesh, name, where);
    if (field.values.cols() != 1)
        throw InputError(where + "field '" + name + "' has " + std::to_string(field.values.cols()) +
                         " components, but a size has 1");
    const Index wrong =
        first_wrong(mesh, field.values, [](double size) { return size > 0 && std::isfinite(size); });
    if (wrong >= 0)
        throw InputError(place_of(mesh, name, wrong, where) + " has the target size " +
                         number_text(field.values(wrong, 0)) + ", but it has to be positive");
    return field.values.col(0);
}

Eigen::VectorXd adapted_sizes(const Mesh& mesh, const std::string& name, const std::string& where)
{
    const Field& field = nodal_field(mesh, name, where);
    const Index wrong = first_wrong(mesh, field.values, [](double value) { return std::isfinite(value); });
    if (wrong >= 0)
        throw InputError(place_of(mesh, name, wrong, where) +
                         " has a value that is not finite; sizes cannot be adapted to it");
    return interpolation_sizes(mesh, field.values);
}

/// Of the bounding box of what belongs to elements.
double diagonal_of(const Mesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const auto vertex : mesh.kernel.vertices())
        if (!mesh.kernel.is_isolated(vertex))
            box.extend(Eigen::Vector3d(points(mesh).row(vertex.idx())));
    return box.diagonal().norm();
}

/// Before what is common to all: what one setting says, or the mesh has.
Eigen::VectorXd source_sizes(const Mesh& mesh, const SizeSettings& settings, const std::string& where)
{
    if (!settings.size_field.empty())
        return sizes_of_field(mesh, settings.size_field, where);
    if (!settings.adapt.empty())
        return adapted_sizes(mesh, settings.adapt, where);
    if (settings.size > 0)
        return Eigen::VectorXd::Constant(vertex_count(mesh), settings.size);
    if (settings.curvature > 0) {
        constexpr double kLargest = 0.1; // of the diagonal of the bounding box
        return Eigen::VectorXd::Constant(vertex_count(mesh), kLargest * diagonal_of(mesh));
    }
    return current_sizes(mesh);
}

double gradation_of(const SizeSettings& settings)
{
    constexpr double kUsual = 1.2;
    if (settings.gradation > 0)
        return settings.gradation;
    return settings.size_field.empty() && settings.adapt.empty() && !(settings.curvature > 0) ? 0 : kUsual;
}

} // namespace

Index target_vertices(const Mesh& mesh, const SizeSettings& settings)
{
    return settings.vertices > 0 || settings.adapt.empty() ? settings.vertices : mesh.numbering.file_vertices;
}

Eigen::VectorXd target_sizes(const Mesh& mesh, const SizeSettings& settings, const FeatureSettings& features,
                             const std::string& where)
{
    Eigen::VectorXd sizes = source_sizes(mesh, settings, where);
    if (settings.curvature > 0)
        sizes = sizes.cwiseMin(chord_sizes(mesh, features, settings.curvature));
    sizes *= settings.scale;
    const double gradation = gradation_of(settings);
    const Index vertices = target_vertices(mesh, settings);
    // Each undoes a little of what the others did, less and less.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        if (vertices > 0)
            scale_to_vertices(mesh, vertices, sizes);
        if (settings.size > 0 && !settings.adapt.empty())
            sizes = sizes.cwiseMin(settings.size);
        if (gradation > 0)
            limit_gradation(mesh, gradation, sizes);
    }
    return sizes;
}

} // namespace morph
