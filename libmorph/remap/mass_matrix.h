#pragma once

#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// Mass matrix of a triangle: int phi_i phi_j for the corners 00, 01, 02, 11, 12, 22.
using TriangleMass = std::array<double, 6>;

/// Sparse symmetric matrix of the vertices of a mesh, M_ij = int phi_i phi_j over a part of it.
///
/// Rows of vertices that the part does not touch are empty. Equal bytes for any thread count.
class MassMatrix {
public:
    /// Add up the triangles around each vertex.
    ///
    /// @param mesh         planar; its elements are cut as Cut::triangles
    /// @param first_piece  of each element the number of its first triangle, and of all in the end
    /// @param masses       one for each triangle
    MassMatrix(const Mesh& mesh, const std::vector<Index>& first_piece,
               const std::vector<TriangleMass>& masses);

    /// Solve M X = R for all columns at once, by conjugate gradients with the diagonal as preconditioner
    /// [Hestenes & Stiefel 1952, Journal of Research of the National Bureau of Standards 49(6), 409-436], to
    /// a residual of 1e-15 in the norm of the preconditioner.
    ///
    /// @param R  n x K; rows of empty rows of M do not count
    /// @return n x K, 0 in those rows
    /// @throws SolverError  no convergence, as when R is not finite
    Matrix solve(const Matrix& R) const;

    /// n: sums of the rows, int phi_i.
    const std::vector<double>& row_sums() const { return row_sums_; }

private:
    /// Consecutive rows. An entry is a column and a value; the first of a row is the diagonal.
    struct RowBlock {
        std::vector<std::size_t> start; ///< of each row, and the end
        std::vector<Index> column;
        std::vector<double> value;
    };

    class Iteration;

    std::vector<RowBlock> blocks_;
    std::vector<double> row_sums_;
};

} // namespace morph
