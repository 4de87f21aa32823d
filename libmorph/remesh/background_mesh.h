#pragma once

#include "libmorph/remesh/corner_table.h"

#include <functional>
#include <utility>

namespace morph {

/// The mesh as it was before remeshing: the target sizes are known on it, and vertices stay on its surface.
///
/// Points are found by a walk from a triangle nearby, which takes a few steps. Where a hole or a border is in
/// the way, or the surface folds, the walk ends at the nearest place it reaches; that costs accuracy of a
/// size, never a valid mesh.
class BackgroundMesh {
public:
    /// @param table   triangles of the input
    /// @param planar  points are found by which triangle holds them, else by which is closest
    BackgroundMesh(const CornerTable& table, bool planar) : table_(table), planar_(planar) {}

    struct Place {
        Index triangle = 0;
        Eigen::Vector3d point; ///< on the triangle, the point asked for or the closest
        double size = 0;       ///< target edge length there
    };
    /// @param point  in space or, planar, with z = 0
    /// @param near   triangle to start from
    Place find(const Eigen::Vector3d& point, Index near) const;

    /// In the plane: where to go on when a walk is long or ends at a border. Meshes made from far apart
    /// vertices need it: a walk around a body does not get to its other side.
    /// @param jump  the triangle at or near a point, -1: not known
    void jump_with(std::function<Index(const Eigen::Vector3d&)> jump) { jump_ = std::move(jump); }

    /// Target sizes as vertices of the input are numbered; may be changed before find() is called.
    std::vector<TableVertex>& vertices() { return table_.vertices; }
    const CornerTable& table() const { return table_; }

    /// Find the unit normals of the surface: at each triangle the mean of those around it by area, not across
    /// feature edges, so that a sliver of a scanned surface has that of its neighbours.
    /// @param tag  of each halfedge of the corner table, see CornerTable::tag
    void find_normals(const std::vector<Index>& tag);
    /// Zero before find_normals().
    Eigen::Vector3d normal(Index triangle) const;

private:
    Place find_in_plane(const Eigen::Vector3d& point, Index near) const;
    Place find_closest(const Eigen::Vector3d& point, Index near) const;
    double size_at(Index triangle, const Eigen::Vector3d& point) const;

    /// Walk towards a point; false where it does not get there.
    bool walk(const Eigen::Vector3d& point, Index& triangle, int longest) const;

    CornerTable table_;
    std::vector<Eigen::Vector3d> normals_;
    bool planar_;
    std::function<Index(const Eigen::Vector3d&)> jump_;
};

} // namespace morph
