#include "libmorph/remap/interpolate.h"

#include "libmorph/core/parallel.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 2048;

constexpr std::size_t kAhead = 8; // targets: long enough for memory to answer

/// Targets follow a curve in space, so that they lie anywhere in memory. Always inline, because GCC takes a
/// function that only prefetches for one without effect and drops the call.
[[gnu::always_inline]] inline void prefetch_target(Index target, const ContainingElements& elements,
                                                   const Eigen::Ref<const Points>& at,
                                                   const std::vector<Matrix>& results)
{
    __builtin_prefetch(&elements.face[static_cast<std::size_t>(target)]);
    __builtin_prefetch(at.row(target).data());
    for (const Matrix& result : results)
        __builtin_prefetch(result.row(target).data(), 1);
}

/// What interpolates in one element.
struct Stencil {
    Element vertices;
    std::array<double, 4> weights;
};

Stencil stencil_at(const Mesh& mesh, Index face, const Eigen::Vector3d& p, QuadRule rule)
{
    const Element vertices = element_corners(mesh, face);
    if (mesh.dimension == 2)
        return {vertices, corner_weights(plane_element(mesh, face), {p.x(), p.y()}, rule)};
    std::array<Eigen::Vector3d, 4> corner;
    for (int k = 0; k < corner_count(vertices); ++k) {
        const auto i = static_cast<std::size_t>(k);
        corner[i] = points(mesh).row(vertices[i]).transpose();
    }
    return {vertices, corner_weights(corner, corner_count(vertices), p, rule)};
}

/// From the first corner's value, so that equal values stay what they are; rounding, which can be large in
/// slivers, is kept within the range of the corners.
double value_at(const Stencil& stencil, const Matrix& values, Eigen::Index column)
{
    const double first = values(stencil.vertices[0], column);
    if (stencil.weights[0] == 1)
        return first;
    double value = first, low = first, high = first;
    for (std::size_t k = 1; k < 4 && stencil.vertices[k] >= 0; ++k) {
        const double corner = values(stencil.vertices[k], column);
        if (stencil.weights[k] == 1)
            return corner;
        value += stencil.weights[k] * corner - stencil.weights[k] * first; // the difference could overflow
        low = std::min(low, corner);
        high = std::max(high, corner);
    }
    return std::clamp(value, low, high);
}

} // namespace

std::vector<Matrix> interpolate(const Mesh& source, const ContainingElements& elements,
                                const Eigen::Ref<const Points>& at, std::span<const Field* const> fields,
                                QuadRule rule)
{
    std::vector<Matrix> results;
    for (const Field* field : fields)
        results.emplace_back(Matrix::Zero(at.rows(), field->values.cols()));
    parallel_for(elements.order.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < end)
                prefetch_target(elements.order[i + kAhead], elements, at, results);
            const Index target = elements.order[i];
            const Index face = elements.face[static_cast<std::size_t>(target)];
            if (face < 0)
                continue;
            const Stencil stencil = stencil_at(source, face, at.row(target).transpose(), rule);
            for (std::size_t f = 0; f < fields.size(); ++f)
                for (Eigen::Index c = 0; c < results[f].cols(); ++c)
                    results[f](target, c) = fields[f]->location == FieldLocation::element
                                                ? fields[f]->values(face, c)
                                                : value_at(stencil, fields[f]->values, c);
        }
    });
    return results;
}

} // namespace morph
