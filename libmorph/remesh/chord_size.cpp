#include "libmorph/remesh/chord_size.h"

#include "libmorph/remesh/corner_table_mesh.h"
#include "libmorph/remesh/curvature_limit.h"
#include "libmorph/remesh/surface_curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

RemeshState with_features(const Mesh& mesh, const FeatureSettings& features)
{
    std::vector<bool> quads;
    for (const Element& element : element_table(mesh))
        quads.push_back(element[3] >= 0);
    CornerTable table = corner_table_of(mesh, quads);
    const bool planar = mesh.dimension == 2;
    BackgroundMesh background(table, planar);
    RemeshState state{std::move(table), {}, std::move(background), planar};
    find_features(state, mesh, features);
    return state;
}

} // namespace

Eigen::VectorXd chord_sizes(const Mesh& mesh, const FeatureSettings& features, double error)
{
    Eigen::VectorXd radius =
        Eigen::VectorXd::Constant(vertex_count(mesh), std::numeric_limits<double>::infinity());
    const RemeshState state = with_features(mesh, features);
    const CornerTable& table = state.table;
    const auto lower = [&](Index v, double most) {
        double& here = radius[table.vertices[at(v)].origin];
        here = std::min(here, most);
    };
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h)
        if (on_curve(table, h)) {
            const double least = least_radius(state, h);
            lower(table.from[at(h)], least);
            lower(table.to(h), least);
        }
    if (!state.planar) {
        const Eigen::VectorXd curvature = largest_curvature(table);
        for (Index v = 0; v < curvature.size(); ++v)
            lower(v, 1 / curvature[v]);
    }
    return (8 * error * radius).cwiseSqrt();
}

} // namespace morph
