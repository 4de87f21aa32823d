#pragma once

#include "libmorph/geometry/box_tree.h"
#include "libmorph/geometry/convex_piece.h"
#include "libmorph/mesh/mesh.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace morph {

/// What distances between meshes are taken of: the triangles of a surface, its quads as two along the line
/// from their first to their third corner; of a planar mesh the segments of its border and of its markers.
/// Each is found by place, through boxes around runs of parts: elements are numbered along a space-filling
/// curve, so that runs lie together.
class MeshParts {
public:
    /// @param mesh  with at least one element; outlives the parts and is not moved
    explicit MeshParts(const Mesh& mesh);

    std::size_t size() const { return parts_.size(); }
    ConvexPiece piece(std::size_t part) const;

    struct Nearest {
        std::size_t part = 0;
        double distance = 0;
    };
    /// @param hint  a part likely to be near: it saves time, and is the answer where others are as near
    Nearest nearest(const Eigen::Vector3d& p, std::size_t hint = 0) const;

    /// From a point to one part.
    double distance(std::size_t part, const Eigen::Vector3d& p) const;

    /// Of a triangle, twice its area long; of a segment to the left of it, as long as it is.
    Eigen::Vector3d normal(std::size_t part) const;

    /// Planes that stand on a part along its sides (of a segment: at its ends), as a point and the normal
    /// that points to the part; none where the part has no size.
    struct Plane {
        Eigen::Vector3d origin, normal;
    };
    std::vector<Plane> walls(std::size_t part) const;

    /// The plane on whose points the planes (lines) of two parts are equally far, of the two such planes the
    /// one between the parts as seen from @p p; its normal points to the first. Zero if they are parallel.
    Plane bisector(std::size_t one, std::size_t other, const Eigen::Vector3d& p) const;

private:
    void add_segments(const Mesh& mesh);
    void add_triangles(const Mesh& mesh);
    double distance2(std::size_t part, const Eigen::Vector3d& p) const;
    BoxTree::Box box_of(std::size_t part) const;
    /// Unit normal of a part on the side of a point, zero where it has no size.
    Eigen::Vector3d normal_towards(std::size_t part, const Eigen::Vector3d& p) const;
    Eigen::Vector3d corner(std::size_t part, std::size_t k) const;

    Eigen::Map<const Points> points_;
    bool planar_;
    std::vector<std::array<Index, 3>> parts_; ///< rows of points_; of a segment the last twice
    BoxTree tree_;
};

} // namespace morph
