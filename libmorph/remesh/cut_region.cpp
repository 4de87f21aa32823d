#include "libmorph/remesh/cut_region.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/geometry/edge_crossing.h"
#include "libmorph/geometry/region_triangles.h"
#include "libmorph/quality/quality.h"

#include <algorithm>
#include <string>
#include <utility>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The elements to cut out, in the numbering of the mesh, and their outline, in that of the file: there
/// copies of a split vertex are one.
class RegionFinder {
public:
    RegionFinder(const Mesh& mesh, const std::vector<bool>& kept, bool inner_vertices)
        : mesh_(mesh), elements_(element_table(mesh)), inner_vertices_(inner_vertices), cut_(kept)
    {
        cut_.flip();
        for (const Index f : inverted_elements(mesh, points(mesh)))
            cut_[at(f)] = true;
        places_ = Points::Zero(mesh.numbering.file_vertices, 3);
        for (Index v = 0; v < vertex_count(mesh); ++v)
            places_.row(file(v)) = points(mesh).row(v);
        for (const Marker& marker : mesh.markers)
            marked_.insert(marked_.end(), marker.edges.begin(), marker.edges.end());
    }

    /// Grows until its outline bounds a region.
    CutRegion run()
    {
        while (true) {
            collect();
            if (const auto crossing = find_edge_crossing(places_, edges()))
                grow_at(*crossing);
            else if (auto triangles = region_triangles(places_, region_))
                return {std::move(cut_), std::move(*triangles)};
            else
                grow_everywhere();
        }
    }

private:
    Index file(Index v) const { return mesh_.numbering.vertex[at(v)]; }
    bool in_region(HalfedgeHandle h) const
    {
        const FaceHandle f = mesh_.kernel.face_handle(h);
        return f.is_valid() && cut_[at(f.idx())];
    }

    void collect()
    {
        region_ = {};
        borders_.clear();
        std::vector<std::array<Index, 2>> boundary;
        for (const HalfedgeHandle h : mesh_.kernel.halfedges()) {
            const HalfedgeHandle opposite = mesh_.kernel.opposite_halfedge_handle(h);
            if (!in_region(h) || in_region(opposite))
                continue;
            const std::array<Index, 2> edge{file(mesh_.kernel.from_vertex_handle(h).idx()),
                                            file(mesh_.kernel.to_vertex_handle(h).idx())};
            (mesh_.kernel.is_boundary(opposite) ? boundary : borders_).push_back(edge);
        }
        region_.outline = borders_;
        region_.outline.insert(region_.outline.end(), boundary.begin(), boundary.end());
        for (const auto& [a, b] : marked_) {
            const HalfedgeHandle h = mesh_.kernel.find_halfedge(VertexHandle(a), VertexHandle(b));
            if (in_region(h) && in_region(mesh_.kernel.opposite_halfedge_handle(h)))
                region_.inner.push_back({file(a), file(b)});
        }
        if (inner_vertices_)
            collect_vertices();
    }

    void collect_vertices()
    {
        std::vector<bool> found(at(mesh_.numbering.file_vertices), false);
        for (std::size_t f = 0; f < elements_.size(); ++f)
            for (const Index v : elements_[f])
                if (v >= 0 && cut_[f])
                    found[at(file(v))] = true;
        for (const auto& [a, b] : edges())
            found[at(a)] = found[at(b)] = false;
        for (std::size_t v = 0; v < found.size(); ++v)
            if (found[v])
                region_.vertices.push_back(static_cast<Index>(v));
    }

    /// Of the outline, those to kept elements first, and inside.
    std::vector<std::array<Index, 2>> edges() const
    {
        std::vector<std::array<Index, 2>> all = region_.outline;
        all.insert(all.end(), region_.inner.begin(), region_.inner.end());
        return all;
    }

    void grow_at(const EdgeCrossing& crossing)
    {
        const auto all = edges();
        std::vector<std::array<Index, 2>> from;
        for (const Index edge : crossing.edges)
            if (at(edge) < borders_.size())
                from.push_back(all[at(edge)]);
        if (from.empty())
            throw InputError("the boundary of the mesh crosses itself near (" +
                             number_text(crossing.point.x()) + ", " + number_text(crossing.point.y()) +
                             "), so that no valid mesh of it exists");
        grow(from);
    }

    void grow_everywhere()
    {
        if (borders_.empty())
            throw InputError("a part of the boundary of the mesh is inside out, so that no valid mesh of it "
                             "exists");
        grow(borders_);
    }

    /// Cut out all elements with a vertex of these edges.
    void grow(const std::vector<std::array<Index, 2>>& from)
    {
        std::vector<bool> touched(at(mesh_.numbering.file_vertices), false);
        for (const auto& [a, b] : from)
            touched[at(a)] = touched[at(b)] = true;
        for (std::size_t f = 0; f < elements_.size(); ++f)
            for (const Index v : elements_[f])
                if (v >= 0 && touched[at(file(v))])
                    cut_[f] = true;
    }

    const Mesh& mesh_;
    std::vector<Element> elements_;
    bool inner_vertices_;
    std::vector<bool> cut_;
    Points places_;                             ///< by the file's numbers
    std::vector<std::array<Index, 2>> marked_;  ///< edges of markers
    std::vector<std::array<Index, 2>> borders_; ///< edges between cut out and kept elements
    PolygonRegion region_;
};

} // namespace

CutRegion cut_region(const Mesh& mesh, const std::vector<bool>& kept, bool inner_vertices)
{
    return RegionFinder(mesh, kept, inner_vertices).run();
}

} // namespace morph
