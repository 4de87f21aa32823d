#include "libmorph/weights/rbf_setup.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

double diagonal(const Eigen::Ref<const Points>& x)
{
    return x.rows() == 0 ? 0 : (x.colwise().maxCoeff() - x.colwise().minCoeff()).head<2>().norm();
}

void require_distinct_places(const DomainView& domain, const std::vector<Index>& vertices)
{
    const auto x = domain.positions();
    std::vector<Index> by_place = vertices;
    const auto before = [&x](Index a, Index b) {
        return x(a, 0) != x(b, 0) ? x(a, 0) < x(b, 0) : x(a, 1) < x(b, 1);
    };
    std::sort(by_place.begin(), by_place.end(), before);
    const auto same =
        std::adjacent_find(by_place.begin(), by_place.end(), [&](Index a, Index b) { return !before(a, b); });
    if (same != by_place.end())
        throw InputError("vertices " + std::to_string(domain.file_vertex(same[0])) + " and " +
                         std::to_string(domain.file_vertex(same[1])) + " are held at the same place, (" +
                         number_text(x(*same, 0)) + ", " + number_text(x(*same, 1)) +
                         "): radial functions cannot distinguish them");
}

} // namespace

double default_support(const DomainView& domain, const DirichletBoundary& boundary)
{
    std::vector<Index> moving;
    for (const auto& edge : boundary.moving_edges)
        moving.insert(moving.end(), edge.begin(), edge.end());
    const double whole = diagonal(domain.positions());
    const double body = diagonal(domain.positions()(moving, Eigen::all));
    return body > 0 ? std::min(kSupportFactor * body, whole) : whole;
}

double support_radius(const DomainView& domain, const DirichletBoundary& boundary, const RbfOptions& options)
{
    if (!(options.support >= 0 && std::isfinite(options.support)))
        throw InputError("the support radius of the radial functions is " + number_text(options.support) +
                         ", but it must be positive, or 0 for the default");
    if (options.function == RadialFunction::thin_plate && !options.linear)
        throw InputError("thin plate splines need linear terms; switch them on or take a Wendland function");
    const double support = options.support > 0 ? options.support : default_support(domain, boundary);
    if (!(support > 0))
        throw InputError("the mesh has no extent: radial functions need a support radius");
    return support;
}

RadialInterpolant radial_interpolant(const DomainView& domain, const std::vector<Index>& vertices,
                                     const RbfOptions& options, double support)
{
    require_distinct_places(domain, vertices);
    return {domain.positions()(vertices, Eigen::all), options.function, support, options.linear};
}

} // namespace morph
