#include "libmorph/numerics/dirichlet_laplacian.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/numerics/dof_map.h"
#include "libmorph/numerics/sparse_cholesky.h"

#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // vertices a thread takes at a time

DofMap places_of(Index vertices, const std::vector<WeightedEdge>& edges, const std::vector<Index>& held)
{
    std::vector<bool> joined(static_cast<std::size_t>(vertices));
    for (const WeightedEdge& e : edges)
        joined[static_cast<std::size_t>(e.a)] = joined[static_cast<std::size_t>(e.b)] = true;
    return {joined, held};
}

/// Edge from a free vertex to a held one.
struct BoundarySegment {
    Index row;
    Index held;
    double weight;
};

std::vector<DirichletNeighbour> neighbours(const std::vector<BoundarySegment>& edges)
{
    std::vector<DirichletNeighbour> found;
    found.reserve(edges.size());
    for (const BoundarySegment& e : edges)
        found.push_back({e.row, e.held});
    return found;
}

std::vector<BoundarySegment> boundary_segments(const DofMap& places, const std::vector<WeightedEdge>& edges)
{
    std::vector<BoundarySegment> found;
    for (const auto& [a, b, weight] : edges) {
        if (places.row(a) >= 0 && places.is_held(b))
            found.push_back({places.row(a), places.dirichlet_row(b), weight});
        if (places.row(b) >= 0 && places.is_held(a))
            found.push_back({places.row(b), places.dirichlet_row(a), weight});
    }
    return found;
}

SymmetricMatrix free_matrix(const DofMap& places, const std::vector<WeightedEdge>& edges)
{
    SymmetricMatrix A;
    const auto n = static_cast<std::size_t>(places.free_vertices());
    A.diagonal.resize(n);
    A.start.resize(n + 1);
    for (const auto& [a, b, weight] : edges) {
        const Index i = places.row(a), j = places.row(b);
        if (i >= 0)
            A.diagonal[static_cast<std::size_t>(i)] += weight;
        if (j >= 0)
            A.diagonal[static_cast<std::size_t>(j)] += weight;
        if (i >= 0 && j >= 0) {
            ++A.start[static_cast<std::size_t>(i) + 1];
            ++A.start[static_cast<std::size_t>(j) + 1];
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        A.start[i + 1] += A.start[i];
    A.column.resize(A.start[n]);
    A.value.resize(A.start[n]);
    std::vector<std::size_t> next(A.start.begin(), A.start.end() - 1);
    const auto put = [&](Index i, Index j, double value) {
        const std::size_t at = next[static_cast<std::size_t>(i)]++;
        A.column[at] = j;
        A.value[at] = value;
    };
    for (const auto& [a, b, weight] : edges)
        if (const Index i = places.row(a), j = places.row(b); i >= 0 && j >= 0) {
            put(i, j, -weight);
            put(j, i, -weight);
        }
    return A;
}

} // namespace

struct DirichletLaplacian::Parts {
    DofMap places;
    Index held_count;
    std::vector<BoundarySegment> boundary;
    SparseCholesky factor;
};

DirichletLaplacian::DirichletLaplacian(const Eigen::Ref<const Matrix>& points,
                                       const std::vector<WeightedEdge>& edges, const std::vector<Index>& held)
{
    DofMap places = places_of(static_cast<Index>(points.rows()), edges, held);
    std::vector<BoundarySegment> boundary = boundary_segments(places, edges);
    const SymmetricMatrix A = free_matrix(places, edges);
    require_dirichlet_on_every_component(A, neighbours(boundary), 1);
    SparseCholesky factor(A, nested_dissection(A, places.free_points(points)));
    parts_ = std::make_unique<Parts>(
        Parts{std::move(places), static_cast<Index>(held.size()), std::move(boundary), std::move(factor)});
}

DirichletLaplacian::~DirichletLaplacian() = default;
DirichletLaplacian::DirichletLaplacian(DirichletLaplacian&&) noexcept = default;
DirichletLaplacian& DirichletLaplacian::operator=(DirichletLaplacian&&) noexcept = default;

Matrix DirichletLaplacian::solve(const Matrix& values) const
{
    const DofMap& places = parts_->places;
    if (values.rows() != parts_->held_count)
        throw InputError(std::to_string(values.rows()) + " rows of values are given for " +
                         std::to_string(parts_->held_count) + " held vertices");
    const auto K = values.cols();
    Matrix free = Matrix::Zero(places.free_vertices(), K + 1);
    for (const BoundarySegment& e : parts_->boundary) {
        free.row(e.row).head(K) += e.weight * values.row(e.held);
        free(e.row, K) += e.weight; // the last column has 1 at every held vertex
    }
    parts_->factor.solve(free);
    Matrix h = Matrix::Zero(static_cast<Index>(places.vertices()), K);
    parallel_for(places.vertices(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
            if (const Index row = places.row(v); row >= 0)
                h.row(v) = free.row(row).head(K) / free(row, K);
            else if (places.is_held(v))
                h.row(v) = values.row(places.dirichlet_row(v));
        const auto count = static_cast<Index>(end - begin);
        if (!h.middleRows(static_cast<Index>(begin), count).allFinite())
            throw SolverError("the system has no finite solution");
    });
    return h;
}

} // namespace morph
