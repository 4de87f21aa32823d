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
    CornerTable net = net_of(mesh, quads);
    const bool planar = mesh.dimension == 2;
    BackgroundMesh underlay(net, planar);
    RemeshState made{std::move(net), {}, std::move(underlay), planar};
    find_features(made, mesh, features);
    return made;
}

} // namespace

Eigen::VectorXd chord_sizes(const Mesh& mesh, const FeatureSettings& features, double error)
{
    Eigen::VectorXd radius =
        Eigen::VectorXd::Constant(vertex_count(mesh), std::numeric_limits<double>::infinity());
    const RemeshState made = with_features(mesh, features);
    const CornerTable& net = made.net;
    const auto lower = [&](Index v, double most) {
        double& here = radius[net.vertices[at(v)].origin];
        here = std::min(here, most);
    };
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h)
        if (on_curve(net, h)) {
            const double least = least_radius(made, h);
            lower(net.from[at(h)], least);
            lower(net.to(h), least);
        }
    if (!made.planar) {
        const Eigen::VectorXd curvature = largest_curvature(net);
        for (Index v = 0; v < curvature.size(); ++v)
            lower(v, 1 / curvature[v]);
    }
    return (8 * error * radius).cwiseSqrt();
}

} // namespace morph
