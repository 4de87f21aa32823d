#pragma once

#include "libmorph/numerics/symmetric_matrix.h"

#include <Eigen/Core>

#include <vector>

namespace morph {

/// Which vertices are unknown: the free ones have rows in the order of their numbers; held ones, and those
/// that nothing is joined to, have none.
class DofMap {
public:
    /// @param joined  for each vertex whether an edge or element names it
    /// @param held    distinct vertices
    /// @throws InputError  a held vertex is out of range or given twice
    DofMap(const std::vector<bool>& joined, const std::vector<Index>& held);

    Index free_vertices() const { return free_; }
    std::size_t vertices() const { return place_.size(); }
    /// Row of a free vertex, negative for the others.
    Index row(Index v) const { return place_[static_cast<std::size_t>(v)]; }
    bool is_held(Index v) const { return row(v) < kAlone; }
    /// Position of a held vertex in the list.
    Index dirichlet_row(Index v) const { return -2 - row(v); }

    /// Where the free vertices are, by row.
    /// @param points  n x d
    /// @return m x d for m free vertices
    Matrix free_points(const Eigen::Ref<const Matrix>& points) const;

private:
    static constexpr Index kAlone = -1; // held vertex i has -2 - i, a free one its row

    void hold(Index v, Index i);

    std::vector<Index> place_;
    Index free_ = 0;
};

/// A free row and a held vertex that are coupled.
struct DirichletNeighbour {
    Index row;
    Index held;
};

/// A part of the free vertices with too few held ones around it makes the matrix singular, and rounding hides
/// that from the factorisation: it has to be found in the connectivity.
///
/// @param graph  of the free vertices; its values are not looked at
/// @param least  held vertices that every part must be coupled to: 1 for values that do not influence each
///               other, 2 for displacements in the plane, which one held vertex leaves free to turn
/// @throws InputError  parts have fewer; says how many
void require_dirichlet_on_every_component(const SymmetricMatrix& graph,
                                          const std::vector<DirichletNeighbour>& held, int least);

} // namespace morph
