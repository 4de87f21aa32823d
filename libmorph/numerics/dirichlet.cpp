#include "libmorph/numerics/dirichlet.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/numerics/sparse_cholesky.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kGrain = 4096; // vertices a thread takes at a time

/// Which vertices are unknown.
class Places {
public:
    Places(std::size_t vertices, const std::vector<WeightedEdge>& edges, const std::vector<Index>& held)
        : place_(vertices, kNoEdge)
    {
        for (const WeightedEdge& e : edges)
            place_[static_cast<std::size_t>(e.a)] = place_[static_cast<std::size_t>(e.b)] = 0;
        for (std::size_t i = 0; i < held.size(); ++i)
            hold(held[i], static_cast<Index>(i));
        for (Index& p : place_)
            if (p >= 0)
                p = free_++;
    }

    Index free_vertices() const { return free_; }
    std::size_t vertices() const { return place_.size(); }
    /// Row of a free vertex, negative for the others.
    Index row(Index v) const { return place_[static_cast<std::size_t>(v)]; }
    bool is_held(Index v) const { return row(v) < kNoEdge; }
    /// Position of a held vertex in the list.
    Index held_row(Index v) const { return -2 - row(v); }

private:
    static constexpr Index kNoEdge = -1; // held vertex i has -2 - i, a free one its row

    void hold(Index v, Index i)
    {
        if (v < 0 || static_cast<std::size_t>(v) >= place_.size())
            throw InputError("held vertex " + std::to_string(v) + " is out of range, there are " +
                             std::to_string(place_.size()) + " vertices");
        if (is_held(v))
            throw InputError("vertex " + std::to_string(v) + " is held twice");
        place_[static_cast<std::size_t>(v)] = -2 - i;
    }

    std::vector<Index> place_;
    Index free_ = 0;
};

/// Edge from a free vertex to a held one.
struct HeldEdge {
    Index row;
    Index held;
    double weight;
};

std::vector<HeldEdge> held_edges(const Places& places, const std::vector<WeightedEdge>& edges)
{
    std::vector<HeldEdge> found;
    for (const auto& [a, b, weight] : edges) {
        if (places.row(a) >= 0 && places.is_held(b))
            found.push_back({places.row(a), places.held_row(b), weight});
        if (places.row(b) >= 0 && places.is_held(a))
            found.push_back({places.row(b), places.held_row(a), weight});
    }
    return found;
}

SymmetricMatrix free_matrix(const Places& places, const std::vector<WeightedEdge>& edges)
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

// A part that nothing holds makes the matrix singular, and rounding hides that from the factorisation: it
// has to be found in the connectivity.
void require_every_part_held(const SymmetricMatrix& A, const std::vector<HeldEdge>& held)
{
    std::vector<char> reached(A.diagonal.size());
    std::vector<Index> pending;
    const auto reach = [&](Index i) {
        if (!std::exchange(reached[static_cast<std::size_t>(i)], char{1}))
            pending.push_back(i);
    };
    const auto spread = [&] {
        while (!pending.empty()) {
            const auto i = static_cast<std::size_t>(pending.back());
            pending.pop_back();
            for (std::size_t e = A.start[i]; e < A.start[i + 1]; ++e)
                reach(A.column[e]);
        }
    };
    for (const HeldEdge& e : held)
        reach(e.row);
    spread();
    std::size_t loose = 0;
    for (Index i = 0; i < A.rows(); ++i)
        if (!reached[static_cast<std::size_t>(i)]) {
            ++loose;
            reach(i);
            spread();
        }
    if (loose > 0)
        throw InputError(std::to_string(loose) +
                         (loose == 1 ? " part of the mesh has" : " parts of the mesh have") +
                         " no held vertex; hold at least one marker on each part");
}

/// Where the free vertices are, by row.
Points2 free_points(const Eigen::Ref<const Points>& points, const Places& places)
{
    Points2 where(places.free_vertices(), 2);
    for (Index v = 0; v < points.rows(); ++v)
        if (const Index row = places.row(v); row >= 0)
            where.row(row) = points.row(v).head<2>();
    return where;
}

} // namespace

struct DirichletProblem::Parts {
    Places places;
    Index held_count;
    std::vector<HeldEdge> boundary;
    SparseCholesky factor;
};

DirichletProblem::DirichletProblem(const Eigen::Ref<const Points>& points,
                                   const std::vector<WeightedEdge>& edges, const std::vector<Index>& held)
{
    Places places(static_cast<std::size_t>(points.rows()), edges, held);
    std::vector<HeldEdge> boundary = held_edges(places, edges);
    const SymmetricMatrix A = free_matrix(places, edges);
    require_every_part_held(A, boundary);
    SparseCholesky factor(A, nested_dissection(A, free_points(points, places)));
    parts_ = std::make_unique<Parts>(
        Parts{std::move(places), static_cast<Index>(held.size()), std::move(boundary), std::move(factor)});
}

DirichletProblem::~DirichletProblem() = default;
DirichletProblem::DirichletProblem(DirichletProblem&&) noexcept = default;
DirichletProblem& DirichletProblem::operator=(DirichletProblem&&) noexcept = default;

Matrix DirichletProblem::solve(const Matrix& values) const
{
    const Places& places = parts_->places;
    if (values.rows() != parts_->held_count)
        throw InputError(std::to_string(values.rows()) + " rows of values are given for " +
                         std::to_string(parts_->held_count) + " held vertices");
    const auto K = values.cols();
    Matrix free = Matrix::Zero(places.free_vertices(), K + 1);
    for (const HeldEdge& e : parts_->boundary) {
        free.row(e.row).head(K) += e.weight * values.row(e.held);
        free(e.row, K) += e.weight; // the last column has 1 at every held vertex
    }
    parts_->factor.solve(free);
    Matrix h = Matrix::Zero(static_cast<Index>(places.vertices()), K);
    parallel_for(places.vertices(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
            if (const Index row = places.row(v); row >= 0)
                h.row(v) = free.row(row).head(K) / free(row, K);
            else if (places.is_held(v))
                h.row(v) = values.row(places.held_row(v));
        const auto count = static_cast<Index>(end - begin);
        if (!h.middleRows(static_cast<Index>(begin), count).allFinite())
            throw SolverError("the system has no finite solution");
    });
    return h;
}

} // namespace morph
