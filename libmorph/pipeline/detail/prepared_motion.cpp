#include "libmorph/pipeline/detail/prepared_motion.h"

#include "libmorph/core/error.h"
#include "libmorph/pipeline/detail/extension_methods.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

PreparedMotion motion_of_lattice(const Mesh& mesh, const MotionSettings& settings)
{
    PreparedMotion motion;
    motion.lattice = place_lattice(mesh, settings);
    motion.displacements = motion.lattice->displacements;
    if (!settings.curves.empty())
        motion.curves = parametrize_boundaries(mesh, settings);
    motion.weights = motion.lattice->weights;
    return motion;
}

/// With the boundary's rows set, so that its nodes land on their curves.
Weights on_boundary(Weights given, const Mesh& mesh, const BoundaryConditions& conditions)
{
    if (given.columns != conditions.columns || given.values.rows() != vertex_count(mesh) ||
        given.values.cols() != std::ssize(given.columns))
        throw InputError(
            "the given weights are " + std::to_string(given.values.rows()) + " x " +
            std::to_string(given.values.cols()) + " of other control points or vertices; expected " +
            std::to_string(vertex_count(mesh)) + " x " + std::to_string(conditions.columns.size()));
    for (std::size_t i = 0; i < conditions.boundary.vertices.size(); ++i)
        given.values.row(conditions.boundary.vertices[i]) =
            conditions.values.row(static_cast<Eigen::Index>(i));
    return given;
}

/// The weights of the boundary alone, as rows of all vertices.
SparseWeights boundary_weights(const Mesh& mesh, const BoundaryConditions& conditions)
{
    SparseWeights weights{conditions.columns, {}};
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (std::size_t i = 0; i < conditions.boundary.vertices.size(); ++i)
        for (Index k = 0; k < conditions.values.cols(); ++k)
            if (const double value = conditions.values(static_cast<Index>(i), k); value != 0)
                entries.emplace_back(conditions.boundary.vertices[i], k, value);
    weights.values.resize(vertex_count(mesh), conditions.values.cols());
    weights.values.setFromTriplets(entries.begin(), entries.end());
    return weights;
}

/// The vertices whose weights should sum to one.
std::vector<Index> whole_rows(const PreparedMotion& motion)
{
    std::vector<Index> rows;
    if (motion.lattice && !motion.nonlinear) {
        if (std::holds_alternative<SparseWeights>(motion.weights))
            for (std::size_t v = 0; v < motion.lattice->embedding.inside.size(); ++v)
                if (motion.lattice->embedding.inside[v] != 0)
                    rows.push_back(static_cast<Index>(v));
        return rows;
    }
    std::vector<Index> fixed;
    for (const SharedVertex& shared : motion.curves.conditions.shared)
        if (!shared.fixed_by.empty())
            fixed.push_back(shared.vertex);
    for (const CurveBoundary& boundary : motion.curves.boundaries)
        for (const Index v : boundary.vertices)
            if (std::find(fixed.begin(), fixed.end(), v) == fixed.end())
                rows.push_back(v);
    return rows;
}

} // namespace

const std::vector<ControlPoint>& PreparedMotion::columns() const
{
    return std::visit([](const auto& filled) -> const std::vector<ControlPoint>& { return filled.columns; },
                      weights);
}

WeightsView PreparedMotion::rows() const
{
    return std::visit([](const auto& filled) { return WeightsView(filled); }, weights);
}

std::vector<Index> PreparedMotion::held() const
{
    return lattice ? lattice->held : std::vector<Index>();
}

PreparedMotion prepare_motion(const Mesh& mesh, const MotionSettings& settings, std::optional<Weights> given)
{
    const DeformSettings& deform = settings.deform;
    if (deform.method == Method::ffd) {
        if (needs_nonlinear_motion(deform))
            throw InputError(deform.where +
                             "[deform] rotations, steps, slide and rigid go with methods that carry the "
                             "boundary's move into the mesh, not with \"ffd\"");
        if (given)
            throw InputError(deform.where +
                             "[deform] \"ffd\" has the weights of its lattice and takes no others");
        return motion_of_lattice(mesh, settings);
    }
    PreparedMotion motion;
    if (uses_lattice(settings)) {
        motion.lattice = place_lattice(mesh, settings);
        motion.curves = lattice_boundary(mesh, settings, *motion.lattice);
    } else {
        motion.curves = parametrize_boundaries(mesh, settings);
    }
    motion.displacements = motion.curves.displacements;
    const BoundaryConditions& conditions = motion.curves.conditions;
    if (needs_nonlinear_motion(deform)) {
        if (given)
            require_weights_usable(deform, "the caller");
        motion.nonlinear = nonlinear_motion(motion.curves, settings);
        motion.weights = boundary_weights(mesh, conditions);
    } else {
        motion.weights = given ? on_boundary(std::move(*given), mesh, conditions)
                               : extended_weights(conditions, *make_extension(mesh, conditions.boundary,
                                                                              deform, conditions.values));
    }
    return motion;
}

WeightsCheck check_weights(const PreparedMotion& motion)
{
    const WeightsView rows = motion.rows();
    WeightsCheck check;
    std::vector<double> sums(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
        rows.for_each(row, [&](Eigen::Index, double value) {
            check.min = std::min(check.min, value);
            check.max = std::max(check.max, value);
            sums[static_cast<std::size_t>(row)] += value;
        });
    for (const Index v : whole_rows(motion))
        check.partition_error =
            std::max(check.partition_error, std::abs(sums[static_cast<std::size_t>(v)] - 1));
    return check;
}

} // namespace morph
