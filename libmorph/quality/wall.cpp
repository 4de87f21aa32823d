#include "libmorph/quality/wall.h"

#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morph {

namespace {

void require_rows(const Mesh& mesh, const PositionsView& positions)
{
    if (positions.rows() != vertex_count(mesh))
        throw InputError("there are " + std::to_string(positions.rows()) + " positions, but the mesh has " +
                         std::to_string(vertex_count(mesh)) + " vertices");
}

/// Corners of an element, those of the wall first: from, to, and the others in order.
std::vector<Eigen::Vector3d> corners_from_wall(const Mesh& mesh, HalfedgeHandle wall,
                                               const PositionsView& positions)
{
    std::vector<Eigen::Vector3d> corners;
    HalfedgeHandle side = wall;
    do {
        corners.push_back(positions.row(mesh.kernel.from_vertex_handle(side).idx()));
        side = mesh.kernel.next_halfedge_handle(side);
    } while (side != wall);
    return corners;
}

/// Normal of the element; of a planar mesh always the z axis, whichever way the element lies.
Eigen::Vector3d element_normal(const std::vector<Eigen::Vector3d>& p, int dimension)
{
    if (dimension == 2)
        return Eigen::Vector3d::UnitZ();
    return (p[2] - p[0]).cross(p.back() - p[1]);
}

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b)) * (180 / std::numbers::pi);
}

WallCell cell_beside(const Mesh& mesh, HalfedgeHandle wall, const PositionsView& positions)
{
    WallCell cell;
    cell.edge = {mesh.kernel.from_vertex_handle(wall).idx(), mesh.kernel.to_vertex_handle(wall).idx()};
    cell.face = mesh.kernel.face_handle(wall).idx();
    const auto p = corners_from_wall(mesh, wall, positions);
    const Eigen::Vector3d along = p[1] - p[0];
    const Eigen::Vector3d inward = element_normal(p, mesh.dimension).cross(along).stableNormalized();
    if (inward.isZero(0))
        return cell;
    for (std::size_t k = 2; k < p.size(); ++k)
        cell.height += inward.dot(p[k] - p[0]) / static_cast<double>(p.size() - 2);
    const double first = degrees_between(inward, p.back() - p[0]);
    const double second = degrees_between(inward, p[2] - p[1]);
    cell.angle = p.size() == 3 ? std::min(first, second) : std::max(first, second);
    return cell;
}

ValueRange range_of(const std::vector<WallCell>& cells, double WallCell::*value)
{
    ValueRange s{cells.front().*value, 0, cells.front().*value};
    for (const WallCell& cell : cells) {
        s.min = std::min(s.min, cell.*value);
        s.max = std::max(s.max, cell.*value);
        s.mean += cell.*value / static_cast<double>(cells.size());
    }
    return s;
}

/// The cell where a change is largest, the first of them.
WallPlace largest_change(const Mesh& mesh, const PositionsView& positions,
                         const std::vector<WallCell>& before, const std::vector<WallCell>& after,
                         double (*change)(const WallCell&, const WallCell&))
{
    WallPlace largest{-1};
    for (std::size_t i = 0; i < after.size(); ++i) {
        const double value = change(before[i], after[i]);
        if (value <= largest.value)
            continue;
        const auto [from, to] = after[i].edge;
        largest = {value, mesh.numbering.element[static_cast<std::size_t>(after[i].face)],
                   (positions.row(from) + positions.row(to)).transpose() / 2};
    }
    return largest;
}

} // namespace

std::vector<WallCell> wall_cells(const Mesh& mesh, const Marker& marker, const PositionsView& positions)
{
    require_rows(mesh, positions);
    std::vector<WallCell> cells;
    for (const auto& [from, to] : marker.edges) {
        const HalfedgeHandle there = mesh.kernel.find_halfedge(VertexHandle(from), VertexHandle(to));
        for (const HalfedgeHandle side : {there, mesh.kernel.opposite_halfedge_handle(there)})
            if (!mesh.kernel.is_boundary(side))
                cells.push_back(cell_beside(mesh, side, positions));
    }
    return cells;
}

double height_change(const WallCell& before, const WallCell& after)
{
    const double change = std::abs(after.height / before.height - 1);
    if (std::isfinite(change))
        return change;
    return before.height == after.height ? 0 : std::numeric_limits<double>::max();
}

double angle_change(const WallCell& before, const WallCell& after)
{
    return std::abs(after.angle - before.angle);
}

std::vector<WallQuality> wall_quality(const Mesh& mesh, const PositionsView& positions,
                                      const PositionsView* reference)
{
    std::vector<WallQuality> walls;
    for (const Marker& marker : mesh.markers) {
        const std::vector<WallCell> cells = wall_cells(mesh, marker, positions);
        if (cells.empty())
            continue;
        WallQuality wall;
        wall.marker = marker.name;
        wall.cells = static_cast<Index>(cells.size());
        wall.height = range_of(cells, &WallCell::height);
        wall.angle = range_of(cells, &WallCell::angle);
        if (reference != nullptr) {
            const std::vector<WallCell> before = wall_cells(mesh, marker, *reference);
            wall.change = {largest_change(mesh, positions, before, cells, height_change),
                           largest_change(mesh, positions, before, cells, angle_change)};
        }
        walls.push_back(wall);
    }
    return walls;
}

} // namespace morph
