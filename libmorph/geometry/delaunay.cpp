#include "libmorph/geometry/delaunay.h"

#include "libmorph/core/parallel.h"
#include "libmorph/core/predicates.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192; // triangles a thread takes at a time

/// Side k of triangle t: the edge opposite corner k, from corner k + 1 to corner k + 2.
struct Side {
    Index triangle;
    int k;
};

int after(int k)
{
    return k == 2 ? 0 : k + 1;
}

int before(int k)
{
    return k == 0 ? 2 : k - 1;
}

/// Finds the triangle behind a halfedge when quads have been cut in two.
class TriangleNumbers {
public:
    explicit TriangleNumbers(const Kernel& kernel) : kernel_(kernel), first_(kernel.n_faces() + 1)
    {
        for (std::size_t f = 0; f < kernel.n_faces(); ++f)
            first_[f + 1] = first_[f] + (is_quad(kernel.halfedge_handle(face(f))) ? 2 : 1);
    }

    Index first(std::size_t f) const { return first_[f]; }
    std::size_t total() const { return static_cast<std::size_t>(first_.back()); }
    bool is_quad(HalfedgeHandle h) const
    {
        return kernel_.next_halfedge_handle(kernel_.next_halfedge_handle(kernel_.next_halfedge_handle(h))) !=
               h;
    }

    /// Triangle across halfedge @p h, -1 at the boundary.
    Index across(HalfedgeHandle h) const
    {
        const HalfedgeHandle opposite = kernel_.opposite_halfedge_handle(h);
        const FaceHandle f = kernel_.face_handle(opposite);
        if (!f.is_valid())
            return -1;
        const auto at = static_cast<std::size_t>(f.idx());
        if (first_[at + 1] - first_[at] == 1)
            return first_[at];
        const HalfedgeHandle start = kernel_.halfedge_handle(f);
        return first_[at] + (opposite == start || opposite == kernel_.next_halfedge_handle(start) ? 0 : 1);
    }

    static FaceHandle face(std::size_t f) { return FaceHandle(static_cast<int>(f)); }

private:
    const Kernel& kernel_;
    std::vector<Index> first_;
};

void cut_face(const Kernel& kernel, const TriangleNumbers& numbers, std::size_t f, Triangulation& out)
{
    std::array<Index, 4> corner{};
    std::array<Index, 4> across{};
    HalfedgeHandle h = kernel.halfedge_handle(TriangleNumbers::face(f));
    const std::size_t count = numbers.is_quad(h) ? 4 : 3;
    for (std::size_t i = 0; i < count; ++i, h = kernel.next_halfedge_handle(h)) {
        corner[i] = kernel.from_vertex_handle(h).idx();
        across[i] = numbers.across(h);
    }
    const Index t = numbers.first(f);
    const auto at = static_cast<std::size_t>(t);
    out.corners[at] = {corner[0], corner[1], corner[2]};
    if (count == 3) {
        out.neighbours[at] = {across[1], across[2], across[0]};
        return;
    }
    out.neighbours[at] = {across[1], t + 1, across[0]};
    out.corners[at + 1] = {corner[0], corner[2], corner[3]};
    out.neighbours[at + 1] = {across[2], across[3], t};
}

/// Lawson's flips on one triangulation.
class Flipper {
public:
    Flipper(const Eigen::Ref<const Points>& points, Triangulation& triangulation)
        : points_(points), corners_(triangulation.corners), neighbours_(triangulation.neighbours)
    {
    }

    /// Sides to flip, each once, in the order of the triangles. Most meshes are nearly Delaunay: this
    /// pass is most of the work, and it runs in parallel.
    std::vector<Side> candidates() const
    {
        std::vector<std::vector<Side>> found(corners_.size() / kRowsPerBlock + 1);
        parallel_for(corners_.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t)
                for (int k = 0; k < 3; ++k) {
                    const Side side{static_cast<Index>(t), k};
                    if (neighbour(side) > side.triangle && must_flip(side))
                        found[begin / kRowsPerBlock].push_back(side);
                }
        });
        std::vector<Side> all;
        for (const auto& some : found)
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }

    /// Ends: a flip either lowers the number of triangles that are not positive, or leaves it and
    /// lowers the surface over the triangles lifted to the paraboloid z = x^2 + y^2.
    std::size_t run(std::vector<Side> pending)
    {
        std::size_t flips = 0;
        while (!pending.empty()) {
            const Side side = pending.back();
            pending.pop_back();
            if (neighbour(side) < 0 || !must_flip(side))
                continue;
            const Index other = neighbour(side);
            flip(side);
            ++flips;
            // Every side of both triangles, wherever it has moved: what waits in the list under the
            // old place of a side is not lost.
            for (int k = 0; k < 3; ++k) {
                pending.push_back({side.triangle, k});
                pending.push_back({other, k});
            }
        }
        return flips;
    }

private:
    Index neighbour(Side side) const
    {
        return neighbours_[static_cast<std::size_t>(side.triangle)][at(side.k)];
    }
    Index corner(Index t, int k) const { return corners_[static_cast<std::size_t>(t)][at(k)]; }
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    PlanePoint point(Index v) const { return {points_(v, 0), points_(v, 1)}; }

    /// Side of the neighbour that is this side seen from there.
    Side twin(Side side) const
    {
        const Index other = neighbour(side);
        const Index end = corner(side.triangle, before(side.k)); // follows the twin's corner
        for (int k = 0; k < 3; ++k)
            if (neighbours_[static_cast<std::size_t>(other)][at(k)] == side.triangle &&
                corner(other, after(k)) == end)
                return {other, k};
        return {other, 0}; // not reached: neighbours know each other
    }

    bool must_flip(Side side) const
    {
        const Side there = twin(side);
        const PlanePoint a = point(corner(side.triangle, side.k));
        const PlanePoint b = point(corner(side.triangle, after(side.k)));
        const PlanePoint c = point(corner(side.triangle, before(side.k)));
        const PlanePoint d = point(corner(there.triangle, there.k));
        if (orientation(a, b, c) > 0 && orientation(d, c, b) > 0)
            return in_circle(a, b, c, d) > 0; // then a b d c is strictly convex
        return orientation(a, b, d) > 0 && orientation(a, d, c) > 0;
    }

    /// Triangles (a b c) and (d c b) become (a b d) and (d c a).
    void flip(Side here)
    {
        const Side there = twin(here);
        const Index t = here.triangle;
        const Index s = there.triangle;
        const Index a = corner(t, here.k), b = corner(t, after(here.k)), c = corner(t, before(here.k));
        const Index d = corner(s, there.k);
        const Index beyond_ca = neighbour({t, after(here.k)});
        const Index beyond_ab = neighbour({t, before(here.k)});
        const Index beyond_bd = neighbour({s, after(there.k)});
        const Index beyond_dc = neighbour({s, before(there.k)});
        corners_[static_cast<std::size_t>(t)] = {a, b, d};
        neighbours_[static_cast<std::size_t>(t)] = {beyond_bd, s, beyond_ab};
        corners_[static_cast<std::size_t>(s)] = {d, c, a};
        neighbours_[static_cast<std::size_t>(s)] = {beyond_ca, t, beyond_dc};
        replace(beyond_bd, {d, b}, s, t);
        replace(beyond_ca, {a, c}, t, s);
    }

    /// Triangle @p in has @p now, no longer @p was, across its edge from edge[0] to edge[1].
    void replace(Index in, std::array<Index, 2> edge, Index was, Index now)
    {
        if (in < 0)
            return;
        for (int k = 0; k < 3; ++k)
            if (corner(in, after(k)) == edge[0] && corner(in, before(k)) == edge[1] &&
                neighbour({in, k}) == was) {
                neighbours_[static_cast<std::size_t>(in)][at(k)] = now;
                return;
            }
    }

    const Eigen::Ref<const Points>& points_;
    std::vector<std::array<Index, 3>>& corners_;
    std::vector<std::array<Index, 3>>& neighbours_;
};

} // namespace

Triangulation triangulate(const Mesh& mesh)
{
    const TriangleNumbers numbers(mesh.kernel);
    Triangulation out;
    out.corners.resize(numbers.total());
    out.neighbours.resize(numbers.total());
    parallel_for(mesh.kernel.n_faces(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            cut_face(mesh.kernel, numbers, f, out);
    });
    return out;
}

void cut_along(Triangulation& triangulation, const std::vector<std::array<Index, 2>>& edges)
{
    if (edges.empty())
        return;
    std::vector<std::array<Index, 2>> sorted;
    sorted.reserve(edges.size());
    for (const auto& [a, b] : edges)
        sorted.push_back({std::min(a, b), std::max(a, b)});
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t t = 0; t < triangulation.corners.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Index a = triangulation.corners[t][static_cast<std::size_t>(after(k))];
            const Index b = triangulation.corners[t][static_cast<std::size_t>(before(k))];
            if (std::binary_search(sorted.begin(), sorted.end(), std::array{std::min(a, b), std::max(a, b)}))
                triangulation.neighbours[t][static_cast<std::size_t>(k)] = -1;
        }
}

std::size_t make_delaunay(const Eigen::Ref<const Points>& points, Triangulation& triangulation)
{
    Flipper flipper(points, triangulation);
    return flipper.run(flipper.candidates());
}

} // namespace morph
