#pragma once

#include "libmorph/mesh/boundary_loops.h"
#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// A mesh as those methods see it that walk along no halfedges: inverse distances, radial functions, element
/// energies. Functions take it by reference, and a mesh can be passed in its place.
///
/// A view: the mesh must outlive it. Lists are made at each call.
class DomainView {
public:
    DomainView(const Mesh& mesh) : mesh_(&mesh) {}

    Index vertex_count() const { return morph::vertex_count(*mesh_); } ///< n

    /// How many coordinates count: 2 in the plane, 3 in space.
    int dimension() const { return mesh_->dimension; }

    /// n x 3, length unit of the mesh.
    Eigen::Map<const Points> positions() const { return points(*mesh_); }

    /// n x dimension(): the positions without a coordinate that does not count.
    Eigen::Map<const Matrix, 0, Eigen::OuterStride<>> coordinates() const
    {
        return {positions().data(), vertex_count(), dimension(), Eigen::OuterStride<>(3)};
    }

    /// For each vertex the first copy of it: itself, unless it is split.
    std::vector<Index> representatives() const { return morph::representatives(mesh_->numbering); }

    /// Corners of every element.
    std::vector<Element> elements() const { return element_table(*mesh_); }

    /// The facets that have an element on one side only, in the plane edges.
    std::vector<std::array<Index, 2>> boundary_facets() const { return boundary_edges(*mesh_); }

    /// The number that the file has for a vertex, for messages.
    Index file_vertex(Index v) const { return mesh_->numbering.vertex[static_cast<std::size_t>(v)]; }

    /// The number that the file has for an element, for messages.
    Index file_element(Index e) const { return mesh_->numbering.element[static_cast<std::size_t>(e)]; }

private:
    const Mesh* mesh_;
};

} // namespace morph
