#include "libmorph/mesh/chain.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <unordered_map>

namespace morph {

namespace {

constexpr Index kNone = -1;

/// The at most two edges that meet at a vertex of a marker.
struct EdgePair {
    Index first = kNone;
    Index second = kNone;
};

class ChainWalker {
public:
    ChainWalker(const Marker& marker, const Numbering& numbering)
        : marker_(marker), used_(marker.edges.size())
    {
        for (std::size_t e = 0; e < marker.edges.size(); ++e)
            for (const Index v : marker.edges[e])
                attach(v, static_cast<Index>(e), numbering);
    }

    bool used(std::size_t edge) const { return used_[edge]; }

    Chain walk_from(std::size_t first_edge)
    {
        const Index start = end_of_chain(first_edge);
        Chain chain;
        std::size_t forward = 0;
        Index vertex = start;
        for (Index edge = unused_edge_at(vertex); edge != kNone; edge = unused_edge_at(vertex)) {
            const auto& ends = marker_.edges[static_cast<std::size_t>(edge)];
            used_[static_cast<std::size_t>(edge)] = true;
            chain.vertices.push_back(vertex);
            forward += ends[0] == vertex ? 1 : 0;
            vertex = ends[0] == vertex ? ends[1] : ends[0];
        }
        const std::size_t edges = chain.vertices.size();
        chain.closed = vertex == start;
        if (!chain.closed)
            chain.vertices.push_back(vertex);
        if (2 * forward < edges)
            std::reverse(chain.vertices.begin() + (chain.closed ? 1 : 0), chain.vertices.end());
        return chain;
    }

private:
    void attach(Index v, Index edge, const Numbering& numbering)
    {
        EdgePair& pair = edges_at_[v];
        if (pair.first != kNone && same_edge(pair.first, edge))
            throw InputError(
                "marker '" + marker_.name + "' lists the edge between vertices " +
                file_number(marker_.edges[static_cast<std::size_t>(edge)][0], numbering) + " and " +
                file_number(marker_.edges[static_cast<std::size_t>(edge)][1], numbering) + " twice");
        if (pair.second != kNone)
            throw InputError("marker '" + marker_.name + "' branches at vertex " + file_number(v, numbering) +
                             ": more than two of its edges meet there");
        (pair.first == kNone ? pair.first : pair.second) = edge;
    }

    static std::string file_number(Index v, const Numbering& numbering)
    {
        return std::to_string(numbering.vertex[static_cast<std::size_t>(v)]);
    }

    bool same_edge(Index a, Index b) const
    {
        const auto& [from, to] = marker_.edges[static_cast<std::size_t>(a)];
        const auto& other = marker_.edges[static_cast<std::size_t>(b)];
        return std::minmax(from, to) == std::minmax(other[0], other[1]);
    }

    Index unused_edge_at(Index v) const
    {
        const EdgePair& pair = edges_at_.at(v);
        for (const Index edge : {pair.first, pair.second})
            if (edge != kNone && !used_[static_cast<std::size_t>(edge)])
                return edge;
        return kNone;
    }

    /// Walks against the edges' direction to an end; back at its own start for a closed chain.
    Index end_of_chain(std::size_t first_edge) const
    {
        const Index start = marker_.edges[first_edge][0];
        Index vertex = start;
        Index edge = static_cast<Index>(first_edge);
        for (;;) {
            const EdgePair& pair = edges_at_.at(vertex);
            const Index next = pair.first == edge ? pair.second : pair.first;
            if (next == kNone)
                return vertex;
            const auto& ends = marker_.edges[static_cast<std::size_t>(next)];
            vertex = ends[0] == vertex ? ends[1] : ends[0];
            edge = next;
            if (vertex == start || edge == static_cast<Index>(first_edge))
                return start;
        }
    }

    const Marker& marker_;
    std::unordered_map<Index, EdgePair> edges_at_;
    std::vector<bool> used_;
};

/// The marker with one copy of each split vertex that it passes through: in the file it is one vertex
/// there. Where more than two edges of the marker meet the copies stay, as they keep its loops apart.
Marker joined_at_copies(Marker marker, const Numbering& numbering)
{
    const auto file_number = [&](Index v) { return numbering.vertex[static_cast<std::size_t>(v)]; };
    std::unordered_map<Index, int> edges_at;
    std::unordered_map<Index, Index> first_copy;
    for (const auto& edge : marker.edges)
        for (const Index v : edge) {
            ++edges_at[file_number(v)];
            first_copy.emplace(file_number(v), v);
        }
    for (auto& edge : marker.edges)
        for (Index& v : edge)
            if (edges_at[file_number(v)] <= 2)
                v = first_copy[file_number(v)];
    return marker;
}

} // namespace

std::vector<Chain> marker_chains(const Marker& marker, const Numbering& numbering)
{
    if (marker.edges.empty())
        throw InputError("marker '" + marker.name + "' has no edges");
    const bool split = static_cast<std::size_t>(numbering.file_vertices) < numbering.vertex.size();
    const Marker joined = split ? joined_at_copies(marker, numbering) : marker;
    ChainWalker walker(joined, numbering);
    std::vector<Chain> chains;
    for (std::size_t e = 0; e < marker.edges.size(); ++e)
        if (!walker.used(e))
            chains.push_back(walker.walk_from(e));
    return chains;
}

Chain marker_chain(const Marker& marker, const Numbering& numbering)
{
    std::vector<Chain> chains = marker_chains(marker, numbering);
    if (chains.size() > 1)
        throw InputError(
            "marker '" + marker.name + "' is in " + std::to_string(chains.size()) +
            " pieces, but a curve needs one chain of edges; give each piece a marker of its own");
    return std::move(chains.front());
}

} // namespace morph
