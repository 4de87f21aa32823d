#include "libmorph/remesh/retriangulate.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/nearest_points.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/cut_region.h"
#include "libmorph/remesh/keep_numbering.h"

#include <string>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The corners that an element has, by the file's numbers, at the places where elements are compared.
template <typename Corners>
Eigen::RowVector3d centre(const Points& places, const Corners& corners)
{
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    int count = 0;
    for (const Index v : corners)
        if (v >= 0) {
            sum += places.row(v);
            ++count;
        }
    return sum / count;
}

/// Puts the new mesh together, all in the numbers of the file.
class Assembly {
public:
    Assembly(const Mesh& mesh, const CutRegion& region, const RetriangulateSettings& settings)
        : mesh_(mesh), old_(to_mesh_data(mesh)), triangles_(region.triangles), settings_(settings),
          cut_(old_.elements.size(), false)
    {
        for (Index f = 0; f < element_count(mesh); ++f)
            cut_[at(mesh.numbering.element[at(f)])] = region.cut[at(f)];
    }

    Retriangulated run()
    {
        result_.data.dimension = old_.dimension;
        result_.data.sections = old_.sections;
        number_elements();
        number_vertices();
        for (Element& element : result_.data.elements)
            for (Index& v : element)
                v = v < 0 ? v : new_vertex_[at(v)];
        for (Marker marker : old_.markers) {
            for (auto& [a, b] : marker.edges) {
                a = new_vertex_[at(a)];
                b = new_vertex_[at(b)];
            }
            result_.data.markers.push_back(std::move(marker));
        }
        if (settings_.transfer)
            transfer();
        return std::move(result_);
    }

private:
    void number_elements()
    {
        std::vector<Index> wishes;
        for (std::size_t e = 0; e < old_.elements.size(); ++e)
            if (!cut_[e])
                wishes.push_back(static_cast<Index>(e));
        result_.cut_out = static_cast<Index>(old_.elements.size() - wishes.size());
        const std::size_t kept = wishes.size();
        wishes.resize(kept + triangles_.size(), -1);
        const std::vector<Index> number = kept_numbers(wishes);
        result_.data.elements.resize(wishes.size());
        result_.made.resize(wishes.size());
        source_.resize(wishes.size());
        for (std::size_t i = 0; i < wishes.size(); ++i) {
            const std::size_t e = at(number[i]);
            result_.made[e] = i >= kept;
            source_[e] = wishes[i];
            if (i < kept)
                result_.data.elements[e] = old_.elements[at(wishes[i])];
            else {
                const auto& [a, b, c] = triangles_[i - kept];
                result_.data.elements[e] = {a, b, c, -1};
            }
        }
    }

    /// Vertices of elements that are gone are left out, unless another element uses them.
    void number_vertices()
    {
        std::vector<bool> stays(at(mesh_.numbering.file_vertices), true);
        for (std::size_t e = 0; e < old_.elements.size(); ++e)
            for (const Index v : old_.elements[e])
                if (v >= 0 && cut_[e])
                    stays[at(v)] = false;
        for (const Element& element : result_.data.elements)
            for (const Index v : element)
                if (v >= 0)
                    stays[at(v)] = true;
        std::vector<Index> wishes;
        for (std::size_t v = 0; v < stays.size(); ++v)
            if (stays[v])
                wishes.push_back(static_cast<Index>(v));
        const std::vector<Index> number = kept_numbers(wishes);
        new_vertex_.assign(stays.size(), -1);
        result_.vertex.resize(wishes.size());
        result_.data.points.resize(static_cast<Eigen::Index>(wishes.size()), 3);
        for (std::size_t i = 0; i < wishes.size(); ++i) {
            new_vertex_[at(wishes[i])] = number[i];
            result_.vertex[at(number[i])] = wishes[i];
            result_.data.points.row(number[i]) = old_.points.row(wishes[i]);
        }
    }

    void transfer()
    {
        find_sources();
        for (const ElementGroup& group : old_.groups) {
            std::vector<bool> in_group(old_.elements.size(), false);
            for (const Index e : group.elements)
                in_group[at(e)] = true;
            ElementGroup now{group.name, {}};
            for (std::size_t e = 0; e < source_.size(); ++e)
                if (in_group[at(source_[e])])
                    now.elements.push_back(static_cast<Index>(e));
            result_.data.groups.push_back(std::move(now));
        }
        for (const Field& field : old_.fields)
            result_.data.fields.push_back(
                {field.name, field.location,
                 field.values(field.location == FieldLocation::vertex ? result_.vertex : source_,
                              Eigen::all)});
    }

    Points compared_places() const
    {
        if (settings_.shape == nullptr)
            return old_.points;
        Points places = old_.points;
        for (Index v = 0; v < vertex_count(mesh_); ++v)
            places.row(mesh_.numbering.vertex[at(v)]) = settings_.shape->row(v);
        return places;
    }

    /// The old element nearest to each new one.
    void find_sources()
    {
        if (triangles_.empty())
            return;
        const Points places = compared_places();
        std::vector<Index> gone, made;
        for (std::size_t e = 0; e < cut_.size(); ++e)
            if (cut_[e])
                gone.push_back(static_cast<Index>(e));
        for (std::size_t e = 0; e < source_.size(); ++e)
            if (result_.made[e])
                made.push_back(static_cast<Index>(e));
        Points before(static_cast<Eigen::Index>(gone.size()), 3),
            after(static_cast<Eigen::Index>(made.size()), 3);
        for (std::size_t i = 0; i < gone.size(); ++i)
            before.row(static_cast<Eigen::Index>(i)) = centre(places, old_.elements[at(gone[i])]);
        for (std::size_t i = 0; i < made.size(); ++i) {
            Element corners = result_.data.elements[at(made[i])];
            for (Index& v : corners)
                v = v < 0 ? v : result_.vertex[at(v)];
            after.row(static_cast<Eigen::Index>(i)) = centre(places, corners);
        }
        NearestPoints(before).nearest(after, 1,
                                      [&](Index query, std::span<const NearestPoints::Neighbor> found) {
                                          source_[at(made[at(query)])] = gone[at(found.front().point)];
                                      });
    }

    const Mesh& mesh_;
    const MeshData old_;
    const std::vector<std::array<Index, 3>>& triangles_;
    const RetriangulateSettings& settings_;
    std::vector<bool> cut_;         ///< elements by their number in the file
    std::vector<Index> source_;     ///< of each element of the result, the old one; -1: not known yet
    std::vector<Index> new_vertex_; ///< by the old number; -1: left out
    Retriangulated result_;
};

} // namespace

Retriangulated retriangulate(const Mesh& mesh, const std::vector<bool>& kept,
                             const RetriangulateSettings& settings)
{
    if (mesh.dimension != 2)
        throw InputError("only planar meshes can be triangulated again, this one is a surface in space");
    if (kept.size() != at(element_count(mesh)))
        throw InputError("there are " + std::to_string(kept.size()) +
                         " marks of elements to keep, but the mesh has " +
                         std::to_string(element_count(mesh)) + " elements");
    const CutRegion region = cut_region(mesh, kept, settings.inner_vertices);
    return Assembly(mesh, region, settings).run();
}

} // namespace morph
