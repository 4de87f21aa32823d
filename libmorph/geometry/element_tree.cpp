#include "libmorph/geometry/element_tree.h"

#include "libmorph/core/parallel.h"
#include "libmorph/geometry/closest_on_triangle.h"
#include "libmorph/geometry/plane_element.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace morph {

namespace {

constexpr Index kBlock = 32; // elements; by measurement, see tests/bench/README.md

using Box = Eigen::AlignedBox3d;
using BoxKernel = CGAL::Simple_cartesian<double>;

CGAL::Bbox_3 to_cgal(const Box& box)
{
    return {box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z()};
}

struct BlockBox {
    Index block = 0;
    CGAL::Bbox_3 box;

    CGAL::Bbox_3 bbox() const { return box; }
};

/// A block as CGAL's concept AABBPrimitive has it.
class BlockPrimitive {
public:
    using Id = Index;
    using Point = BoxKernel::Point_3;
    using Datum = BlockBox;

    explicit BlockPrimitive(std::vector<BlockBox>::const_iterator block) : block_(*block) {}

    Id id() const { return block_.block; }
    const Datum& datum() const { return block_; }
    Point reference_point() const
    {
        const auto middle = [this](int axis) { return block_.box.min(axis) / 2 + block_.box.max(axis) / 2; };
        return {middle(0), middle(1), middle(2)};
    }

private:
    BlockBox block_;
};

using BlockTree = CGAL::AABB_tree<CGAL::AABB_traits<BoxKernel, BlockPrimitive>>;

/// The square of the distance from a point to a box.
double distance2(const CGAL::Bbox_3& box, const Eigen::Vector3d& p)
{
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double outside = std::max({box.min(axis) - p[axis], p[axis] - box.max(axis), 0.0});
        sum += outside * outside;
    }
    return sum;
}

/// A walk through the tree that passes over what is outside of a box.
template <typename Visit>
struct BoxWalk {
    Visit visit;

    template <typename Node>
    bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const
    {
        return CGAL::do_overlap(box, node.bbox());
    }
    void intersection(const CGAL::Bbox_3& box, const BlockPrimitive& block)
    {
        if (CGAL::do_overlap(box, block.datum().box))
            visit(block.id());
    }
    bool go_further() const { return true; }
};

/// A walk through the tree, near boxes first, that passes over what is farther than what was found.
template <typename Visit>
struct NearestWalk {
    using Priority = double;

    const double& best2;
    Visit visit;

    template <typename Node>
    bool do_intersect(const Eigen::Vector3d& p, const Node& node) const
    {
        return distance2(node.bbox(), p) <= best2;
    }
    template <typename Node>
    std::pair<bool, Priority> do_intersect_with_priority(const Eigen::Vector3d& p, const Node& node) const
    {
        const double near2 = distance2(node.bbox(), p);
        return {near2 <= best2, -near2};
    }
    void intersection(const Eigen::Vector3d& p, const BlockPrimitive& block)
    {
        if (distance2(block.datum().box, p) <= best2)
            visit(block.id());
    }
    bool go_further() const { return true; }
};

} // namespace

class ElementTree::Blocks {
public:
    explicit Blocks(const Mesh& mesh) : mesh_(mesh)
    {
        const auto blocks = static_cast<std::size_t>((element_count(mesh) + kBlock - 1) / kBlock);
        std::vector<BlockBox> boxes(blocks);
        constexpr std::size_t kRowsPerBlock = 1024;
        parallel_for(blocks, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) {
                Box box;
                for_each_element(static_cast<Index>(b), [&](Index face) { box.extend(box_of(face)); });
                boxes[b] = {static_cast<Index>(b), to_cgal(box)};
            }
        });
        tree_.insert(boxes.cbegin(), boxes.cend());
        tree_.build();
    }

    /// Call visit(face) for each element whose box meets @p box.
    template <typename Visit>
    void in_box(const Box& box, const Visit& visit) const
    {
        const auto visit_block = [&](Index block) {
            for_each_element(block, [&](Index face) {
                if (box_of(face).intersects(box))
                    visit(face);
            });
        };
        BoxWalk<decltype(visit_block)> walk{visit_block};
        tree_.traversal(to_cgal(box), walk);
    }

    Closest closest(const Eigen::Vector3d& p) const
    {
        Closest best;
        double best2 = std::numeric_limits<double>::infinity();
        const auto visit_block = [&](Index block) {
            for_each_element(block, [&](Index face) {
                if (box_of(face).squaredExteriorDistance(p) <= best2)
                    improve(face, p, best, best2);
            });
        };
        NearestWalk<decltype(visit_block)> walk{best2, visit_block};
        tree_.traversal_with_priority(p, walk);
        best.distance = std::sqrt(best2);
        return best;
    }

    bool holds(Index face, PlanePoint p) const { return contains(plane_element(mesh_, face), p); }
    Index file_number(Index face) const { return mesh_.numbering.element[static_cast<std::size_t>(face)]; }

private:
    template <typename Visit>
    void for_each_element(Index block, const Visit& visit) const
    {
        const Index end = std::min(element_count(mesh_), (block + 1) * kBlock);
        for (Index face = block * kBlock; face < end; ++face)
            visit(face);
    }

    Eigen::Vector3d position(VertexHandle v) const
    {
        return Eigen::Map<const Eigen::Vector3d>(mesh_.kernel.point(v).data());
    }

    Box box_of(Index face) const
    {
        Box box;
        const HalfedgeHandle first = mesh_.kernel.halfedge_handle(FaceHandle(face));
        HalfedgeHandle side = first;
        do {
            box.extend(position(mesh_.kernel.to_vertex_handle(side)));
            side = mesh_.kernel.next_halfedge_handle(side);
        } while (side != first);
        return box;
    }

    void improve(Index face, const Eigen::Vector3d& p, Closest& best, double& best2) const
    {
        const Element element = element_corners(mesh_, face);
        if (corner_count(element) == 3)
            return improve(face, element, {0, 1, 2}, p, best, best2);
        const Diagonal diagonal =
            mesh_.dimension == 2 ? inner_diagonal(plane_element(mesh_, face)) : Diagonal::first_third;
        for (const auto& half : halves(diagonal))
            improve(face, element, half, p, best, best2);
    }

    /// The same with the triangle of these corners of the element.
    void improve(Index face, const Element& element, const std::array<int, 3>& triangle,
                 const Eigen::Vector3d& p, Closest& best, double& best2) const
    {
        std::array<Eigen::Vector3d, 3> corner;
        for (std::size_t k = 0; k < 3; ++k)
            corner[k] = position(VertexHandle(element[static_cast<std::size_t>(triangle[k])]));
        const TrianglePoint found = closest_on_triangle(corner, p);
        const bool first = best.face < 0 || file_number(face) < file_number(best.face);
        if (found.distance2 > best2 || (found.distance2 == best2 && !first))
            return;
        best2 = found.distance2;
        best.face = face;
        best.point = found.point;
        best.feature = feature_of_element(found.feature, triangle, corner_count(element));
    }

    /// A side or corner of a triangle as one of the element it is part of; a diagonal is inside.
    static int feature_of_element(int feature, const std::array<int, 3>& triangle, int corners)
    {
        if (feature == 0)
            return 0;
        const auto k = static_cast<std::size_t>(std::abs(feature) - 1);
        if (feature < 0)
            return -triangle[k] - 1;
        const bool side = triangle[(k + 1) % 3] == (triangle[k] + 1) % corners;
        return side ? triangle[k] + 1 : 0;
    }

    const Mesh& mesh_;
    BlockTree tree_;
};

ElementTree::ElementTree(const Mesh& mesh) : blocks_(std::make_unique<Blocks>(mesh)) {}

ElementTree::~ElementTree() = default;

Index ElementTree::containing(double x, double y) const
{
    Index lowest = -1;
    const Eigen::Vector3d point(x, y, 0);
    blocks_->in_box(Box(point, point), [&](Index face) {
        const bool first = lowest < 0 || blocks_->file_number(face) < blocks_->file_number(lowest);
        if (first && blocks_->holds(face, {x, y}))
            lowest = face;
    });
    return lowest;
}

void ElementTree::overlapping(const Box& box, std::vector<Index>& faces) const
{
    faces.clear();
    blocks_->in_box(box, [&](Index face) { faces.push_back(face); });
    std::sort(faces.begin(), faces.end());
}

ElementTree::Closest ElementTree::closest(const Eigen::Vector3d& point) const
{
    return blocks_->closest(point);
}

} // namespace morph
