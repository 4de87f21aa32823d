#include "libmorph/remap/locate.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/space_curve.h"
#include "libmorph/geometry/plane_element.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 2048; // targets that one walk after the other finds
constexpr std::size_t kAhead = 8;           // targets: long enough for memory to answer
constexpr Index kSamples = 512;             // faces among which the first walk of a block starts
constexpr Index kShortestPatience = 64;
constexpr Index kUnknown = -2; // a walk alone cannot decide

PlanePoint plane_point(const Mesh& mesh, VertexHandle v)
{
    const auto& p = mesh.kernel.point(v);
    return {p[0], p[1]};
}

void require_in_plane(const Eigen::Ref<const Points>& targets)
{
    for (Eigen::Index i = 0; i < targets.rows(); ++i) {
        if (!targets.row(i).allFinite())
            throw InputError("target " + std::to_string(i) + " has a coordinate that is not finite");
        if (targets(i, 2) != 0)
            throw InputError("target " + std::to_string(i) + " has z = " + std::to_string(targets(i, 2)) +
                             ", but the source is planar, with z = 0");
    }
}

/// Walks from element to element towards one point after the other.
class Walker {
public:
    /// @param face  where the first walk starts
    Walker(const Mesh& mesh, Index face)
        : mesh_(mesh), kernel_(mesh.kernel), face_(face),
          patience_(kShortestPatience +
                    static_cast<Index>(2 * std::sqrt(static_cast<double>(element_count(mesh)))))
    {
    }

    /// The element that holds @p p, or kUnknown.
    Index find(PlanePoint p)
    {
        HalfedgeHandle entry;
        for (Index steps = 0; steps < patience_; ++steps) {
            const View view = look(entry, p);
            if (!view.beyond.is_valid())
                return view.outside ? kUnknown : first_of_those_around(view, p);
            entry = kernel_.opposite_halfedge_handle(view.beyond);
            face_ = kernel_.face_handle(entry).idx();
        }
        return kUnknown;
    }

    /// Start the next walk here.
    void go_to(Index face) { face_ = face; }

private:
    /// A point as seen from an element.
    struct View {
        HalfedgeHandle beyond; ///< a side with another element behind it that the point is beyond, if any
        bool outside = false;  ///< else: it is beyond a side of the boundary
        std::vector<HalfedgeHandle> on; ///< else: the sides that it lies on
    };

    /// @param entry  the side the element was entered by, which the point is not beyond; invalid: none
    View look(HalfedgeHandle entry, PlanePoint p) const
    {
        View view;
        const HalfedgeHandle first = entry.is_valid() ? entry : kernel_.halfedge_handle(FaceHandle(face_));
        HalfedgeHandle side = entry.is_valid() ? kernel_.next_halfedge_handle(entry) : first;
        PlanePoint from = plane_point(mesh_, kernel_.from_vertex_handle(side));
        do {
            const PlanePoint to = plane_point(mesh_, kernel_.to_vertex_handle(side));
            const int sign = orientation(from, to, p);
            if (sign == 0)
                view.on.push_back(side);
            if (sign < 0 && kernel_.is_boundary(kernel_.opposite_halfedge_handle(side)))
                view.outside = true;
            else if (sign < 0) {
                view.beyond = side;
                return view;
            }
            from = to;
            side = kernel_.next_halfedge_handle(side);
        } while (side != first);
        return view;
    }

    Index file_number(FaceHandle face) const
    {
        return mesh_.numbering.element[static_cast<std::size_t>(face.idx())];
    }

    /// The first in the file of the elements that share the side or the corner that the point lies on.
    /// On the boundary parts may touch that only the tree knows of.
    Index first_of_those_around(const View& view, PlanePoint p) const
    {
        if (view.on.empty())
            return face_;
        if (view.on.size() == 1) {
            const HalfedgeHandle opposite = kernel_.opposite_halfedge_handle(view.on[0]);
            if (kernel_.is_boundary(opposite))
                return kUnknown;
            return first_of({FaceHandle(face_), kernel_.face_handle(opposite)});
        }
        for (const HalfedgeHandle side : view.on)
            if (const VertexHandle v = kernel_.to_vertex_handle(side); lies_on(v, p))
                return kernel_.is_boundary(v) ? kUnknown : first_of(kernel_.vf_range(v));
        return kUnknown; // an element without area
    }

    bool lies_on(VertexHandle v, PlanePoint p) const
    {
        const PlanePoint q = plane_point(mesh_, v);
        return q.x == p.x && q.y == p.y;
    }

    template <typename Faces>
    Index first_of(const Faces& faces) const
    {
        FaceHandle first(face_);
        for (const FaceHandle face : faces)
            if (file_number(face) < file_number(first))
                first = face;
        return first.idx();
    }
    Index first_of(std::initializer_list<FaceHandle> faces) const
    {
        return first_of<std::initializer_list<FaceHandle>>(faces);
    }

    const Mesh& mesh_;
    const Kernel& kernel_;
    Index face_; ///< where the walk stands
    Index patience_;
};

} // namespace

Locator::Locator(const Mesh& source) : source_(source)
{
    const auto positions = points(source);
    for (Index v = 0; v < vertex_count(source); ++v)
        box_.extend(positions.row(v).transpose());
    const Index stride = std::max<Index>(1, element_count(source) / kSamples);
    for (Index face = stride / 2; face < element_count(source); face += stride)
        samples_.push_back(face);
}

const ElementTree& Locator::tree() const
{
    std::call_once(tree_built_, [this] { tree_ = std::make_unique<ElementTree>(source_); });
    return *tree_;
}

ContainingElements Locator::locate(const Eigen::Ref<const Points>& targets) const
{
    require_in_plane(targets);
    ContainingElements found;
    found.face.assign(static_cast<std::size_t>(targets.rows()), -1);
    found.order = hilbert_order(targets, 2);
    if (samples_.empty())
        return found;
    parallel_for(found.order.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        const auto first = targets.row(found.order[begin]);
        Walker walker(source_, face_near(first.x(), first.y()));
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < end) // the targets themselves lie anywhere in memory
                __builtin_prefetch(targets.row(found.order[i + kAhead]).data());
            const PlanePoint p{targets(found.order[i], 0), targets(found.order[i], 1)};
            if (!box_.contains(Eigen::Vector3d(p.x, p.y, 0)))
                continue;
            Index face = walker.find(p);
            if (face == kUnknown) {
                face = tree().containing(p.x, p.y);
                if (face >= 0)
                    walker.go_to(face);
            }
            found.face[static_cast<std::size_t>(found.order[i])] = face;
        }
    });
    return found;
}

Index Locator::face_near(double x, double y) const
{
    const auto distance2 = [&](Index face) {
        const HalfedgeHandle side = source_.kernel.halfedge_handle(FaceHandle(face));
        const PlanePoint q = plane_point(source_, source_.kernel.to_vertex_handle(side));
        return (q.x - x) * (q.x - x) + (q.y - y) * (q.y - y);
    };
    return *std::min_element(samples_.begin(), samples_.end(),
                             [&](Index a, Index b) { return distance2(a) < distance2(b); });
}

} // namespace morph
