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

/// Hold the whole boundary at values(x, y), a row of K; the edges of the named marker move.
template <typename Values>
HarmonicProblem hold_boundary(const Mesh& mesh, const std::string& moving, const Values& values)
{
    HarmonicProblem problem;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v))
            problem.held.vertices.push_back(v.idx());
    problem.held.values.resize(static_cast<Index>(problem.held.vertices.size()), values(0.0, 0.0).cols());
    for (Index i = 0; i < problem.held.values.rows(); ++i) {
        const Index v = problem.held.vertices[static_cast<std::size_t>(i)];
        problem.held.values.row(i) = values(x_of(mesh, v), y_of(mesh, v));
    }
    problem.moving_edges = marker(mesh, moving).edges;
    return problem;
}

} // namespace morph::test
