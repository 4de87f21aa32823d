#pragma once

#include "libmorph/geometry/delaunay.h"

#include <vector>

namespace morph {

/// The triangles around each vertex that hang together by edges: one fan for most vertices, one for each side
/// of a wall, and one for each place where a split vertex is.
class TriangleFans {
public:
    explicit TriangleFans(const Triangulation& triangulation);

    std::size_t count() const { return count_; }

    /// Fan that corner k of triangle t belongs to, numbered by their first corners.
    std::size_t fan(std::size_t t, std::size_t k) const { return of_corner_[3 * t + k]; }

private:
    std::size_t root(std::size_t corner);
    void join(std::size_t a, std::size_t b);

    std::vector<std::size_t> of_corner_;
    std::size_t count_ = 0;
};

} // namespace morph
