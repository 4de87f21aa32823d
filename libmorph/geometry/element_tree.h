#pragma once

#include "libmorph/mesh/mesh.h"

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace morph {

/// Finds elements of a mesh by where they are: a tree of boxes.
///
/// The tree is CGAL's AABB tree over blocks of consecutive elements. Because elements are numbered along a
/// space-filling curve, a block lies together, and the tree has a small fraction of the nodes that one over
/// single elements has: it is built that much faster, in that much less memory. A query costs O(log m).
/// Every query may be asked from several threads at once.
class ElementTree {
public:
    /// @param mesh  outlives the tree and is not moved while it lives
    explicit ElementTree(const Mesh& mesh);
    ~ElementTree();
    ElementTree(const ElementTree&) = delete;
    ElementTree& operator=(const ElementTree&) = delete;

    /// Of the elements of a planar mesh that hold (x, y), sides included, the one that comes first in the
    /// file; -1 when there is none. Exact, also where elements overlap.
    Index containing(double x, double y) const;

    /// The elements whose bounding boxes meet @p box, ascending; replaces what is in @p faces.
    void overlapping(const Eigen::AlignedBox3d& box, std::vector<Index>& faces) const;

    struct Closest {
        Index face = -1;
        Eigen::Vector3d point;
        double distance = 0; ///< length unit of the mesh
        int feature = 0;     ///< 0: inside the element · k: on its side from corner k (from 1) to the next
                             ///  · -k: corner k
    };
    /// The point of the mesh closest to @p point; of equally near elements the one that comes first in the
    /// file. A quad is the two triangles along its inner diagonal (in space that from its first to its third
    /// corner). The mesh has at least one element.
    Closest closest(const Eigen::Vector3d& point) const;

private:
    class Blocks;
    std::unique_ptr<Blocks> blocks_;
};

} // namespace morph
