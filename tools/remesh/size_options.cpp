#include "tools/remesh/size_options.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/remesh/chord_size.h"
#include "libmorph/remesh/target_size.h"
#include "tools/common/command_line.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace morph::tools {

namespace {

const Field& nodal_field(const Mesh& mesh, const std::string& name, const std::string& input)
{
    const Field* field = find_field(mesh.fields, name, FieldLocation::vertex);
    if (field != nullptr)
        return *field;
    std::vector<std::string> names;
    for (const Field& f : mesh.fields)
        if (f.location == FieldLocation::vertex)
            names.push_back(f.name);
    throw InputError(input + ": has no nodal field '" + name + "'" + did_you_mean(name, names));
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

std::string place_of(const Mesh& mesh, const std::string& field, Index vertex, const std::string& input)
{
    return input + ": field '" + field + "': vertex " +
           std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(vertex)]);
}

Eigen::VectorXd sizes_of_field(const Mesh& mesh, const std::string& name, const std::string& input)
{
    const Field& field = nodal_field(mesh, name, input);
    if (field.values.cols() != 1)
        throw InputError(input + ": field '" + name + "' has " + std::to_string(field.values.cols()) +
                         " components, but a size has 1");
    const Index wrong =
        first_wrong(mesh, field.values, [](double size) { return size > 0 && std::isfinite(size); });
    if (wrong >= 0)
        throw InputError(place_of(mesh, name, wrong, input) + " has the wanted size " +
                         number_text(field.values(wrong, 0)) + ", but it has to be positive");
    return field.values.col(0);
}

Eigen::VectorXd adapted_sizes(const Mesh& mesh, const std::string& name, const std::string& input)
{
    const Field& field = nodal_field(mesh, name, input);
    const Index wrong = first_wrong(mesh, field.values, [](double value) { return std::isfinite(value); });
    if (wrong >= 0)
        throw InputError(place_of(mesh, name, wrong, input) +
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

/// Before what is common to all: what one option says, or the mesh has.
Eigen::VectorXd source_sizes(const Mesh& mesh, const SizeOptions& options, const std::string& input)
{
    if (!options.size_field.empty())
        return sizes_of_field(mesh, options.size_field, input);
    if (!options.adapt.empty())
        return adapted_sizes(mesh, options.adapt, input);
    if (options.size > 0)
        return Eigen::VectorXd::Constant(vertex_count(mesh), options.size);
    if (options.curvature > 0) {
        constexpr double kLargest = 0.1; // of the diagonal of the bounding box
        return Eigen::VectorXd::Constant(vertex_count(mesh), kLargest * diagonal_of(mesh));
    }
    return current_sizes(mesh);
}

double gradation_of(const SizeOptions& options)
{
    constexpr double kUsual = 1.2;
    if (options.gradation > 0)
        return options.gradation;
    return options.size_field.empty() && options.adapt.empty() && !(options.curvature > 0) ? 0 : kUsual;
}

} // namespace

void add_size_options(CommandLine& line, SizeOptions& options)
{
    const Option size = line.add("--size", options.size,
                                 "Edge length wanted everywhere; with --curvature or --adapt the largest")
                            .positive()
                            .type_name("H");
    const Option field = line.add("--size-field", options.size_field,
                                  "Nodal field of IN with the edge lengths wanted (default: those IN has)")
                             .excludes(size)
                             .type_name("NAME");
    const Option curvature =
        line.add("--curvature", options.curvature,
                 "Chord error of edges along boundary curves or on a surface, in lengths of the mesh:\n"
                 "edges of sqrt(8 E r) at radius r, at most --size, the field, or a tenth of the\n"
                 "bounding box's diagonal")
            .positive()
            .type_name("E");
    line.add("--adapt", options.adapt,
             "Nodal field of IN: the sizes that make its interpolation error least in the mean (L2)\n"
             "for --vertices (default: as many as IN has)")
        .excludes(field)
        .excludes(curvature)
        .type_name("NAME");
    line.add("--scale", options.scale, "Factor on the edge lengths wanted").show_default().positive();
    line.add("--vertices", options.vertices, "Scale them further, to about this many vertices")
        .range(3, 100000000)
        .type_name("N");
    line.add("--gradation", options.gradation,
             "Edges that follow each other differ in length by at most this factor (default: 1.2 with\n"
             "--size-field, --curvature or --adapt, else as they do in IN)")
        .above(1);
}

Index wanted_vertices(const Mesh& mesh, const SizeOptions& options)
{
    return options.vertices > 0 || options.adapt.empty() ? options.vertices : mesh.numbering.file_vertices;
}

Eigen::VectorXd target_sizes(const Mesh& mesh, const SizeOptions& options, const FeatureSettings& features,
                             const std::string& input)
{
    Eigen::VectorXd sizes = source_sizes(mesh, options, input);
    if (options.curvature > 0)
        sizes = sizes.cwiseMin(chord_sizes(mesh, features, options.curvature));
    sizes *= options.scale;
    const double gradation = gradation_of(options);
    const Index vertices = wanted_vertices(mesh, options);
    // Each undoes a little of what the others did, less and less.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        if (vertices > 0)
            scale_to_vertices(mesh, vertices, sizes);
        if (options.size > 0 && !options.adapt.empty())
            sizes = sizes.cwiseMin(options.size);
        if (gradation > 0)
            limit_gradation(mesh, gradation, sizes);
    }
    return sizes;
}

} // namespace morph::tools
