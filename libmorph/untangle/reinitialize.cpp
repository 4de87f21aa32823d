#include "libmorph/untangle/reinitialize.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/dirichlet_laplacian.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr double kLeastArea = 1e-12; // of an edge's square: flat elements must not make g infinite

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

double area_of(const Element& e, const PositionsView& x)
{
    double twice = 0;
    for (std::size_t k = 2; k < static_cast<std::size_t>(corner_count(e)); ++k)
        twice += (x(e[k - 1], 0) - x(e[0], 0)) * (x(e[k], 1) - x(e[0], 1)) -
                 (x(e[k - 1], 1) - x(e[0], 1)) * (x(e[k], 0) - x(e[0], 0));
    return 0.5 * std::abs(twice);
}

/// Mean area of the elements around each vertex.
std::vector<double> mean_areas(const VertexStars& stars, const PositionsView& x)
{
    std::vector<double> area(stars.vertex_of.size());
    for (std::size_t v = 0; v < area.size(); ++v) {
        const std::size_t begin = stars.start[v], end = stars.start[v + 1];
        for (std::size_t i = begin; i < end; ++i)
            area[v] += area_of(stars.elements[at(stars.around[i])], x) / static_cast<double>(end - begin);
    }
    return area;
}

std::vector<WeightedEdge> weighted_edges(const Mesh& mesh, const VertexStars& stars,
                                         const PositionsView& reference)
{
    const std::vector<double> area = mean_areas(stars, reference);
    std::vector<WeightedEdge> edges = stiffness_edges(reference, triangulate(mesh));
    for (WeightedEdge& e : edges) {
        e.a = stars.vertex_of[at(e.a)];
        e.b = stars.vertex_of[at(e.b)];
        const double length = (reference.row(e.a) - reference.row(e.b)).norm();
        e.weight /= std::max(0.5 * (area[at(e.a)] + area[at(e.b)]), kLeastArea * length * length);
    }
    std::erase_if(edges, [](const WeightedEdge& e) { return e.a == e.b || !std::isfinite(e.weight); });
    return edges;
}

} // namespace

std::optional<Matrix> spread_move(const Mesh& mesh, const VertexStars& stars, const PositionsView& reference,
                                  const std::vector<char>& held, const PositionsView& positions)
{
    std::vector<Index> list;
    for (std::size_t v = 0; v < held.size(); ++v)
        if (held[v])
            list.push_back(static_cast<Index>(v));
    Matrix move(static_cast<Index>(list.size()), 2);
    for (Index i = 0; i < move.rows(); ++i)
        move.row(i) = (positions.row(list[at(i)]) - reference.row(list[at(i)])).head<2>();
    try {
        return DirichletLaplacian(reference.leftCols<2>(), weighted_edges(mesh, stars, reference), list)
            .solve(move);
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const SolverError&) {
        return std::nullopt;
    }
}

} // namespace morph
