#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <vector>

namespace morph {

/// The held vertices of a mesh, the copies of a split vertex taken as one: what BoundaryExtension::extend()
/// begins and ends with.
class UniqueDirichletVertices {
public:
    /// @throws InputError  the mesh is a surface in space; @p boundary names a vertex the mesh does not have,
    ///                     or one twice
    UniqueDirichletVertices(const DomainView& domain, const DirichletBoundary& boundary);

    /// For each vertex the first copy of it: itself, unless it is split.
    const std::vector<Index>& representatives() const { return representative_; }

    /// h first copies, each once.
    const std::vector<Index>& vertices() const { return vertices_; }

    /// Row in vertices() of each vertex of the mesh, copies included; -1 where nothing is held.
    std::vector<Index> rows() const;

    /// The values at vertices().
    /// @param values  k x c, row i belongs to DirichletBoundary::vertices[i]
    /// @return h x c
    /// @throws InputError  another number of rows; not finite; two copies of a vertex have different values
    Matrix join(const Matrix& values) const;

    /// Give the held vertices their values, and every copy the row of its first one.
    /// @param joined  h x c, from join()
    /// @param result  n x c
    /// @throws SolverError  the result is not finite
    void restore(const Matrix& joined, Matrix& result) const;

private:
    std::vector<Index> representative_;
    std::vector<Index> vertices_;
    std::vector<Index> file_number_; ///< of vertices_, for messages
    std::vector<Index> row_;         ///< in vertices_, of each one of DirichletBoundary::vertices
};

} // namespace morph
