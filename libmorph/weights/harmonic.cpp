#include "libmorph/weights/harmonic.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/segment_tree.h"
#include "libmorph/numerics/dirichlet_laplacian.h"
#include "libmorph/weights/walled_triangulation.h"

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
            nearest = tree.nearest(points(mesh).row(static_cast<Index>(v)).transpose(), nearest.segment);
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

std::vector<WeightedEdge> weighted_edges(const Mesh& mesh, const DirichletBoundary& boundary,
                                         const UniqueDirichletVertices& vertices, Diffusivity diffusivity)
{
    std::vector<WeightedEdge> edges =
        stiffness_edges(points(mesh), walled_triangulation(mesh, boundary, vertices));
    const auto x = points(mesh);
    const auto least = [&x](const WeightedEdge& e) { return kLeast * edge_length(x, e); };
    if (diffusivity == Diffusivity::inverse_distance)
        divide_by_mean(distances(mesh, boundary.moving_edges), least, edges);
    if (diffusivity == Diffusivity::inverse_area)
        divide_by_mean(
            mean_areas(mesh), [&](const WeightedEdge& e) { return least(e) * least(e); }, edges);
    return edges;
}

DirichletLaplacian dirichlet_problem(const Mesh& mesh, const DirichletBoundary& boundary,
                                     const UniqueDirichletVertices& vertices, Diffusivity diffusivity)
{
    std::vector<WeightedEdge> edges = weighted_edges(mesh, boundary, vertices, diffusivity);
    join_copies(vertices.representatives(), edges);
    return {points(mesh).leftCols<2>(), edges, vertices.vertices()};
}

class HarmonicExtension final : public BoundaryExtension {
public:
    HarmonicExtension(const Mesh& mesh, const DirichletBoundary& boundary, Diffusivity diffusivity)
        : BoundaryExtension(mesh, boundary), problem_(dirichlet_problem(mesh, boundary, held(), diffusivity))
    {
    }

private:
    Matrix solve(const Matrix& joined) const override { return problem_.solve(joined); }

    DirichletLaplacian problem_;
};

} // namespace

std::unique_ptr<BoundaryExtension> harmonic_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                      Diffusivity diffusivity)
{
    return std::make_unique<HarmonicExtension>(mesh, boundary, diffusivity);
}

} // namespace morph
