#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace morph {

/// What holds a vertex during remeshing: nothing, everything, or (0 and up) the feature curve it is on.
inline constexpr Index kFreeVertex = -1;
inline constexpr Index kFixedVertex = -2;

/// A vertex of a CornerTable.
struct TableVertex {
    Eigen::Vector3d point;
    double size = 0;           ///< target edge length here
    double u = 0;              ///< on a feature curve: its parameter
    Index curve = kFreeVertex; ///< number of the feature curve, kFreeVertex or kFixedVertex
    Index out = -1;            ///< a halfedge from here, at a border the one with nothing on its right;
                               ///  -1: the vertex is gone
    Index below = 0;           ///< triangle of the background mesh it lies in
    Index origin = -1;         ///< vertex of the input that it is; -1: new
};

/// What an edge is besides an edge: twice the number of its feature curve, plus 1 where the halfedge runs
/// against the parameter; none of that; or a side of an element that is kept as it is.
inline constexpr Index kNoTag = -1;
inline constexpr Index kKeptTag = 1 << 30;

/// Triangles whose edges can be split, collapsed and flipped, in flat arrays.
///
/// Halfedge 3 t + k runs from corner k of triangle t to the next.
class CornerTable {
public:
    std::vector<TableVertex> vertices;
    std::vector<Index> from; ///< 3m: vertex a halfedge starts at; from[3t] = -1: triangle t is gone
    std::vector<Index> twin; ///< 3m: halfedge the other way; -1 at a border
    std::vector<Index> tag;  ///< 3m: feature curve of the edge, see kNoTag

    CornerTable() = default;
    /// A vertex where several open fans of triangles meet gets a copy for each further one.
    /// @param vertices   n
    /// @param triangles  of a mesh with consistent orientation, no edge in three of them
    CornerTable(std::vector<TableVertex> vertices, const std::vector<std::array<Index, 3>>& triangles);

    /// The halfedge from the first corner of a triangle.
    static Index halfedge(Index triangle) { return 3 * triangle; }
    static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
    /// The vertex at corner @p k of a triangle.
    Index corner(Index triangle, Index k) const { return from[at(3 * triangle + k)]; }
    Index to(Index h) const { return from[at(next(h))]; }
    /// The corner opposite to an edge.
    Index apex(Index h) const { return from[at(previous(h))]; }
    Index triangle_slots() const { return static_cast<Index>(from.size() / 3); }
    bool alive(Index triangle) const { return corner(triangle, 0) >= 0; }
    bool at_border(Index vertex) const { return twin[at(vertices[at(vertex)].out)] < 0; }
    const Eigen::Vector3d& point(Index vertex) const { return vertices[at(vertex)].point; }

    /// Calls visit(h) for each halfedge from a vertex, counter-clockwise.
    template <typename Visit>
    void around(Index vertex, const Visit& visit) const
    {
        const Index first = vertices[at(vertex)].out;
        Index h = first;
        do {
            visit(h);
            h = twin[at(previous(h))];
        } while (h >= 0 && h != first);
    }

    /// The neighbours of a vertex, counter-clockwise; replaces what is in @p found.
    void neighbours(Index vertex, std::vector<Index>& found) const;

    /// Put a vertex on an edge and cut the triangles next to it in two.
    /// @return its number
    Index split(Index h, const TableVertex& vertex);

    /// Making one vertex of the ends of @p h leaves a triangle mesh: the two have no neighbours in common
    /// but the corners opposite to the edge, and something is left of both sides.
    bool collapsible(Index h) const;

    /// Do so; one end goes, @p keep stays. Two feature edges must not fall together.
    void collapse(Index h, Index keep);

    /// Replace an inner edge by the other diagonal of its two triangles.
    void flip(Index h);

    /// Drop what is gone and number vertices (by @p order, a permutation of all slots) and triangles
    /// again, so that neighbours lie near each other in memory.
    void renumber(const std::vector<Index>& order);

private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    void join(Index a, Index b);
    void set(Index h, Index vertex, Index other, Index mark);
    void close(Index h, Index keep);
    void start_at_border(Index vertex, Index h);
    Index add_triangle();
    void match_twins();
    void give_fan_a_vertex(Index h);
};

} // namespace morph
