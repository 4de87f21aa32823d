#include "libmorph/weights/harmonic.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/segment_tree.h"
#include "libmorph/weights/unique_dirichlet_vertices.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192; // edges or vertices a thread takes at a time

// No distance or root of an area counts as less than this part of an edge's length: a vertex that lies on a
// moving edge in a tangled mesh must not make g infinite. Boundary layers stay far above it.
constexpr double kLeast = 1e-9;

/// Let the copies of split vertices be one in the edges.
void join_copies(const std::vector<Index>& representative, std::vector<WeightedEdge>& edges)
{
    for (WeightedEdge& e : edges) {
        e.a = representative[static_cast<std::size_t>(e.a)];
        e.b = representative[static_cast<std::size_t>(e.b)];
    }
    std::erase_if(edges, [](const WeightedEdge& e) { return e.a == e.b; });
}

double edge_length(const Eigen::Ref<const Points>& x, const WeightedEdge& e)
{
    return std::hypot(x(e.a, 0) - x(e.b, 0), x(e.a, 1) - x(e.b, 1));
}

/// Divide each weight by the mean of a length or an area at the two ends.
template <typename Least>
void divide_by_mean(const std::vector<double>& size, const Least& least, std::vector<WeightedEdge>& edges)
{
    parallel_for(edges.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            WeightedEdge& e = edges[i];
            const double mean =
                0.5 * (size[static_cast<std::size_t>(e.a)] + size[static_cast<std::size_t>(e.b)]);
            e.weight /= std::max(mean, least(e));
        }
    });
}

/// Distance of each vertex to the nearest moving edge.
std::vector<double> distances(const Mesh& mesh, const std::vector<std::array<Index, 2>>& moving_edges)
{
    const SegmentTree tree(points(mesh), moving_edges);
    std::vector<double> distance(static_cast<std::size_t>(vertex_count(mesh)));
    parallel_for(distance.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        SegmentTree::Nearest nearest; // neighbours in the numbering are neighbours in the plane
        for (std::size_t v = begin; v < end; ++v) {
            const auto at = points(mesh).row(static_cast<Index>(v));
            nearest = tree.nearest(at[0], at[1], nearest.segment);
            distance[v] = nearest.distance;
        }
    });
    return distance;
}

/// Mean area of the elements around each vertex.
std::vector<double> mean_areas(const Mesh& mesh)
{
    const auto x = points(mesh);
    std::vector<double> area(static_cast<std::size_t>(vertex_count(mesh)));
    std::vector<Index> count(area.size());
    for (const Element& corners : element_table(mesh)) {
        double twice = 0;
        const auto n = static_cast<std::size_t>(corner_count(corners));
        for (std::size_t k = 2; k < n; ++k) {
            const Index a = corners[0], b = corners[k - 1], c = corners[k];
            twice += (x(b, 0) - x(a, 0)) * (x(c, 1) - x(a, 1)) - (x(b, 1) - x(a, 1)) * (x(c, 0) - x(a, 0));
        }
        for (std::size_t k = 0; k < n; ++k) {
            area[static_cast<std::size_t>(corners[k])] += 0.5 * std::abs(twice);
            ++count[static_cast<std::size_t>(corners[k])];
        }
    }
    for (std::size_t v = 0; v < area.size(); ++v)
        area[v] /= std::max(count[v], 1);
    return area;
}

std::vector<WeightedEdge> weighted_edges(const Mesh& mesh, const DirichletBoundary& held,
                                         Diffusivity diffusivity)
{
    Triangulation triangulation = triangulate(mesh);
    cut_along(triangulation, held.walls);
    make_delaunay(points(mesh), triangulation);
    std::vector<WeightedEdge> edges = stiffness_edges(points(mesh), triangulation);
    const auto x = points(mesh);
    const auto least = [&x](const WeightedEdge& e) { return kLeast * edge_length(x, e); };
    if (diffusivity == Diffusivity::inverse_distance)
        divide_by_mean(distances(mesh, held.moving_edges), least, edges);
    if (diffusivity == Diffusivity::inverse_area)
        divide_by_mean(
            mean_areas(mesh), [&](const WeightedEdge& e) { return least(e) * least(e); }, edges);
    return edges;
}

DirichletLaplacian dirichlet_problem(const Mesh& mesh, const DirichletBoundary& held,
                                     const UniqueDirichletVertices& vertices, Diffusivity diffusivity)
{
    std::vector<WeightedEdge> edges = weighted_edges(mesh, held, diffusivity);
    join_copies(vertices.representatives(), edges);
    return {points(mesh), edges, vertices.vertices()};
}

class HarmonicSpread final : public BoundaryExtension {
public:
    HarmonicSpread(const Mesh& mesh, const DirichletBoundary& held, Diffusivity diffusivity)
        : held_(mesh, held), problem_(dirichlet_problem(mesh, held, held_, diffusivity))
    {
    }

    Matrix extend(const Matrix& values) const override
    {
        const Matrix joined = held_.join(values);
        Matrix h = problem_.solve(joined);
        held_.finish(joined, h);
        return h;
    }

private:
    UniqueDirichletVertices held_;
    DirichletLaplacian problem_;
};

} // namespace

std::unique_ptr<BoundaryExtension> harmonic_extension(const Mesh& mesh, const DirichletBoundary& held,
                                                      Diffusivity diffusivity)
{
    return std::make_unique<HarmonicSpread>(mesh, held, diffusivity);
}

Matrix harmonic_weights(const Mesh& mesh, const HarmonicProblem& problem, Diffusivity diffusivity)
{
    const DirichletBoundary held{problem.held.vertices, problem.moving_edges, problem.walls};
    return HarmonicSpread(mesh, held, diffusivity).extend(problem.held.values);
}

} // namespace morph
