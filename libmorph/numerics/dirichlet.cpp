#include "libmorph/numerics/dirichlet.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/numerics/symmetric_matrix.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

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

/// Sort each row and add up entries of the same column (two edges between the same two vertices).
void tidy_row(SymmetricMatrix& A, std::size_t i, std::vector<std::pair<Index, double>>& row)
{
    row.clear();
    for (std::size_t e = A.start[i]; e < A.start[i + 1]; ++e)
        row.emplace_back(A.column[e], A.value[e]);
    std::sort(row.begin(), row.end());
    for (std::size_t e = 0; e < row.size(); ++e)
        std::tie(A.column[A.start[i] + e], A.value[A.start[i] + e]) = row[e];
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
    parallel_for(n, 4096, [&](std::size_t begin, std::size_t end) {
        std::vector<std::pair<Index, double>> row;
        for (std::size_t i = begin; i < end; ++i)
            tidy_row(A, i, row);
    });
    return A;
}

// A part that nothing holds makes the matrix singular, and rounding hides that from the factorisation: it
// has to be found in the connectivity.
void require_every_part_held(const SymmetricMatrix& A, const std::vector<HeldEdge>& held)
{
    std::vector<char> reached(A.diagonal.size());
    std::vector<Index> todo;
    const auto reach = [&](Index i) {
        if (!std::exchange(reached[static_cast<std::size_t>(i)], char{1}))
            todo.push_back(i);
    };
    const auto spread = [&] {
        while (!todo.empty()) {
            const auto i = static_cast<std::size_t>(todo.back());
            todo.pop_back();
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
                         " part(s) of the mesh have no held vertex; hold at least one "
                         "marker on each part");
}

} // namespace

struct DirichletProblem::Parts {
    Places places;
    std::size_t held_count;
    std::vector<HeldEdge> boundary;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
};

DirichletProblem::DirichletProblem(const Eigen::Ref<const Points>& points,
                                   const std::vector<WeightedEdge>& edges, std::vector<Index> held)
{
    Places places(static_cast<std::size_t>(points.rows()), edges, held);
    const SymmetricMatrix A = free_matrix(places, edges);
    std::vector<HeldEdge> boundary = held_edges(places, edges);
    require_every_part_held(A, boundary);
    parts_.reset(new Parts{std::move(places), held.size(), std::move(boundary), {}});
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < A.rows(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        entries.emplace_back(i, i, A.diagonal[row]);
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
            entries.emplace_back(i, A.column[e], A.value[e]);
    }
    Eigen::SparseMatrix<double> K(A.rows(), A.rows());
    K.setFromTriplets(entries.begin(), entries.end());
    if (A.rows() > 0)
        parts_->factor.compute(K);
    if (A.rows() > 0 && parts_->factor.info() != Eigen::Success)
        throw SolverError("the stiffness matrix cannot be factored");
}

DirichletProblem::~DirichletProblem() = default;
DirichletProblem::DirichletProblem(DirichletProblem&&) noexcept = default;
DirichletProblem& DirichletProblem::operator=(DirichletProblem&&) noexcept = default;

Matrix DirichletProblem::solve(const Matrix& values) const
{
    const Places& places = parts_->places;
    if (static_cast<std::size_t>(values.rows()) != parts_->held_count)
        throw InputError(std::to_string(values.rows()) + " rows of values are given for " +
                         std::to_string(parts_->held_count) + " held vertices");
    Matrix free = Matrix::Zero(places.free_vertices(), values.cols());
    for (const HeldEdge& e : parts_->boundary)
        free.row(e.row) += e.weight * values.row(e.held);
    if (places.free_vertices() > 0)
        free = parts_->factor.solve(free).eval();
    Matrix h = Matrix::Zero(static_cast<Index>(places.vertices()), values.cols());
    for (Index v = 0; v < h.rows(); ++v)
        if (places.row(v) >= 0)
            h.row(v) = free.row(places.row(v));
        else if (places.is_held(v))
            h.row(v) = values.row(places.held_row(v));
    if (!h.allFinite())
        throw SolverError("the stiffness matrix has no finite solution");
    return h;
}

} // namespace morph
