#include "libmorph/numerics/dirichlet_system.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/dof_map.h"
#include "libmorph/numerics/sparse_cholesky.h"

#include <string>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

DofMap places_of(const SymmetricMatrix& A, Index c, const std::vector<Index>& held)
{
    std::vector<bool> joined(A.diagonal.size() / c);
    for (std::size_t v = 0; v < joined.size(); ++v)
        joined[v] = A.start[v * c] < A.start[(v + 1) * c];
    return {joined, held};
}

/// Entry of A in the row of a free unknown and the column of a held one.
struct HeldEntry {
    Index row;    // among the free unknowns
    Index vertex; // position in the list of held vertices
    Index component;
    double value;
};

/// A between the free unknowns, and what couples them to the held ones.
struct Split {
    SymmetricMatrix free;
    std::vector<HeldEntry> held;
};

Split split(const SymmetricMatrix& A, Index c, const DofMap& places)
{
    Split s;
    s.free.start.push_back(0);
    for (Index i = 0; i < A.rows(); ++i) {
        if (places.row(i / c) < 0)
            continue;
        const Index row = s.free.rows();
        s.free.diagonal.push_back(A.diagonal[at(i)]);
        for (std::size_t e = A.start[at(i)]; e < A.start[at(i) + 1]; ++e) {
            const Index v = A.column[e] / c, k = A.column[e] % c;
            if (places.is_held(v)) {
                s.held.push_back({row, places.dirichlet_row(v), k, A.value[e]});
                continue;
            }
            s.free.column.push_back(places.row(v) * c + k);
            s.free.value.push_back(A.value[e]);
        }
        s.free.start.push_back(s.free.column.size());
    }
    return s;
}

/// The graph of the vertices: those are joined whose first unknowns are. Its values do not matter.
SymmetricMatrix vertex_graph(const SymmetricMatrix& A, Index c)
{
    SymmetricMatrix graph;
    const std::size_t n = A.diagonal.size() / c;
    graph.diagonal.resize(n);
    graph.start.push_back(0);
    for (std::size_t v = 0; v < n; ++v) {
        for (std::size_t e = A.start[v * c]; e < A.start[v * c + 1]; ++e)
            if (A.column[e] % c == 0)
                graph.column.push_back(A.column[e] / c);
        graph.start.push_back(graph.column.size());
    }
    return graph;
}

/// The dissection of the vertices as one of their unknowns: those of a vertex are eliminated together.
Dissection of_unknowns(const Dissection& vertices, Index c)
{
    Dissection d{{}, vertices.nodes};
    for (const Index v : vertices.order)
        for (Index k = 0; k < c; ++k)
            d.order.push_back(v * c + k);
    for (Dissection::Node& node : d.nodes) {
        node.begin *= c;
        node.end *= c;
    }
    return d;
}

std::vector<DirichletNeighbour> neighbours(const std::vector<HeldEntry>& entries, Index c)
{
    std::vector<DirichletNeighbour> found;
    found.reserve(entries.size());
    for (const HeldEntry& e : entries)
        found.push_back({e.row / c, e.vertex});
    return found;
}

} // namespace

struct DirichletSystem::Parts {
    DofMap places;
    Index components;
    Index held_count;
    std::vector<HeldEntry> held;
    SparseCholesky factor;
};

DirichletSystem::DirichletSystem(const Eigen::Ref<const Matrix>& points, const SymmetricMatrix& A,
                                 Index components, const std::vector<Index>& held)
{
    DofMap places = places_of(A, components, held);
    Split parts = split(A, components, places);
    const SymmetricMatrix graph = vertex_graph(parts.free, components);
    require_dirichlet_on_every_component(graph, neighbours(parts.held, components), components);
    Dissection order = of_unknowns(nested_dissection(graph, places.free_points(points)), components);
    SparseCholesky factor(parts.free, std::move(order));
    parts_ = std::make_unique<Parts>(Parts{std::move(places), components, static_cast<Index>(held.size()),
                                           std::move(parts.held), std::move(factor)});
}

DirichletSystem::~DirichletSystem() = default;

Matrix DirichletSystem::solve(const Matrix& values) const
{
    return solve(values, Matrix::Zero(static_cast<Index>(parts_->places.vertices()), values.cols()));
}

Matrix DirichletSystem::solve(const Matrix& values, const Matrix& load) const
{
    const DofMap& places = parts_->places;
    const Eigen::Index c = parts_->components;
    if (values.rows() != parts_->held_count)
        throw InputError(std::to_string(values.rows()) + " rows of values are given for " +
                         std::to_string(parts_->held_count) + " held vertices");
    const Eigen::Index m = values.cols() / c;
    if (m * c != values.cols() || load.cols() != values.cols() ||
        load.rows() != static_cast<Eigen::Index>(places.vertices()))
        throw InputError("values in " + std::to_string(values.cols()) + " columns and loads in " +
                         std::to_string(load.rows()) + " x " + std::to_string(load.cols()) +
                         " are given for " + std::to_string(places.vertices()) + " vertices of " +
                         std::to_string(c) + " unknowns");
    Matrix free(places.free_vertices() * c, m);
    for (Index v = 0; v < static_cast<Index>(places.vertices()); ++v)
        if (const Index row = places.row(v); row >= 0)
            for (Eigen::Index k = 0; k < c; ++k)
                free.row(row * c + k) = load.row(v).segment(k * m, m);
    for (const HeldEntry& e : parts_->held)
        free.row(e.row) -= e.value * values.row(e.vertex).segment(m * e.component, m);
    parts_->factor.solve(free);
    Matrix u = Matrix::Zero(load.rows(), values.cols());
    for (Index v = 0; v < static_cast<Index>(places.vertices()); ++v)
        if (const Index row = places.row(v); row >= 0)
            for (Eigen::Index k = 0; k < c; ++k)
                u.row(v).segment(k * m, m) = free.row(row * c + k);
        else if (places.is_held(v))
            u.row(v) = values.row(places.dirichlet_row(v));
    if (!u.allFinite())
        throw SolverError("the system has no finite solution");
    return u;
}

} // namespace morph
