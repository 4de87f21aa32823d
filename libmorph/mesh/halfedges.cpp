#include "libmorph/mesh/halfedges.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 32768;

/// A side in the bucket of its smaller vertex, packed so that sorting the numbers sorts by larger
/// vertex, then by element.
class Side {
public:
    Side() = default;
    Side(Index larger, std::size_t element, std::size_t corner, bool from_larger)
        : bits_(static_cast<std::uint64_t>(larger) << 33 | element << 3 | corner << 1 |
                (from_larger ? 1U : 0U))
    {
    }

    Index larger() const { return static_cast<Index>(bits_ >> 33); }
    std::size_t element() const { return (bits_ & 0x1ffffffffU) >> 3; }
    std::size_t corner() const { return (bits_ >> 1) & 3U; }
    bool from_larger() const { return (bits_ & 1U) != 0; }
    bool operator<(Side other) const { return bits_ < other.bits_; }

private:
    std::uint64_t bits_;
};

/// Every side of every element, by its smaller vertex.
struct Buckets {
    std::vector<Index> first; ///< n + 1
    std::vector<Side> sides;

    std::span<Side> of(std::size_t v) { return {sides.data() + first[v], sides.data() + first[v + 1]}; }
};

template <typename Visit>
void for_each_side(const Element& element, const Visit& visit)
{
    const auto n = static_cast<std::size_t>(corner_count(element));
    for (std::size_t k = 0; k < n; ++k)
        visit(k, element[k], element[k + 1 == n ? 0 : k + 1]);
}

Buckets fill_buckets(const std::vector<Element>& elements, Index vertices)
{
    Buckets buckets;
    buckets.first.assign(static_cast<std::size_t>(vertices) + 2, 0);
    for (const Element& element : elements)
        for_each_side(element, [&](std::size_t, Index from, Index to) {
            ++buckets.first[static_cast<std::size_t>(std::min(from, to)) + 2];
        });
    for (std::size_t v = 2; v < buckets.first.size(); ++v)
        buckets.first[v] += buckets.first[v - 1];
    buckets.sides.resize(static_cast<std::size_t>(buckets.first.back()));
    for (std::size_t f = 0; f < elements.size(); ++f)
        for_each_side(elements[f], [&](std::size_t k, Index from, Index to) {
            const auto smaller = static_cast<std::size_t>(std::min(from, to));
            const auto place = static_cast<std::size_t>(buckets.first[smaller + 1]++);
            buckets.sides[place] = Side(std::max(from, to), f, k, from > to);
        });
    buckets.first.pop_back();
    return buckets;
}

[[noreturn]] void throw_complex_edge(std::size_t smaller, std::span<const Side> run,
                                     const Numbering& numbering)
{
    constexpr std::size_t kMostNamed = 8;
    std::string elements;
    for (std::size_t i = 0; i < std::min(run.size(), kMostNamed); ++i)
        elements += (i == 0 ? "" : ", ") + std::to_string(numbering.element[run[i].element()]);
    if (run.size() > kMostNamed)
        elements += ", …";
    const auto [first, second] =
        std::minmax(numbering.vertex[smaller], numbering.vertex[static_cast<std::size_t>(run[0].larger())]);
    throw InputError("the edge between vertices " + std::to_string(first) + " and " + std::to_string(second) +
                     " belongs to " + std::to_string(run.size()) + " elements (" + elements +
                     "), but at most two can share an edge");
}

/// Number of sides at the front of a sorted bucket that are the same edge.
std::size_t first_run(std::span<const Side> bucket)
{
    std::size_t length = 1;
    while (length < bucket.size() && bucket[length].larger() == bucket[0].larger())
        ++length;
    return length;
}

/// Sort a bucket, check its edges, and count them.
Index sort_and_count(std::span<Side> bucket, std::size_t smaller, const Numbering& numbering,
                     std::atomic<bool>& consistent)
{
    std::sort(bucket.begin(), bucket.end());
    Index edges = 0;
    for (std::span<const Side> rest = bucket; !rest.empty(); ++edges) {
        const std::size_t run = first_run(rest);
        if (run > 2)
            throw_complex_edge(smaller, rest.first(run), numbering);
        if (run == 2 && rest[0].from_larger() == rest[1].from_larger())
            consistent = false;
        rest = rest.subspan(run);
    }
    return edges;
}

/// Number the edges of a sorted bucket from @p edge on.
void number_sides(std::span<const Side> bucket, Index edge, std::vector<std::array<Index, 4>>& sides)
{
    for (std::size_t i = 0; i < bucket.size(); ++i) {
        if (i > 0 && bucket[i].larger() != bucket[i - 1].larger())
            ++edge;
        sides[bucket[i].element()][bucket[i].corner()] = 2 * edge + (bucket[i].from_larger() ? 1 : 0);
    }
}

/// The sides of the elements, and each as the halfedge of its vertices. Every element writes to its own.
void link_elements(Kernel& kernel, const std::vector<Element>& elements, const EdgeTable& edges)
{
    parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const FaceHandle face(static_cast<Index>(f));
            const auto& sides = edges.sides[f];
            const auto n = static_cast<std::size_t>(corner_count(elements[f]));
            HalfedgeHandle previous(sides[n - 1]);
            kernel.set_halfedge_handle(face, previous); // circulators start at the end of this one: corner 0
            for (std::size_t k = 0; k < n; ++k) {
                const HalfedgeHandle side(sides[k]);
                kernel.set_face_handle(side, face);
                kernel.set_vertex_handle(side, VertexHandle(elements[f][k + 1 == n ? 0 : k + 1]));
                kernel.set_next_halfedge_handle(previous, side);
                previous = side;
            }
        }
    });
}

/// An outgoing halfedge for each vertex: a side of its first element.
void link_vertices(Kernel& kernel, const std::vector<Element>& elements, const EdgeTable& edges)
{
    for (std::size_t f = elements.size(); f-- > 0;)
        for_each_side(elements[f], [&](std::size_t k, Index from, Index) {
            kernel.set_halfedge_handle(VertexHandle(from), HalfedgeHandle(edges.sides[f][k]));
        });
}

/// The boundary halfedge that follows a boundary halfedge in the fan of elements at its end.
HalfedgeHandle next_on_boundary(const Kernel& kernel, HalfedgeHandle boundary)
{
    HalfedgeHandle around = kernel.opposite_halfedge_handle(boundary);
    while (!kernel.is_boundary(around))
        around = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(around));
    return around;
}

/// Everything of the halfedges without a face; boundary vertices get one of them.
void link_boundary(Kernel& kernel)
{
    std::vector<HalfedgeHandle> boundary;
    for (Index h = 0; h < static_cast<Index>(kernel.n_halfedges()); ++h)
        if (kernel.is_boundary(HalfedgeHandle(h)))
            boundary.emplace_back(h);
    for (const HalfedgeHandle h : boundary) {
        const HalfedgeHandle before = kernel.prev_halfedge_handle(kernel.opposite_halfedge_handle(h));
        kernel.set_vertex_handle(h, kernel.to_vertex_handle(before));
    }
    for (const HalfedgeHandle h : boundary) {
        kernel.set_next_halfedge_handle(h, next_on_boundary(kernel, h));
        kernel.set_halfedge_handle(kernel.from_vertex_handle(h), h);
    }
}

} // namespace

EdgeTable match_edges(const std::vector<Element>& elements, Index vertices, const Numbering& numbering)
{
    Buckets buckets = fill_buckets(elements, vertices);
    const auto n = static_cast<std::size_t>(vertices);
    EdgeTable table;
    table.first_edge.assign(n + 1, 0);
    std::atomic<bool> consistent{true};
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            table.first_edge[v + 1] = sort_and_count(buckets.of(v), v, numbering, consistent);
    });
    table.consistent = consistent;
    for (std::size_t v = 0; v < n; ++v)
        table.first_edge[v + 1] += table.first_edge[v];

    table.sides.assign(elements.size(), {-1, -1, -1, -1});
    parallel_for(n, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            number_sides(buckets.of(v), table.first_edge[v], table.sides);
    });
    return table;
}

void fill_kernel(Kernel& kernel, const std::vector<Element>& elements, const EdgeTable& edges)
{
    kernel.resize(kernel.n_vertices(), static_cast<std::size_t>(edges.edge_count()), elements.size());
    link_elements(kernel, elements, edges);
    link_vertices(kernel, elements, edges);
    link_boundary(kernel);
}

Index find_halfedge(const Kernel& kernel, const EdgeTable& edges, Index from, Index to)
{
    const auto smaller = static_cast<std::size_t>(std::min(from, to));
    const Index larger = std::max(from, to);
    Index low = edges.first_edge[smaller];
    Index high = edges.first_edge[smaller + 1];
    const auto end_of = [&](Index edge) { return kernel.to_vertex_handle(HalfedgeHandle(2 * edge)).idx(); };
    while (low < high) {
        const Index middle = low + (high - low) / 2;
        if (end_of(middle) < larger)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == edges.first_edge[smaller + 1] || end_of(low) != larger)
        return -1;
    return 2 * low + (from > to ? 1 : 0);
}

} // namespace morph
