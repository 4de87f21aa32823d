#include "tools/deform/placed_lattice.h"

#include "formats/su2/ffd.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/weights/harmonic_curves.h"
#include "libmorph/weights/lattice_weights.h"

#include <algorithm>

namespace morph::tools {

namespace {

std::string place_of(const CaseFile& file)
{
    return file.path + ":" + std::to_string(file.lattice->line) + ": [lattice] ";
}

LatticeDefinition shape_of(const LatticeEntry& entry)
{
    LatticeDefinition shape;
    shape.dimension = entry.dimension;
    shape.basis = entry.basis == "bernstein" ? LatticeBasis::bernstein : LatticeBasis::bspline;
    shape.degree = entry.degree;
    shape.points = entry.points;
    shape.knots = entry.knots;
    shape.weights = entry.weights;
    return shape;
}

/// The FFD box of that tag in the SU2 file of the mesh.
Lattice su2_lattice(const Mesh& mesh, const CaseFile& file)
{
    std::vector<std::string> tags;
    for (const Su2FfdBox& box : su2_ffd_boxes(mesh.sections, file.mesh_file)) {
        tags.push_back(box.tag);
        if (box.tag != file.lattice->su2_box)
            continue;
        LatticeDefinition shape;
        shape.dimension = box.dimension;
        shape.basis = box.bspline ? LatticeBasis::bspline : LatticeBasis::bernstein;
        std::copy(box.degree.begin(), box.degree.end(), shape.degree.begin());
        std::copy(box.points.begin(), box.points.end(), shape.points.begin());
        shape.control_points = box.control_points;
        return Lattice(shape);
    }
    throw InputError("su2_box '" + file.lattice->su2_box + "' is not in " + file.mesh_file + ", which has " +
                     (tags.empty() ? "no FFD boxes" : joined(tags)) +
                     did_you_mean(file.lattice->su2_box, tags));
}

Lattice lattice_of(const Mesh& mesh, const CaseFile& file)
{
    const LatticeEntry& entry = *file.lattice;
    if (!entry.su2_box.empty())
        return su2_lattice(mesh, file);
    LatticeDefinition shape = shape_of(entry);
    if (entry.corners)
        return lattice_in_box(entry.corners->row(0).transpose(), entry.corners->row(1).transpose(), shape);
    if (entry.axes) {
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
        axes.leftCols(entry.dimension) = entry.axes->bottomRows(entry.dimension).transpose();
        return lattice_on_axes(entry.axes->row(0).transpose(), axes, shape);
    }
    shape.control_points = *entry.control_points;
    return Lattice(shape);
}

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

void warn_of_tears(const Mesh& mesh, const CaseFile& file, PlacedLattice& placed)
{
    const std::vector<Index> face = outer_control_points(placed.lattice, 1);
    const bool moves_faces = std::any_of(face.begin(), face.end(),
                                         [&](Index row) { return !placed.displacements.row(row).isZero(0); });
    if (file.deform.method == "ffd" && moves_faces && box_cuts_mesh(mesh, placed.embedding))
        placed.warnings.push_back(
            "[lattice] moves control points on its faces while the mesh goes on outside: it tears "
            "there; continuity = 1 holds them, or make the box larger");
}

/// Control points that continuity holds lose their displacement.
void hold_outer(const LatticeEntry& entry, PlacedLattice& placed)
{
    if (entry.continuity < 0)
        return;
    placed.held = outer_control_points(placed.lattice, entry.continuity + 1);
    std::size_t moved = 0;
    for (const Index row : placed.held) {
        moved += placed.displacements.row(row).isZero(0) ? 0 : 1;
        placed.displacements.row(row).setZero();
    }
    if (moved > 0)
        placed.warnings.push_back("[lattice] continuity = " + std::to_string(entry.continuity) + " holds " +
                                  std::to_string(moved) + " control points that have displacements");
}

std::vector<std::string> lattice_markers(const Mesh& mesh, const CaseFile& file, const PlacedLattice& placed)
{
    if (!file.lattice->markers.empty())
        return file.lattice->markers;
    std::vector<std::string> inside;
    const std::vector<std::string> fixed = file.deform.fixed.value_or(std::vector<std::string>());
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

PlacedLattice place_lattice(const Mesh& mesh, const CaseFile& file)
{
    try {
        const LatticeEntry& entry = *file.lattice;
        Lattice lattice = lattice_of(mesh, file);
        if (lattice.dimension() != mesh.dimension)
            throw InputError(mesh.dimension == 2
                                 ? "is in space, but the mesh is planar: points must be [n, m]"
                                 : "is planar, but the mesh is a surface: points must be [n, m, l]");
        const LatticeTree tree(lattice);
        Embedding embedding = embed(tree, points(mesh));
        if (embedding.inside_count == 0)
            throw InputError("holds no vertex of the mesh");
        SparseWeights weights = lattice_weights(lattice, embedding);
        const std::array<Index, 3>& counts = lattice.definition().points;
        const Matrix displacements = entry.su2_box.empty()
                                         ? entry.displacements
                                         : spread_displacements(entry.sparse_displacements, counts,
                                                                file.path + ":" + std::to_string(entry.line));
        PlacedLattice placed{std::move(lattice),
                             std::move(embedding),
                             std::move(weights),
                             displacements.leftCols(mesh.dimension),
                             {},
                             {}};
        warn_of_folds(tree, placed);
        hold_outer(entry, placed);
        warn_of_tears(mesh, file, placed);
        return placed;
    } catch (const InputError& error) {
        throw InputError(place_of(file) + error.what());
    }
}

PlacedBoundaries lattice_boundary(const Mesh& mesh, const CaseFile& file, const PlacedLattice& placed)
{
    const std::vector<std::string> markers = lattice_markers(mesh, file, placed);
    if (markers.empty())
        throw InputError(place_of(file) + "holds no part of a marker that is not fixed");
    std::vector<std::string> fixed = file.deform.fixed.value_or(other_markers(mesh, markers));
    for (const std::string& name : markers)
        if (std::find(fixed.begin(), fixed.end(), name) != fixed.end())
            throw InputError(place_of(file) + "moves marker '" + name + "', which is fixed as well");
    std::vector<std::string> all = fixed;
    all.insert(all.end(), markers.begin(), markers.end());
    PlacedBoundaries result;
    result.conditions = boundary_conditions(mesh, {}, all);
    result.conditions.columns = placed.weights.columns;
    DirichletSet& held = result.conditions.held;
    held.values = Matrix::Zero(static_cast<Index>(held.vertices.size()), placed.weights.values.cols());
    std::vector<bool> moves(static_cast<std::size_t>(vertex_count(mesh)));
    for (const std::string& name : markers) {
        const Marker& moving = marker(mesh, name);
        for (const Index v : marker_vertices(moving))
            moves[static_cast<std::size_t>(v)] = true;
        result.conditions.moving_edges.insert(result.conditions.moving_edges.end(), moving.edges.begin(),
                                              moving.edges.end());
    }
    for (const std::string& name : fixed)
        for (const Index v : marker_vertices(marker(mesh, name)))
            moves[static_cast<std::size_t>(v)] = false;
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        if (moves[static_cast<std::size_t>(held.vertices[i])])
            held.values.row(static_cast<Index>(i)) = Matrix(placed.weights.values.row(held.vertices[i]));
    result.displacements = placed.displacements;
    return result;
}

} // namespace morph::tools
