#include "libmorph/weights/walled_triangulation.h"

#include <algorithm>
#include <iterator>

namespace morph {

Triangulation walled_triangulation(const Mesh& mesh, const DirichletBoundary& boundary,
                                   const UniqueDirichletVertices& vertices)
{
    const std::vector<Index> row_of = vertices.rows();
    const auto is_prescribed = [&row_of](Index v) { return row_of[static_cast<std::size_t>(v)] >= 0; };
    std::vector<std::array<Index, 2>> walls;
    for (const auto* edges : {&boundary.moving_edges, &boundary.fixed_edges})
        std::copy_if(edges->begin(), edges->end(), std::back_inserter(walls),
                     [&](const auto& edge) { return is_prescribed(edge[0]) && is_prescribed(edge[1]); });
    Triangulation triangulation = triangulate(mesh);
    cut_along(triangulation, walls);
    make_delaunay(points(mesh), triangulation);
    return triangulation;
}

} // namespace morph
