#include "libmorph/mesh/nonmanifold_vertices.h"

#include "libmorph/core/parallel.h"

#include <numeric>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 32768;

/// One fan of elements around a vertex.
struct Fan {
    VertexHandle vertex;
    HalfedgeHandle outgoing; ///< one of the halfedges that leave the vertex between its elements
};

/// Visit the outgoing halfedges of a fan, counter-clockwise.
template <typename Visit>
void walk_around(const Kernel& kernel, HalfedgeHandle start, const Visit& visit)
{
    HalfedgeHandle h = start;
    do {
        visit(h);
        h = kernel.ccw_rotated_halfedge_handle(h);
    } while (h != start);
}

/// Number of element corners met on one walk around each vertex. Where that is fewer than there are,
/// some vertex has another fan.
std::size_t corners_in_first_fans(const Kernel& kernel)
{
    const std::size_t n = kernel.n_vertices();
    std::vector<std::size_t> counts((n + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t v = begin; v < end; ++v) {
            const HalfedgeHandle start = kernel.halfedge_handle(VertexHandle(static_cast<Index>(v)));
            if (start.is_valid())
                walk_around(kernel, start, [&](HalfedgeHandle h) { count += kernel.is_boundary(h) ? 0 : 1; });
        }
        counts[begin / kRowsPerBlock] = count;
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::size_t corners(const Kernel& kernel)
{
    const std::size_t n = kernel.n_halfedges();
    std::vector<std::size_t> counts((n + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t h = begin; h < end; ++h)
            count += kernel.is_boundary(HalfedgeHandle(static_cast<Index>(h))) ? 0 : 1;
        counts[begin / kRowsPerBlock] = count;
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// The fans other than the first one of each vertex, in the order of their elements. The first ones are
/// made those that the kernel knows.
std::vector<Fan> further_fans(Kernel& kernel)
{
    std::vector<Fan> further;
    std::vector<HalfedgeHandle> first(kernel.n_vertices());
    std::vector<bool> seen(kernel.n_halfedges());
    for (const FaceHandle face : kernel.faces())
        for (const HalfedgeHandle side : kernel.fh_range(face)) {
            if (seen[static_cast<std::size_t>(side.idx())])
                continue;
            walk_around(kernel, side,
                        [&](HalfedgeHandle h) { seen[static_cast<std::size_t>(h.idx())] = true; });
            const VertexHandle vertex = kernel.from_vertex_handle(side);
            HalfedgeHandle& known = first[static_cast<std::size_t>(vertex.idx())];
            if (known.is_valid())
                further.push_back({vertex, side});
            else
                known = side;
        }
    for (const Fan& fan : further) {
        kernel.set_halfedge_handle(fan.vertex, first[static_cast<std::size_t>(fan.vertex.idx())]);
        kernel.adjust_outgoing_halfedge(fan.vertex);
    }
    return further;
}

void give_own_vertex(Kernel& kernel, const Fan& fan)
{
    const VertexHandle copy = kernel.add_vertex(kernel.point(fan.vertex));
    walk_around(kernel, fan.outgoing, [&](HalfedgeHandle h) {
        kernel.set_vertex_handle(kernel.opposite_halfedge_handle(h), copy);
    });
    kernel.set_halfedge_handle(copy, fan.outgoing);
    kernel.adjust_outgoing_halfedge(copy);
}

} // namespace

std::vector<Index> split_nonmanifold_vertices(Kernel& kernel)
{
    if (corners_in_first_fans(kernel) == corners(kernel))
        return {};
    const std::vector<Fan> fans = further_fans(kernel);
    kernel.reserve(kernel.n_vertices() + fans.size(), kernel.n_edges(), kernel.n_faces());
    std::vector<Index> originals;
    for (const Fan& fan : fans) {
        give_own_vertex(kernel, fan);
        originals.push_back(fan.vertex.idx());
    }
    return originals;
}

} // namespace morph
