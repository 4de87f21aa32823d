#include "libmorph/numerics/dof_map.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <string>

namespace morph {

DofMap::DofMap(const std::vector<bool>& joined, const std::vector<Index>& held)
    : place_(joined.size(), kAlone)
{
    for (std::size_t v = 0; v < joined.size(); ++v)
        if (joined[v])
            place_[v] = 0;
    for (std::size_t i = 0; i < held.size(); ++i)
        hold(held[i], static_cast<Index>(i));
    for (Index& p : place_)
        if (p >= 0)
            p = free_++;
}

void DofMap::hold(Index v, Index i)
{
    if (v < 0 || static_cast<std::size_t>(v) >= place_.size())
        throw InputError("held vertex " + std::to_string(v) + " is out of range, there are " +
                         std::to_string(place_.size()) + " vertices");
    if (is_held(v))
        throw InputError("vertex " + std::to_string(v) + " is held twice");
    place_[static_cast<std::size_t>(v)] = -2 - i;
}

Matrix DofMap::free_points(const Eigen::Ref<const Matrix>& points) const
{
    Matrix where(free_, points.cols());
    for (Index v = 0; v < points.rows(); ++v)
        if (const Index r = row(v); r >= 0)
            where.row(r) = points.row(v);
    return where;
}

namespace {

/// The connected parts of a graph: for each row the number of its part, from 0.
std::vector<Index> parts_of(const SymmetricMatrix& graph, Index& count)
{
    std::vector<Index> part(graph.diagonal.size(), -1);
    std::vector<Index> pending;
    count = 0;
    for (Index first = 0; first < graph.rows(); ++first) {
        if (part[static_cast<std::size_t>(first)] >= 0)
            continue;
        part[static_cast<std::size_t>(first)] = count;
        pending.push_back(first);
        while (!pending.empty()) {
            const auto i = static_cast<std::size_t>(pending.back());
            pending.pop_back();
            for (std::size_t e = graph.start[i]; e < graph.start[i + 1]; ++e)
                if (Index& p = part[static_cast<std::size_t>(graph.column[e])]; p < 0) {
                    p = count;
                    pending.push_back(graph.column[e]);
                }
        }
        ++count;
    }
    return part;
}

} // namespace

void require_dirichlet_on_every_component(const SymmetricMatrix& graph,
                                          const std::vector<DirichletNeighbour>& held, int least)
{
    Index parts = 0;
    const std::vector<Index> part = parts_of(graph, parts);
    std::vector<std::vector<Index>> seen(static_cast<std::size_t>(parts)); // no more than asked for
    for (const DirichletNeighbour& h : held) {
        std::vector<Index>& known = seen[static_cast<std::size_t>(part[static_cast<std::size_t>(h.row)])];
        if (known.size() < static_cast<std::size_t>(least) &&
            std::find(known.begin(), known.end(), h.held) == known.end())
            known.push_back(h.held);
    }
    const auto loose = std::count_if(seen.begin(), seen.end(), [least](const std::vector<Index>& known) {
        return known.size() < static_cast<std::size_t>(least);
    });
    if (loose > 0)
        throw InputError(
            std::to_string(loose) + (loose == 1 ? " part of the mesh has " : " parts of the mesh have ") +
            (least == 1 ? "no held vertex" : "fewer than " + std::to_string(least) + " held vertices") +
            "; hold at least one marker on each part");
}

} // namespace morph
