#include "libmorph/remap/overlaps.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <unordered_set>

namespace morph {

namespace {

constexpr std::size_t kGrain = 256; // target elements

/// A set of faces that is small most of the time.
class FaceSet {
public:
    void clear()
    {
        few_.clear();
        many_.clear();
    }

    /// False when it was there already.
    bool insert(Index face)
    {
        constexpr std::size_t kFew = 48;
        if (few_.size() < kFew) {
            if (std::find(few_.begin(), few_.end(), face) != few_.end())
                return false;
            few_.push_back(face);
            if (few_.size() == kFew)
                many_.insert(few_.begin(), few_.end());
            return true;
        }
        return many_.insert(face).second;
    }

private:
    std::vector<Index> few_;
    std::unordered_set<Index> many_;
};

PlanePoint plane_point(const Mesh& mesh, VertexHandle v)
{
    const auto& p = mesh.kernel.point(v);
    return {p[0], p[1]};
}

/// Whether segment a b touches a convex polygon of the element's corners: no line along a side of either has
/// them strictly apart.
bool touches(const PlaneElement& element, const ElementPart& part, PlanePoint a, PlanePoint b)
{
    const auto at = [&](int k) {
        return element
            .corner[static_cast<std::size_t>(part.corner[static_cast<std::size_t>(k % part.corners)])];
    };
    int left = 0, right = 0;
    for (int k = 0; k < part.corners; ++k) {
        const int sign = orientation(a, b, at(k));
        left += sign > 0 ? 1 : 0;
        right += sign < 0 ? 1 : 0;
    }
    if (left == part.corners || right == part.corners)
        return false;
    for (int k = 0; k < part.corners; ++k)
        if (orientation(at(k), at(k + 1), a) < 0 && orientation(at(k), at(k + 1), b) < 0)
            return false;
    return true;
}

/// Finds the source elements around one target element after the other.
class Finder {
public:
    Finder(const Locator& source, const Mesh& target, const std::vector<Index>& located, Parts parts)
        : source_(source), mesh_(source.source()), target_(target), located_(located), parts_(parts)
    {
    }

    void visit(Index face, const std::function<void(const TargetOverlaps&)>& visit)
    {
        element_ = plane_element(target_, face);
        const PlanePoint origin = element_.corner[0];
        const ElementParts target_parts = parts_of(element_, origin, parts_);
        overlaps_.clear();
        if (target_parts.count > 0) {
            find_candidates(face, target_parts);
            for (const Index candidate : candidates_)
                add_overlaps(candidate, origin, target_parts);
        }
        visit({face, origin, &target_parts, overlaps_});
    }

private:
    void find_candidates(Index face, const ElementParts& target_parts)
    {
        candidates_.clear();
        Index start = -1;
        for (const VertexHandle v : target_.kernel.fv_range(FaceHandle(face)))
            start = std::max(start, located_[static_cast<std::size_t>(v.idx())]);
        if (start < 0 || !flood(start, target_parts))
            ask_tree();
        std::sort(candidates_.begin(), candidates_.end());
    }

    /// Collect all that touches; false when a side of the boundary does.
    bool flood(Index start, const ElementParts& target_parts)
    {
        const Kernel& kernel = mesh_.kernel;
        seen_.clear();
        seen_.insert(start);
        candidates_.push_back(start);
        for (std::size_t next = 0; next < candidates_.size(); ++next)
            for (const HalfedgeHandle side : kernel.fh_range(FaceHandle(candidates_[next]))) {
                const HalfedgeHandle beyond = kernel.opposite_halfedge_handle(side);
                const bool boundary = kernel.is_boundary(beyond);
                const Index neighbor = boundary ? -1 : kernel.face_handle(beyond).idx();
                if (!side_touches(side, target_parts))
                    continue;
                if (boundary)
                    return false;
                if (seen_.insert(neighbor))
                    candidates_.push_back(neighbor);
            }
        return true;
    }

    bool side_touches(HalfedgeHandle side, const ElementParts& target_parts) const
    {
        const PlanePoint a = plane_point(mesh_, mesh_.kernel.from_vertex_handle(side));
        const PlanePoint b = plane_point(mesh_, mesh_.kernel.to_vertex_handle(side));
        for (int i = 0; i < target_parts.count; ++i)
            if (touches(element_, target_parts.part[static_cast<std::size_t>(i)], a, b))
                return true;
        return false;
    }

    void ask_tree()
    {
        Eigen::AlignedBox3d box;
        for (int k = 0; k < element_.corners; ++k) {
            const PlanePoint p = element_.corner[static_cast<std::size_t>(k)];
            box.extend(Eigen::Vector3d(p.x, p.y, 0));
        }
        source_.tree().overlapping(box, candidates_);
    }

    void add_overlaps(Index face, PlanePoint origin, const ElementParts& target_parts)
    {
        const ElementParts source_parts = parts_of(plane_element(mesh_, face), origin, parts_);
        for (int t = 0; t < target_parts.count; ++t)
            for (int s = 0; s < source_parts.count; ++s) {
                const ElementPart& target_part = target_parts.part[static_cast<std::size_t>(t)];
                const ElementPart& source_part = source_parts.part[static_cast<std::size_t>(s)];
                const ConvexPolygon piece = intersection(target_part.polygon, source_part.polygon);
                if (area(piece) > 0)
                    overlaps_.push_back({face, &target_part, source_part, piece});
            }
    }

    const Locator& source_;
    const Mesh& mesh_;
    const Mesh& target_;
    const std::vector<Index>& located_; ///< source face of each target vertex
    Parts parts_;
    PlaneElement element_;
    std::vector<Index> candidates_;
    FaceSet seen_;
    std::vector<Overlap> overlaps_;
};

} // namespace

void for_each_overlap(const Locator& source, const Mesh& target, Parts parts,
                      const std::function<void(const TargetOverlaps&)>& visit)
{
    if (source.source().dimension == 3 || target.dimension == 3)
        throw InputError("integrals are kept between planar meshes only, but the " +
                         std::string(target.dimension == 3 ? "target" : "source") + " lies in space");
    const std::vector<Index> located = source.locate(points(target)).face;
    parallel_for(static_cast<std::size_t>(element_count(target)), kGrain,
                 [&](std::size_t begin, std::size_t end) {
                     Finder finder(source, target, located, parts);
                     for (std::size_t face = begin; face < end; ++face)
                         finder.visit(static_cast<Index>(face), visit);
                 });
}

} // namespace morph
