#include "libmorph/weights/harmonic.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kGrain = 8192; // edges or vertices a thread takes at a time

// No distance or root of an area counts as less than this part of an edge's length: a vertex that lies on a
// moving edge in a tangled mesh must not make g infinite. Boundary layers stay far above it.
constexpr double kLeast = 1e-9;

void require_valid(const Mesh& mesh, const HarmonicProblem& problem)
{
    if (mesh.dimension != 2)
        throw InputError("harmonic weights need a planar mesh, but this is a surface in space");
    const DirichletSet& held = problem.held;
    if (static_cast<std::size_t>(held.values.rows()) != held.vertices.size())
        throw InputError(std::to_string(held.values.rows()) + " rows of values are given for " +
                         std::to_string(held.vertices.size()) + " held vertices");
    const Index n = vertex_count(mesh);
    const auto require_vertex = [n](Index v, const char* what) {
        if (v < 0 || v >= n)
            throw InputError(std::string(what) + " names vertex " + std::to_string(v) +
                             ", but the mesh has " + std::to_string(n));
    };
    for (const Index v : held.vertices)
        require_vertex(v, "the held set");
    for (const auto& [a, b] : problem.moving_edges) {
        require_vertex(a, "a moving edge");
        require_vertex(b, "a moving edge");
    }
    if (!held.values.allFinite())
        throw InputError("the held values are not all finite");
}

/// Vertex that stands for each vertex: the first copy of one that is split, else itself.
std::vector<Index> representatives(const Numbering& numbering)
{
    std::vector<Index> of_file(static_cast<std::size_t>(numbering.file_vertices), -1);
    std::vector<Index> representative(numbering.vertex.size());
    for (std::size_t v = 0; v < representative.size(); ++v) {
        Index& first = of_file[static_cast<std::size_t>(numbering.vertex[v])];
        if (first < 0)
            first = static_cast<Index>(v);
        representative[v] = first;
    }
    return representative;
}

/// Let the copies of split vertices be one in the edges.
void join_copies(const std::vector<Index>& representative, std::vector<WeightedEdge>& edges)
{
    for (WeightedEdge& e : edges) {
        e.a = representative[static_cast<std::size_t>(e.a)];
        e.b = representative[static_cast<std::size_t>(e.b)];
    }
    std::erase_if(edges, [](const WeightedEdge& e) { return e.a == e.b; });
}

/// The held set with each split vertex once.
DirichletSet join_copies(const Mesh& mesh, const std::vector<Index>& representative, const DirichletSet& held)
{
    DirichletSet joined{{}, Matrix(held.values.rows(), held.values.cols())};
    std::vector<Index> row_of(representative.size(), -1);
    for (std::size_t i = 0; i < held.vertices.size(); ++i) {
        const Index v = representative[static_cast<std::size_t>(held.vertices[i])];
        const auto row = static_cast<Index>(i);
        Index& known = row_of[static_cast<std::size_t>(v)];
        if (known < 0) {
            known = static_cast<Index>(joined.vertices.size());
            joined.values.row(known) = held.values.row(row);
            joined.vertices.push_back(v);
        } else if (joined.values.row(known) != held.values.row(row))
            throw InputError("vertex " + std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(v)]) +
                             " is held twice with different values");
    }
    joined.values.conservativeResize(static_cast<Index>(joined.vertices.size()), Eigen::NoChange);
    return joined;
}

double edge_length(const Eigen::Ref<const Points>& x, const WeightedEdge& e)
{
    return std::hypot(x(e.a, 0) - x(e.b, 0), x(e.a, 1) - x(e.b, 1));
}

/// Divide each weight by the mean of a length or an area at the two ends.
template <typename Least>
void divide_by_mean(const std::vector<double>& size, const Least& least, std::vector<WeightedEdge>& edges)
{
    parallel_for(edges.size(), kGrain, [&](std::size_t begin, std::size_t end) {
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
    parallel_for(distance.size(), kGrain, [&](std::size_t begin, std::size_t end) {
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

std::vector<WeightedEdge> weighted_edges(const Mesh& mesh, const HarmonicProblem& problem,
                                         Diffusivity diffusivity)
{
    Triangulation triangulation = triangulate(mesh);
    cut_along(triangulation, problem.walls);
    make_delaunay(points(mesh), triangulation);
    std::vector<WeightedEdge> edges = stiffness_edges(points(mesh), triangulation);
    const auto x = points(mesh);
    const auto least = [&x](const WeightedEdge& e) { return kLeast * edge_length(x, e); };
    if (diffusivity == Diffusivity::inverse_distance)
        divide_by_mean(distances(mesh, problem.moving_edges), least, edges);
    if (diffusivity == Diffusivity::inverse_area)
        divide_by_mean(
            mean_areas(mesh), [&](const WeightedEdge& e) { return least(e) * least(e); }, edges);
    return edges;
}

} // namespace

Matrix harmonic_weights(const Mesh& mesh, const HarmonicProblem& problem, Diffusivity diffusivity)
{
    require_valid(mesh, problem);
    std::vector<WeightedEdge> edges = weighted_edges(mesh, problem, diffusivity);
    if (mesh.numbering.file_vertices == vertex_count(mesh))
        return DirichletProblem(points(mesh), edges, problem.held.vertices).solve(problem.held.values);

    const std::vector<Index> representative = representatives(mesh.numbering);
    join_copies(representative, edges);
    const DirichletSet held = join_copies(mesh, representative, problem.held);
    Matrix h = DirichletProblem(points(mesh), edges, held.vertices).solve(held.values);
    for (std::size_t v = 0; v < representative.size(); ++v)
        h.row(static_cast<Index>(v)) = h.row(representative[v]);
    return h;
}

} // namespace morph
