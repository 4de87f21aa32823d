#include "libmorph/weights/rbf.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/nearest_points.h"
#include "libmorph/weights/boundary_segments.h"
#include "libmorph/weights/radial_interpolant.h"
#include "libmorph/weights/rbf_setup.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // vertices a thread takes at a time

/// Rows of UniqueDirichletVertices::vertices() that are centres.
std::vector<Index> centre_rows(const DomainView& domain, const UniqueDirichletVertices& vertices,
                               const std::vector<Index>& centres)
{
    std::vector<Index> rows(centres.empty() ? vertices.vertices().size() : 0);
    std::iota(rows.begin(), rows.end(), 0);
    const std::vector<Index> row_of = vertices.rows();
    for (const Index v : centres) {
        if (v < 0 || v >= domain.vertex_count() || row_of[static_cast<std::size_t>(v)] < 0)
            throw InputError("vertex " + std::to_string(v) +
                             " is a centre of radial functions, but it is not held");
        rows.push_back(row_of[static_cast<std::size_t>(v)]);
    }
    if (rows.empty())
        throw InputError("no vertex is held: radial functions have no centres");
    if (rows.size() > static_cast<std::size_t>(kMostCentres))
        throw InputError(std::to_string(rows.size()) + " centres of radial functions are more than the " +
                         std::to_string(kMostCentres) + " that a dense matrix is made for; choose some");
    return rows;
}

std::vector<Index> pick(const std::vector<Index>& list, const std::vector<Index>& rows)
{
    std::vector<Index> picked(rows.size());
    std::transform(rows.begin(), rows.end(), picked.begin(),
                   [&list](Index row) { return list[static_cast<std::size_t>(row)]; });
    return picked;
}

/// Takes away the error that is left on the boundary, near it.
class BoundaryCorrection {
public:
    BoundaryCorrection(const DomainView& domain, const DirichletBoundary& boundary,
                       const UniqueDirichletVertices& vertices, const Points& centres)
    {
        const Points positions = held_points(domain, vertices);
        Matrix reach(positions.rows(), 1);
        NearestPoints(centres).nearest(
            positions, 2, [&reach](Index row, auto found) { reach(row, 0) = 2 * found.back().distance; });
        BoundarySegments edges = boundary_segments(domain, boundary, vertices);
        edges.moving.insert(edges.moving.end(), edges.still.begin(), edges.still.end());
        find_near(domain.positions(), NearestOnSegments(positions, edges.moving), reach);
    }

    /// @param error   h x c
    /// @param result  n x c
    void subtract(const Matrix& error, Matrix& result) const
    {
        for (const std::vector<Near>& block : near_)
            for (const auto& [vertex, share, point] : block)
                result.row(vertex) -= share * point.value(error);
    }

private:
    /// A vertex in reach of the boundary, and how much of the error at the nearest point arrives there.
    struct Near {
        Index vertex;
        double share;
        EdgePoint point;
    };

    void find_near(const Eigen::Ref<const Points>& x, const NearestOnSegments& edges, const Matrix& reach)
    {
        near_.resize(static_cast<std::size_t>(x.rows()) / kRowsPerBlock + 1);
        parallel_for(static_cast<std::size_t>(x.rows()), kRowsPerBlock,
                     [&](std::size_t begin, std::size_t end) {
                         EdgePoint at;
                         for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
                             at = edges.nearest(x.row(v).transpose(), at.segment);
                             const double q = at.distance / at.value(reach)[0], rest = (1 - q) * (1 - q);
                             if (q < 1)
                                 near_[begin / kRowsPerBlock].push_back({v, rest * rest * (4 * q + 1), at});
                         }
                     });
    }

    std::vector<std::vector<Near>> near_; ///< by block of vertices
};

class RbfExtension final : public BoundaryExtension {
public:
    RbfExtension(const DomainView& domain, const DirichletBoundary& boundary, const RbfOptions& options,
                 const std::vector<Index>& centres)
        : BoundaryExtension(domain, boundary), positions_(domain.positions()),
          rows_(centre_rows(domain, held(), centres)),
          interpolant_(radial_interpolant(domain, pick(held().vertices(), rows_), options,
                                          support_radius(domain, boundary, options))),
          correction_(domain, boundary, held(), positions_(pick(held().vertices(), rows_), Eigen::all))
    {
    }

private:
    Matrix solve(const Matrix& joined) const override
    {
        const Matrix coefficients = interpolant_.coefficients(joined(rows_, Eigen::all));
        Matrix result = interpolant_.evaluate(positions_, coefficients);
        correction_.subtract(result(held().vertices(), Eigen::all) - joined, result);
        return result;
    }

    Points positions_;
    std::vector<Index> rows_; ///< of held().vertices(): the centres
    RadialInterpolant interpolant_;
    BoundaryCorrection correction_;
};

} // namespace

std::unique_ptr<BoundaryExtension> rbf_extension(const DomainView& domain, const DirichletBoundary& boundary,
                                                 const RbfOptions& options, const std::vector<Index>& centres)
{
    return std::make_unique<RbfExtension>(domain, boundary, options, centres);
}

} // namespace morph
