#include "libmorph/pipeline/lattice_placement.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/harmonic_curves.h"
#include "libmorph/weights/lattice_weights.h"

#include <algorithm>

namespace morph {

namespace {

/// Control points within @p layers of a face of the lattice.
std::vector<Index> outer_control_points(const Lattice& lattice, Index layers)
{
    std::vector<Index> outer;
    for (Index row = 0; row < lattice.control_point_count(); ++row) {
        const auto at = lattice.indices_of(row);
        bool near = false;
        for (std::size_t d = 0; d < static_cast<std::size_t>(lattice.dimension()); ++d)
            near = near || at[d] < layers || at[d] >= lattice.definition().points[d] - layers;
        if (near)
            outer.push_back(row);
    }
    return outer;
}

/// Vertices outside that share an edge with one inside: where the move may tear the mesh.
bool box_cuts_mesh(const Mesh& mesh, const Embedding& embedding)
{
    const auto inside = [&](VertexHandle v) {
        return embedding.inside[static_cast<std::size_t>(v.idx())] != 0;
    };
    for (const EdgeHandle edge : mesh.kernel.edges()) {
        const HalfedgeHandle side = mesh.kernel.halfedge_handle(edge, 0);
        if (inside(mesh.kernel.from_vertex_handle(side)) != inside(mesh.kernel.to_vertex_handle(side)))
            return true;
    }
    return false;
}

void warn_of_folds(const LatticeTree& tree, PlacedLattice& placed)
{
    if (tree.folded_cells().empty())
        return;
    const auto& [i, j, k] = tree.folded_cells().front().cell;
    placed.warnings.push_back("[lattice] is folded in " + std::to_string(tree.folded_cells().size()) +
                              " of its cells, the first from control point (" + std::to_string(i) + ", " +
                              std::to_string(j) +
                              (placed.lattice.dimension() == 3 ? ", " + std::to_string(k) : "") +
                              ") on: a point there may have several places in it");
}

void warn_of_tears(const Mesh& mesh, const DeformSettings& deform, PlacedLattice& placed)
{
    const std::vector<Index> face = outer_control_points(placed.lattice, 1);
    const bool moves_faces = std::any_of(face.begin(), face.end(),
                                         [&](Index row) { return !placed.displacements.row(row).isZero(0); });
    if (deform.method == Method::ffd && moves_faces && box_cuts_mesh(mesh, placed.embedding))
        placed.warnings.push_back(
            "[lattice] moves control points on its faces while the mesh goes on outside: it tears "
            "there; continuity = 1 holds them, or make the box larger");
}

/// Control points that continuity holds lose their displacement.
void hold_outer(const LatticeSettings& settings, PlacedLattice& placed)
{
    if (settings.continuity < 0)
        return;
    placed.held = outer_control_points(placed.lattice, settings.continuity + 1);
    std::size_t moved = 0;
    for (const Index row : placed.held) {
        moved += placed.displacements.row(row).isZero(0) ? 0 : 1;
        placed.displacements.row(row).setZero();
    }
    if (moved > 0)
        placed.warnings.push_back("[lattice] continuity = " + std::to_string(settings.continuity) +
                                  " holds " + std::to_string(moved) +
                                  " control points that have displacements");
}

/// Of all control points, in the dimension of the mesh.
Matrix lattice_displacements(const LatticeSettings& settings, const Lattice& lattice)
{
    const Matrix& given = settings.displacements;
    if (given.size() == 0)
        return Matrix::Zero(lattice.control_point_count(), lattice.dimension());
    if (given.rows() != lattice.control_point_count() || given.cols() < lattice.dimension())
        throw InputError("displacements is " + std::to_string(given.rows()) + " x " +
                         std::to_string(given.cols()) + ", expected " +
                         std::to_string(lattice.control_point_count()) + " x " +
                         std::to_string(lattice.dimension()));
    if (!given.allFinite())
        throw InputError("displacements must be finite numbers");
    return given.leftCols(lattice.dimension());
}

std::vector<std::string> lattice_markers(const Mesh& mesh, const MotionSettings& settings,
                                         const PlacedLattice& placed)
{
    if (!settings.lattice->markers.empty())
        return settings.lattice->markers;
    std::vector<std::string> inside;
    const std::vector<std::string> fixed = settings.deform.fixed.value_or(std::vector<std::string>());
    for (const Marker& candidate : mesh.markers) {
        const bool held = std::find(fixed.begin(), fixed.end(), candidate.name) != fixed.end();
        const std::vector<Index> vertices = marker_vertices(candidate);
        if (!held && std::any_of(vertices.begin(), vertices.end(), [&](Index v) {
                return placed.embedding.inside[static_cast<std::size_t>(v)] != 0;
            }))
            inside.push_back(candidate.name);
    }
    return inside;
}

} // namespace

PlacedLattice place_lattice(const Mesh& mesh, const MotionSettings& settings)
{
    const LatticeSettings& given = *settings.lattice;
    Lattice lattice = make_lattice(given);
    try {
        if (lattice.dimension() != mesh.dimension)
            throw InputError(mesh.dimension == 2
                                 ? "is in space, but the mesh is planar: points must be [n, m]"
                                 : "is planar, but the mesh is a surface: points must be [n, m, l]");
        const LatticeTree tree(lattice);
        Embedding embedding = embed(tree, points(mesh));
        if (embedding.inside_count == 0)
            throw InputError("holds no vertex of the mesh");
        SparseWeights weights = lattice_weights(lattice, embedding);
        Matrix displacements = lattice_displacements(given, lattice);
        PlacedLattice placed{
            std::move(lattice), std::move(embedding), std::move(weights), std::move(displacements), {}, {}};
        warn_of_folds(tree, placed);
        hold_outer(given, placed);
        warn_of_tears(mesh, settings.deform, placed);
        return placed;
    } catch (const InputError& error) {
        throw InputError(given.where + "[lattice] " + error.what());
    }
}

PlacedBoundaries lattice_boundary(const Mesh& mesh, const MotionSettings& settings,
                                  const PlacedLattice& placed)
{
    const std::string where = settings.lattice->where + "[lattice] ";
    const std::vector<std::string> markers = lattice_markers(mesh, settings, placed);
    if (markers.empty())
        throw InputError(where + "holds no part of a marker that is not fixed");
    std::vector<std::string> fixed = settings.deform.fixed.value_or(other_markers(mesh, markers));
    for (const std::string& name : markers)
        if (std::find(fixed.begin(), fixed.end(), name) != fixed.end())
            throw InputError(where + "moves marker '" + name + "', which is fixed as well");
    std::vector<std::string> all = fixed;
    all.insert(all.end(), markers.begin(), markers.end());
    PlacedBoundaries result;
    result.conditions = boundary_conditions(mesh, {}, all);
    result.conditions.columns = placed.weights.columns;
    DirichletBoundary& boundary = result.conditions.boundary;
    Matrix& values = result.conditions.values;
    values = Matrix::Zero(static_cast<Index>(boundary.vertices.size()), placed.weights.values.cols());
    std::vector<bool> moves(static_cast<std::size_t>(vertex_count(mesh)));
    for (const std::string& name : markers) {
        const Marker& moving = marker(mesh, name);
        for (const Index v : marker_vertices(moving))
            moves[static_cast<std::size_t>(v)] = true;
        boundary.moving_edges.insert(boundary.moving_edges.end(), moving.edges.begin(), moving.edges.end());
    }
    for (const std::string& name : fixed)
        for (const Index v : marker_vertices(marker(mesh, name)))
            moves[static_cast<std::size_t>(v)] = false;
    for (std::size_t i = 0; i < boundary.vertices.size(); ++i)
        if (moves[static_cast<std::size_t>(boundary.vertices[i])])
            values.row(static_cast<Index>(i)) = Matrix(placed.weights.values.row(boundary.vertices[i]));
    result.displacements = placed.displacements;
    return result;
}

} // namespace morph
