#include "libmorph/geometry/region_triangles.h"

#include "libmorph/core/space_curve.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <limits>

namespace morph {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using ConstrainedFace = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel, ConstrainedFace>; // winding number
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Point = Triangulation::Point;

constexpr int kUnknown = std::numeric_limits<int>::min();

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// An edge of the outline from its lower to its higher vertex, or against that.
struct Side {
    std::array<Index, 2> ends;
    int along;

    bool operator<(const Side& other) const { return ends < other.ends; }
};

class RegionMesher {
public:
    RegionMesher(const Eigen::Ref<const Points>& points, const PolygonRegion& region)
        : points_(points), region_(region), handles_(at(static_cast<Index>(points.rows())))
    {
        for (const auto* edges : {&region.outline, &region.inner})
            for (const auto& [a, b] : *edges)
                triangulation_.insert_constraint(inserted(a), inserted(b));
        for (const auto& [a, b] : region.outline)
            sides_.push_back({{std::min(a, b), std::max(a, b)}, a < b ? 1 : -1});
        std::sort(sides_.begin(), sides_.end());
    }

    std::optional<std::vector<std::array<Index, 3>>> run()
    {
        flood();
        if (!bounds_a_region())
            return std::nullopt;
        insert_inside();
        flood();
        std::vector<std::array<Index, 3>> triangles;
        for (const FaceHandle f : triangulation_.finite_face_handles())
            if (f->info() == 1)
                triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
        return triangles;
    }

private:
    Point point(Index v) const { return {points_(v, 0), points_(v, 1)}; }

    VertexHandle insert(Index v)
    {
        last_ = triangulation_.insert(point(v), last_ == VertexHandle() ? FaceHandle() : last_->face());
        return last_;
    }

    VertexHandle inserted(Index v)
    {
        VertexHandle& handle = handles_[at(v)];
        if (handle == VertexHandle()) {
            handle = insert(v);
            handle->info() = v;
        }
        return handle;
    }

    /// How often the outline runs from a to b, less how often back.
    int runs(Index a, Index b) const
    {
        const Side wanted{{std::min(a, b), std::max(a, b)}, 0};
        int sum = 0;
        for (auto side = std::lower_bound(sides_.begin(), sides_.end(), wanted);
             side != sides_.end() && side->ends == wanted.ends; ++side)
            sum += side->along;
        return a < b ? sum : -sum;
    }

    /// Winding numbers, from the outside inwards.
    void flood()
    {
        for (const FaceHandle f : triangulation_.all_face_handles())
            f->info() = kUnknown;
        std::vector<FaceHandle> pending{triangulation_.infinite_face()};
        pending.front()->info() = 0;
        while (!pending.empty()) {
            const FaceHandle f = pending.back();
            pending.pop_back();
            for (int i = 0; i < 3; ++i) {
                const FaceHandle beyond = f->neighbor(i);
                if (beyond->info() != kUnknown)
                    continue;
                beyond->info() = f->info();
                if (f->is_constrained(i))
                    beyond->info() -= runs(f->vertex(Triangulation::ccw(i))->info(),
                                           f->vertex(Triangulation::cw(i))->info());
                pending.push_back(beyond);
            }
        }
    }

    bool bounds_a_region() const
    {
        for (const FaceHandle f : triangulation_.all_face_handles())
            if (f->info() != 0 && f->info() != 1)
                return false;
        return std::all_of(region_.inner.begin(), region_.inner.end(), [&](const auto& edge) {
            FaceHandle f;
            int side = 0;
            return triangulation_.is_edge(handles_[at(edge[0])], handles_[at(edge[1])], f, side) &&
                   f->info() == 1 && f->neighbor(side)->info() == 1;
        });
    }

    /// The further points that lie strictly inside, along a space-filling curve.
    std::vector<Index> inside() const
    {
        Points places(static_cast<Eigen::Index>(region_.vertices.size()), 3);
        for (std::size_t i = 0; i < region_.vertices.size(); ++i)
            places.row(static_cast<Eigen::Index>(i)) = points_.row(region_.vertices[i]);
        std::vector<Index> found;
        FaceHandle f;
        for (const Index i : hilbert_order(places, 2)) {
            const Index v = region_.vertices[at(i)];
            Triangulation::Locate_type type{};
            int side = 0;
            f = triangulation_.locate(point(v), type, side, f);
            if (f->info() == 1 &&
                (type == Triangulation::FACE || (type == Triangulation::EDGE && !f->is_constrained(side))))
                found.push_back(v);
        }
        return found;
    }

    void insert_inside()
    {
        for (const Index v : inside()) {
            const std::size_t before = triangulation_.number_of_vertices();
            const VertexHandle made = insert(v);
            if (triangulation_.number_of_vertices() > before) // else another point is there already
                made->info() = v;
        }
    }

    const Eigen::Ref<const Points>& points_;
    const PolygonRegion& region_;
    Triangulation triangulation_;
    std::vector<VertexHandle> handles_; ///< of the ends of edges
    std::vector<Side> sides_;
    VertexHandle last_; ///< inserted; vertices stay valid, faces do not
};

} // namespace

std::optional<std::vector<std::array<Index, 3>>> region_triangles(const Eigen::Ref<const Points>& points,
                                                                  const PolygonRegion& region)
{
    if (region.outline.empty())
        return std::vector<std::array<Index, 3>>();
    return RegionMesher(points, region).run();
}

} // namespace morph
