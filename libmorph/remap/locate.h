#pragma once

#include "libmorph/geometry/element_tree.h"
#include "libmorph/mesh/mesh.h"

#include <memory>
#include <mutex>
#include <vector>

namespace morph {

/// The elements of a source mesh that hold points, the targets.
struct ContainingElements {
    std::vector<Index> face;  ///< the element that holds target i; -1: none does
    std::vector<Index> order; ///< the targets along a space-filling curve: visited so, one finds in memory
                              ///  what the one before has fetched
};

/// Finds the element of a planar mesh that holds a point, for many points: exactly, and fast when they are
/// visited along a space-filling curve.
///
/// From the element of the point before, walk towards the next one across whichever side has it beyond
/// [Devillers, Pion & Teillaud 2002, International Journal of Foundations of Computer Science 13(2), 181-199:
/// the visibility walk]; the first of each block of points starts from the nearest of a sample of vertices
/// [Mücke, Saias & Zhu 1999, Computational Geometry 12, 63-83]. A walk takes a few steps between neighbouring
/// points and O(sqrt m) from a sample. Where it leaves the mesh through a hole or a concave side, or has
/// not arrived after 64 + 2 sqrt(m) steps (a triangulation that is not Delaunay can lead it around in a
/// circle), an ElementTree answers in O(log m). So n points cost O(n + sqrt(m)) when they lie as dense as the
/// mesh, and never more than O(n (sqrt(m) + log m)), plus O(m log m) once if the tree is needed.
///
/// Every side is decided exactly. A point on a side or a vertex belongs to the element around that comes
/// first in the file; on the boundary of the mesh to the first of all, also where parts of the mesh only
/// touch. In a tangled mesh, where elements overlap, a point strictly inside several of them belongs to one
/// of them, the same in every run.
class Locator {
public:
    /// @param source  outlives the locator and is not moved while it lives
    explicit Locator(const Mesh& source);

    /// Locate every target in a planar source.
    ///
    /// Equal results for any thread count.
    /// @param targets  n x 3, z = 0
    /// @throws InputError  a coordinate of a target is not finite, or z is not 0; names the target from 0
    ContainingElements locate(const Eigen::Ref<const Points>& targets) const;

    /// The tree behind the walks, built when it is first asked for; from any thread.
    const ElementTree& tree() const;

    const Mesh& source() const { return source_; }

private:
    Index face_near(double x, double y) const;

    const Mesh& source_;
    Eigen::AlignedBox3d box_;
    std::vector<Index> samples_; ///< faces spread evenly over the numbering
    mutable std::once_flag tree_built_;
    mutable std::unique_ptr<ElementTree> tree_;
};

} // namespace morph
