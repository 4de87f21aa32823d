#include "libmorph/weights/unique_dirichlet_vertices.h"

#include "libmorph/core/error.h"

#include <string>

namespace morph {

namespace {

void require_valid(const DomainView& domain, const DirichletBoundary& boundary)
{
    if (domain.dimension() != 2)
        throw InputError("boundary values are extended into planar meshes, but this is a surface in space");
    const Index n = domain.vertex_count();
    const auto require_vertex = [n](Index v, const char* what) {
        if (v < 0 || v >= n)
            throw InputError(std::string(what) + " names vertex " + std::to_string(v) +
                             ", but the mesh has " + std::to_string(n));
    };
    for (const Index v : boundary.vertices)
        require_vertex(v, "the held set");
    for (const auto& [a, b] : boundary.moving_edges) {
        require_vertex(a, "a moving edge");
        require_vertex(b, "a moving edge");
    }
    for (const auto& [a, b] : boundary.fixed_edges) {
        require_vertex(a, "a fixed edge");
        require_vertex(b, "a fixed edge");
    }
}

} // namespace

UniqueDirichletVertices::UniqueDirichletVertices(const DomainView& domain, const DirichletBoundary& boundary)
{
    require_valid(domain, boundary);
    representative_ = domain.representatives();
    std::vector<Index> row_of(representative_.size(), -1);
    std::vector<bool> seen(representative_.size());
    for (const Index v : boundary.vertices) {
        const Index file_number = domain.file_vertex(v);
        if (seen[static_cast<std::size_t>(v)])
            throw InputError("vertex " + std::to_string(file_number) + " is held twice");
        seen[static_cast<std::size_t>(v)] = true;
        const Index first = representative_[static_cast<std::size_t>(v)];
        Index& row = row_of[static_cast<std::size_t>(first)];
        if (row < 0) {
            row = static_cast<Index>(vertices_.size());
            vertices_.push_back(first);
            file_number_.push_back(file_number);
        }
        row_.push_back(row);
    }
}

std::vector<Index> UniqueDirichletVertices::rows() const
{
    std::vector<Index> row(representative_.size(), -1);
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        row[static_cast<std::size_t>(vertices_[i])] = static_cast<Index>(i);
    for (std::size_t v = 0; v < row.size(); ++v) // a first copy comes before the others
        row[v] = row[static_cast<std::size_t>(representative_[v])];
    return row;
}

Matrix UniqueDirichletVertices::join(const Matrix& values) const
{
    if (static_cast<std::size_t>(values.rows()) != row_.size())
        throw InputError(std::to_string(values.rows()) + " rows of values are given for " +
                         std::to_string(row_.size()) + " held vertices");
    if (!values.allFinite())
        throw InputError("the held values are not all finite");
    Matrix joined(static_cast<Index>(vertices_.size()), values.cols());
    std::vector<bool> known(vertices_.size());
    for (std::size_t i = 0; i < row_.size(); ++i) {
        const auto row = static_cast<std::size_t>(row_[i]);
        const auto given = values.row(static_cast<Index>(i));
        if (known[row] && joined.row(row_[i]) != given)
            throw InputError("vertex " + std::to_string(file_number_[row]) +
                             " is held twice with different values");
        joined.row(row_[i]) = given;
        known[row] = true;
    }
    return joined;
}

void UniqueDirichletVertices::restore(const Matrix& joined, Matrix& result) const
{
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        result.row(vertices_[i]) = joined.row(static_cast<Index>(i));
    for (std::size_t v = 0; v < representative_.size(); ++v)
        if (const Index first = representative_[v]; first != static_cast<Index>(v))
            result.row(static_cast<Index>(v)) = result.row(first);
    if (!result.allFinite())
        throw SolverError("the values extended into the mesh are not finite");
}

} // namespace morph
