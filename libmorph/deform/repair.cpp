#include "libmorph/deform/repair.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/repair_in_steps.h"
#include "libmorph/weights/biharmonic.h"

#include <optional>

namespace morph {

namespace {

/// All that is held: the boundary and the markers.
DirichletBoundary dirichlet_boundary(const Mesh& mesh)
{
    const std::vector<Index> first = representatives(mesh.numbering);
    std::vector<bool> held(first.size(), false);
    for (const auto vertex : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(vertex))
            held[static_cast<std::size_t>(first[static_cast<std::size_t>(vertex.idx())])] = true;
    DirichletBoundary boundary;
    for (const Marker& marker : mesh.markers) {
        boundary.fixed_edges.insert(boundary.fixed_edges.end(), marker.edges.begin(), marker.edges.end());
        for (const Index v : marker_vertices(marker))
            held[static_cast<std::size_t>(first[static_cast<std::size_t>(v)])] = true;
    }
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (held[static_cast<std::size_t>(first[static_cast<std::size_t>(v)])])
            boundary.vertices.push_back(v);
    return boundary;
}

/// A mesh before and after its move.
struct Move {
    Mesh start; ///< the mesh before
    DirichletBoundary held;
    Matrix displacement; ///< of the held vertices
    Points moved;        ///< all vertices as they were moved
};

Move move_of(const Mesh& mesh, const PositionsView& before)
{
    Move move{mesh, dirichlet_boundary(mesh), {}, points(mesh)};
    points(move.start) = before;
    move.displacement.resize(static_cast<Index>(move.held.vertices.size()), 2);
    for (std::size_t i = 0; i < move.held.vertices.size(); ++i)
        move.displacement.row(static_cast<Index>(i)) =
            (move.moved.row(move.held.vertices[i]) - before.row(move.held.vertices[i])).head<2>();
    return move;
}

/// Where a search for a valid mesh starts. @p work is added to.
using Start = Points (*)(const Move& move, UntangleResult& work);

Points as_it_was_moved(const Move& move, UntangleResult& /*work*/)
{
    return move.moved;
}

Points by_biharmonic_functions(const Move& move, UntangleResult& /*work*/)
{
    Points positions = points(move.start);
    positions.leftCols<2>() +=
        conformal_biharmonic_extension(move.start, move.held)->extend(move.displacement);
    return positions;
}

Points in_steps(const Move& move, UntangleResult& work)
{
    return repair_in_steps(move.start, move.held, move.displacement, work);
}

/// What costs least first.
constexpr Start kStarts[] = {as_it_was_moved, by_biharmonic_functions, in_steps};

/// None where this start needs what the mesh before the move has not got, such as valid elements.
std::optional<Points> positions_of(Start start, const Move& move, UntangleResult& work)
{
    try {
        Points positions = start(move, work);
        for (const Index v : move.held.vertices)
            positions.row(v) = move.moved.row(v);
        return positions;
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const SolverError&) {
        return std::nullopt;
    }
}

} // namespace

UntangleResult repair(Mesh& mesh, const PositionsView& before)
{
    const Move move = move_of(mesh, before);
    std::optional<UntangleResult> best;
    UntangleResult work;
    UntangleOptions options;
    for (const Start start : kStarts) {
        std::optional<Points> positions = positions_of(start, move, work);
        if (!positions)
            continue;
        UntangleResult end = untangle(mesh, before, move.held.vertices, *positions, options);
        options.reinitialize = false; // would be the same once more
        work.patch_vertices += end.patch_vertices;
        work.iterations += end.iterations;
        if (!best || end.inverted.size() < best->inverted.size()) {
            points(mesh) = *positions;
            best = std::move(end);
        }
        if (best->valid || !best->unrepairable.empty())
            break;
    }
    best->patch_vertices = work.patch_vertices;
    best->iterations = work.iterations;
    return *best;
}

} // namespace morph
