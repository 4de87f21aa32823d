#include "libmorph/pipeline/detail/polygon_crossings.h"

#include "libmorph/core/names.h"
#include "libmorph/geometry/edge_crossing.h"
#include "libmorph/geometry/misplaced_loop.h"
#include "libmorph/mesh/boundary_loops.h"

#include <algorithm>

namespace morph {

namespace {

using Edge = std::array<Index, 2>;

/// Edges of the boundary, the copies of a split vertex taken as one.
std::vector<Edge> joined_boundary_edges(const Mesh& mesh)
{
    const std::vector<Index> first = representatives(mesh.numbering);
    std::vector<Edge> edges = boundary_edges(mesh);
    for (Edge& edge : edges) {
        const auto [a, b] =
            std::minmax(first[static_cast<std::size_t>(edge[0])], first[static_cast<std::size_t>(edge[1])]);
        edge = {a, b};
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// "the moved boundary 'airfoil'", or without its name when no marker has the edge.
std::string name_of(const Mesh& mesh, const Edge& edge)
{
    const std::vector<Index> first = representatives(mesh.numbering);
    for (const Marker& marker : mesh.markers)
        for (const auto& [a, b] : marker.edges)
            if (std::minmax(first[static_cast<std::size_t>(a)], first[static_cast<std::size_t>(b)]) ==
                std::minmax(edge[0], edge[1]))
                return "the moved boundary '" + marker.name + "'";
    return "the moved boundary";
}

std::vector<std::string> misplaced_loops(const Mesh& mesh, const PositionsView& before,
                                         const PositionsView& after)
{
    const auto loops = boundary_loops(mesh);
    const auto found = find_misplaced_loop(after, loops);
    if (!found || find_misplaced_loop(before, loops))
        return {};
    const std::vector<Index>& loop = loops[*found];
    const std::vector<Index> first = representatives(mesh.numbering);
    const auto [a, b] =
        std::minmax(first[static_cast<std::size_t>(loop[0])], first[static_cast<std::size_t>(loop[1])]);
    return {name_of(mesh, {a, b}) + (loop_orientation(after, loop) == loop_orientation(before, loop)
                                         ? " has left the domain or lies inside another boundary"
                                         : " is turned inside out")};
}

} // namespace

std::vector<std::string> polygon_crossings(const Mesh& mesh, const PositionsView& before,
                                           const PositionsView& after)
{
    const std::vector<Edge> edges = joined_boundary_edges(mesh);
    const auto crossing = find_edge_crossing(after, edges);
    if (!crossing)
        return misplaced_loops(mesh, before, after);
    if (find_edge_crossing(before, edges))
        return {};
    const Edge& one = edges[static_cast<std::size_t>(crossing->edges[0])];
    const Edge& other = edges[static_cast<std::size_t>(crossing->edges[1])];
    const std::string first = name_of(mesh, one);
    const std::string second = name_of(mesh, other);
    return {first + " crosses " + (first == second ? "itself" : second) + " near (" +
            short_number(crossing->point.x()) + ", " + short_number(crossing->point.y()) +
            "), between its nodes"};
}

} // namespace morph
