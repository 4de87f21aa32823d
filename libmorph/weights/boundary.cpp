#include "libmorph/weights/boundary.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/chain.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace morph {

namespace {

/// Everything that wants to say how a vertex moves.
struct Claims {
    Index vertex = 0; ///< one of its copies, where it is split
    std::vector<SharedVertex::Claim> rows;
    std::string fixed_by;
};

/// By file number, so that copies of a split vertex move as one.
using ClaimsByVertex = std::map<Index, Claims>;

Index file_number(const Mesh& mesh, Index v)
{
    return mesh.numbering.vertex[static_cast<std::size_t>(v)];
}

Claims& claims_of(const Mesh& mesh, Index v, ClaimsByVertex& claims)
{
    Claims& claim = claims[file_number(mesh, v)];
    claim.vertex = v;
    return claim;
}

bool is_end(const CurveParameter& parameter)
{
    return parameter.u == 0 || parameter.u == 1;
}

/// Both ends of an open curve that meet in one vertex of a closed marker claim it.
void claim_vertex(const Mesh& mesh, const CurveBoundary& boundary, std::size_t number, std::size_t node,
                  ClaimsByVertex& claims)
{
    const CurveParameter& parameter = boundary.parameters[node];
    std::vector<SharedVertex::Claim>& rows = claims_of(mesh, boundary.vertices[node], claims).rows;
    if (boundary.closed_chain && !boundary.curve.closed() && is_end(parameter)) {
        rows.push_back({number, boundary.curve.basis(0)});
        rows.push_back({number, boundary.curve.basis(1)});
        return;
    }
    rows.push_back({number, boundary.curve.basis(parameter.u)});
}

void claim_fixed(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                 const std::vector<std::string>& fixed, ClaimsByVertex& claims)
{
    for (const std::string& name : fixed) {
        const bool carried =
            std::any_of(boundaries.begin(), boundaries.end(),
                        [&](const CurveBoundary& boundary) { return boundary.name == name; });
        if (carried)
            throw InputError("marker '" + name +
                             "' is fixed and has a [[boundary]] as well; take one of them away");
        for (const Index v : marker_vertices(marker(mesh, name)))
            claims_of(mesh, v, claims).fixed_by = name;
    }
}

/// Vertices of the boundary that no marker at all names; their move is not given, so they stay.
Index claim_unmarked(const Mesh& mesh, ClaimsByVertex& claims)
{
    std::vector<bool> marked(static_cast<std::size_t>(mesh.numbering.file_vertices));
    for (const Marker& m : mesh.markers)
        for (const auto& edge : m.edges)
            for (const Index v : edge)
                marked[static_cast<std::size_t>(file_number(mesh, v))] = true;
    Index unmarked = 0;
    for (const VertexHandle v : mesh.kernel.vertices()) {
        const bool known = marked[static_cast<std::size_t>(file_number(mesh, v.idx()))];
        if (known || mesh.kernel.is_isolated(v) || !mesh.kernel.is_boundary(v))
            continue;
        claims_of(mesh, v.idx(), claims).fixed_by = "(no marker)";
        ++unmarked;
    }
    return unmarked;
}

void lay_out_columns(const std::vector<CurveBoundary>& boundaries, BoundaryConditions& conditions)
{
    for (const CurveBoundary& boundary : boundaries) {
        conditions.first_column.push_back(static_cast<Index>(conditions.columns.size()));
        for (Index i = 0; i < boundary.curve.control_point_count(); ++i)
            conditions.columns.push_back({boundary.name, i});
    }
}

void prescribe(const ClaimsByVertex& claims, BoundaryConditions& conditions)
{
    const auto columns = static_cast<Eigen::Index>(conditions.columns.size());
    conditions.values = Matrix::Zero(static_cast<Eigen::Index>(claims.size()), columns);
    for (const auto& [number, claim] : claims) {
        const auto row = static_cast<Eigen::Index>(conditions.boundary.vertices.size());
        conditions.boundary.vertices.push_back(claim.vertex);
        if (claim.rows.size() > 1 || (!claim.rows.empty() && !claim.fixed_by.empty()))
            conditions.shared.push_back({claim.vertex, claim.rows, claim.fixed_by});
        if (!claim.fixed_by.empty())
            continue;
        const double share = 1.0 / static_cast<double>(claim.rows.size());
        for (const auto& [boundary, basis] : claim.rows)
            for (int k = 0; k < basis.count; ++k)
                conditions.values(row, conditions.first_column[boundary] +
                                           basis.control[static_cast<std::size_t>(k)]) +=
                    share * basis.value[static_cast<std::size_t>(k)];
    }
}

void collect_edges(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                   const std::vector<std::string>& fixed, BoundaryConditions& conditions)
{
    const auto append = [&mesh](const std::string& name, std::vector<std::array<Index, 2>>& list) {
        const auto& edges = marker(mesh, name).edges;
        list.insert(list.end(), edges.begin(), edges.end());
    };
    for (const CurveBoundary& boundary : boundaries)
        append(boundary.name, conditions.boundary.moving_edges);
    for (const std::string& name : fixed)
        append(name, conditions.boundary.fixed_edges);
}

/// The displacement that a claim gives its vertex.
Eigen::RowVector2d claimed_move(const SharedVertex::Claim& claim, Index first_column,
                                const Points2& displacements)
{
    Eigen::RowVector2d move(0, 0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(claim.row.count); ++k)
        move += claim.row.value[k] * displacements.row(first_column + claim.row.control[k]);
    return move;
}

/// "boundary 'upper', control point 1", the one with the largest share.
std::string claimant(const SharedVertex::Claim& claim, const std::vector<CurveBoundary>& boundaries)
{
    const auto largest = std::max_element(claim.row.value.begin(), claim.row.value.begin() + claim.row.count);
    const Index point = claim.row.control[static_cast<std::size_t>(largest - claim.row.value.begin())];
    return "boundary '" + boundaries[claim.boundary].name + "', control point " + std::to_string(point + 1);
}

std::string pair_text(const Eigen::RowVector2d& move)
{
    std::ostringstream text;
    text << '(' << move.x() << ", " << move.y() << ')';
    return text.str();
}

} // namespace

CurveBoundary parametrize_marker(const Mesh& mesh, const std::string& marker_name, const Curve& curve)
{
    if (mesh.dimension != 2)
        throw InputError("boundary '" + marker_name +
                         "': curves carry planar meshes, but this is a surface in space");
    const Chain chain = marker_chain(marker(mesh, marker_name), mesh.numbering);
    const auto positions = points(mesh);
    Points2 nodes(static_cast<Eigen::Index>(chain.vertices.size()), 2);
    for (Eigen::Index i = 0; i < nodes.rows(); ++i)
        nodes.row(i) = positions.row(chain.vertices[static_cast<std::size_t>(i)]).head<2>();
    try {
        return {marker_name, curve, chain.vertices, node_parameters(curve, nodes, chain.closed),
                chain.closed};
    } catch (const InputError& error) {
        throw InputError("boundary '" + marker_name + "': " + error.what());
    }
}

BoundaryConditions boundary_conditions(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                                       const std::vector<std::string>& fixed)
{
    ClaimsByVertex claims;
    for (std::size_t b = 0; b < boundaries.size(); ++b)
        for (std::size_t node = 0; node < boundaries[b].vertices.size(); ++node)
            claim_vertex(mesh, boundaries[b], b, node, claims);
    claim_fixed(mesh, boundaries, fixed, claims);
    BoundaryConditions conditions;
    conditions.unmarked = claim_unmarked(mesh, claims);
    lay_out_columns(boundaries, conditions);
    prescribe(claims, conditions);
    collect_edges(mesh, boundaries, fixed, conditions);
    return conditions;
}

BoundaryConditions boundary_conditions(const Mesh& mesh, const std::vector<NamedCurve>& curves)
{
    std::vector<CurveBoundary> boundaries;
    std::vector<std::string> carried;
    for (const NamedCurve& named : curves) {
        boundaries.push_back(parametrize_marker(mesh, named.marker, named.curve));
        carried.push_back(named.marker);
    }
    return boundary_conditions(mesh, boundaries, other_markers(mesh, carried));
}

std::vector<std::string> other_markers(const Mesh& mesh, const std::vector<std::string>& carried)
{
    std::vector<std::string> names;
    const auto contains = [](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const Marker& m : mesh.markers)
        if (!contains(carried, m.name) && !contains(names, m.name))
            names.push_back(m.name);
    return names;
}

Weights extended_weights(const BoundaryConditions& conditions, const BoundaryExtension& extension)
{
    if (extension.components() != 1)
        throw InputError("the method extends vectors of " + std::to_string(extension.components()) +
                         " components that influence each other: one weight for each control point does not "
                         "express that");
    return {conditions.columns, extension.extend(conditions.values)};
}

void require_ends_together(const Mesh& mesh, const std::vector<CurveBoundary>& boundaries,
                           const BoundaryConditions& conditions, const Points2& displacements)
{
    if (displacements.size() == 0)
        return; // without curves there is no largest displacement
    // Displacements that are meant to be equal are typed alike; this only forgives their last digits.
    const double tolerance = 1e-12 * displacements.cwiseAbs().maxCoeff();
    for (const SharedVertex& shared : conditions.shared) {
        const std::string vertex = "vertex " + std::to_string(file_number(mesh, shared.vertex));
        const auto move_of = [&](const SharedVertex::Claim& claim) {
            return claimed_move(claim, conditions.first_column[claim.boundary], displacements);
        };
        const Eigen::RowVector2d wanted =
            shared.fixed_by.empty() ? move_of(shared.claims[0]) : Eigen::RowVector2d(0, 0);
        for (const SharedVertex::Claim& claim : shared.claims) {
            const Eigen::RowVector2d move = move_of(claim);
            if ((move - wanted).norm() <= tolerance)
                continue;
            const std::string who =
                claimant(claim, boundaries) + " moves its end, " + vertex + ", by " + pair_text(move);
            if (!shared.fixed_by.empty())
                throw InputError(who + ", but marker '" + shared.fixed_by + "' holds it fixed");
            throw InputError(who + ", but " + claimant(shared.claims[0], boundaries) + " moves it by " +
                             pair_text(wanted) + "; ends that meet must move alike");
        }
    }
}

} // namespace morph
