#include "tests/support/exact_overlap.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/intersections.h>

#include <cmath>
#include <utility>

namespace morph::test {

namespace {

using K = CGAL::Exact_predicates_exact_constructions_kernel;

struct ExactElement {
    std::vector<K::Triangle_2> triangles;
    CGAL::Bbox_2 box;
};

std::vector<ExactElement> exact_elements(const MeshData& mesh)
{
    std::vector<ExactElement> elements;
    for (const Element& e : mesh.elements) {
        const auto at = [&](std::size_t k) { return K::Point_2(mesh.points(e[k], 0), mesh.points(e[k], 1)); };
        ExactElement& element = elements.emplace_back();
        element.triangles.emplace_back(at(0), at(1), at(2));
        if (corner_count(e) == 4)
            element.triangles.emplace_back(at(0), at(2), at(3));
        for (const auto& triangle : element.triangles)
            element.box += triangle.bbox();
    }
    return elements;
}

/// The corners of what two triangles have in common; none when it has no area.
std::vector<K::Point_2> common_polygon(const K::Triangle_2& a, const K::Triangle_2& b)
{
    const auto common = CGAL::intersection(a, b);
    if (!common)
        return {};
    if (const auto* triangle = boost::get<K::Triangle_2>(&*common))
        return {triangle->vertex(0), triangle->vertex(1), triangle->vertex(2)};
    if (const auto* corners = boost::get<std::vector<K::Point_2>>(&*common))
        return *corners;
    return {}; // a point or a segment
}

double rounded(const K::FT& x)
{
    return CGAL::to_double(CGAL::exact(x));
}

void add_part(const std::vector<K::Point_2>& corners, ExactOverlap& overlap)
{
    if (corners.empty())
        return;
    Points2& part = overlap.parts.emplace_back(static_cast<Eigen::Index>(corners.size()), 2);
    for (std::size_t k = 0; k < corners.size(); ++k)
        part.row(static_cast<Eigen::Index>(k)) << rounded(corners[k].x()), rounded(corners[k].y());
    overlap.area += std::abs(rounded(CGAL::Polygon_2<K>(corners.begin(), corners.end()).area()));
}

} // namespace

std::vector<ExactOverlap> exact_overlaps(const MeshData& source, const MeshData& target)
{
    const std::vector<ExactElement> sources = exact_elements(source), targets = exact_elements(target);
    std::vector<ExactOverlap> overlaps;
    for (std::size_t t = 0; t < targets.size(); ++t)
        for (std::size_t s = 0; s < sources.size(); ++s) {
            if (!CGAL::do_overlap(targets[t].box, sources[s].box))
                continue;
            ExactOverlap overlap{static_cast<Index>(t), static_cast<Index>(s), 0, {}};
            for (const auto& a : targets[t].triangles)
                for (const auto& b : sources[s].triangles)
                    add_part(common_polygon(a, b), overlap);
            if (overlap.area > 0)
                overlaps.push_back(std::move(overlap));
        }
    return overlaps;
}

} // namespace morph::test
