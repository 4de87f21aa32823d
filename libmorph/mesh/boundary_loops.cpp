#include "libmorph/mesh/boundary_loops.h"

#include <algorithm>

namespace morph {

std::vector<std::array<Index, 2>> boundary_edges(const Mesh& mesh)
{
    std::vector<std::array<Index, 2>> edges;
    for (const auto edge : mesh.kernel.edges())
        if (edge.is_boundary())
            edges.push_back({edge.v0().idx(), edge.v1().idx()});
    return edges;
}

std::vector<std::vector<Index>> boundary_loops(const Mesh& mesh)
{
    const Kernel& kernel = mesh.kernel;
    std::vector<std::vector<Index>> loops;
    std::vector<bool> seen(kernel.n_halfedges());
    for (const auto first : kernel.halfedges()) {
        if (!kernel.is_boundary(first) || seen[static_cast<std::size_t>(first.idx())])
            continue;
        std::vector<Index>& loop = loops.emplace_back();
        for (auto half = Kernel::HalfedgeHandle(first); !seen[static_cast<std::size_t>(half.idx())];
             half = kernel.next_halfedge_handle(half)) {
            seen[static_cast<std::size_t>(half.idx())] = true;
            loop.push_back(kernel.to_vertex_handle(half).idx());
        }
        std::reverse(loop.begin(), loop.end()); // a halfedge of the boundary has the mesh on its right
    }
    return loops;
}

} // namespace morph
