#include "libmorph/deform/repair.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/biharmonic.h"

#include <optional>

namespace morph {

namespace {

using Edge = std::array<Index, 2>;

/// All that is held: the boundary and the markers.
HeldBoundary held_boundary(const Mesh& mesh)
{
    const std::vector<Index> first = first_copies(mesh.numbering);
    std::vector<bool> held(first.size(), false);
    for (const auto vertex : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(vertex))
            held[static_cast<std::size_t>(first[static_cast<std::size_t>(vertex.idx())])] = true;
    HeldBoundary boundary;
    for (const Marker& marker : mesh.markers) {
        boundary.walls.insert(boundary.walls.end(), marker.edges.begin(), marker.edges.end());
        for (const Index v : marker_vertices(marker))
            held[static_cast<std::size_t>(first[static_cast<std::size_t>(v)])] = true;
    }
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (held[static_cast<std::size_t>(first[static_cast<std::size_t>(v)])])
            boundary.vertices.push_back(v);
    return boundary;
}

/// The mesh with the boundary's move carried in anew; none where that cannot be.
std::optional<Points> carried_anew(const Mesh& mesh, const PositionsView& before, const HeldBoundary& held)
{
    Mesh start = mesh;
    points(start) = before;
    Points2 displacement(static_cast<Index>(held.vertices.size()), 2);
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        displacement.row(static_cast<Index>(i)) =
            (points(mesh).row(held.vertices[i]) - before.row(held.vertices[i])).head<2>();
    try {
        points(start).leftCols<2>() += conformal_biharmonic_spread(start, held)->spread(displacement);
    } catch (const InputError&) { // inverted before the move already
        return std::nullopt;
    } catch (const SolverError&) {
        return std::nullopt;
    }
    for (const Index v : held.vertices)
        points(start).row(v) = points(mesh).row(v);
    return points(start);
}

} // namespace

UntangleResult repair(Mesh& mesh, const PositionsView& before)
{
    const HeldBoundary held = held_boundary(mesh);
    std::optional<Points> second;
    Points first = points(mesh);
    UntangleResult result = untangle(mesh, before, held.vertices, first);
    if (!result.valid && result.hopeless.empty())
        second = carried_anew(mesh, before, held);
    points(mesh) = first;
    if (!second)
        return result;
    UntangleResult again = untangle(mesh, before, held.vertices, *second);
    again.patch_vertices += result.patch_vertices;
    again.iterations += result.iterations;
    if (again.inverted.size() >= result.inverted.size())
        return result;
    points(mesh) = *second;
    return again;
}

} // namespace morph
