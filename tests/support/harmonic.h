#pragma once

#include "libmorph/weights/harmonic.h"

#include <string>

namespace morph::test {

inline double x_of(const Mesh& mesh, Index v)
{
    return points(mesh)(v, 0);
}

inline double y_of(const Mesh& mesh, Index v)
{
    return points(mesh)(v, 1);
}

/// A boundary and what is prescribed there.
struct BoundaryValues {
    DirichletBoundary boundary;
    Matrix values; ///< k x K, row i belongs to boundary.vertices[i]
};

/// Prescribe values(x, y), a row of K, on the whole boundary; the edges of the named marker move.
template <typename Values>
BoundaryValues prescribe_boundary(const Mesh& mesh, const std::string& moving, const Values& values)
{
    BoundaryValues prescribed;
    std::vector<Index>& vertices = prescribed.boundary.vertices;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v))
            vertices.push_back(v.idx());
    prescribed.values.resize(static_cast<Index>(vertices.size()), values(0.0, 0.0).cols());
    for (Index i = 0; i < prescribed.values.rows(); ++i) {
        const Index v = vertices[static_cast<std::size_t>(i)];
        prescribed.values.row(i) = values(x_of(mesh, v), y_of(mesh, v));
    }
    prescribed.boundary.moving_edges = marker(mesh, moving).edges;
    return prescribed;
}

/// n x K
inline Matrix harmonic_functions(const Mesh& mesh, const BoundaryValues& prescribed, Diffusivity diffusivity)
{
    return harmonic_extension(mesh, prescribed.boundary, diffusivity)->extend(prescribed.values);
}

} // namespace morph::test
