#include "libmorph/remesh/bad_region.h"

#include "libmorph/remesh/remesh_state.h"

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

void add_ring(const std::vector<Element>& elements, Index vertices, std::vector<bool>& kept)
{
    std::vector<bool> touched(at(vertices), false);
    for (std::size_t f = 0; f < elements.size(); ++f)
        for (const Index v : elements[f])
            if (v >= 0 && !kept[f])
                touched[at(v)] = true;
    for (std::size_t f = 0; f < elements.size(); ++f)
        for (const Index v : elements[f])
            if (v >= 0 && touched[at(v)])
                kept[f] = false;
}

} // namespace

std::vector<double> triangle_qualities(const Mesh& mesh)
{
    const auto place = points(mesh);
    std::vector<double> quality(at(element_count(mesh)), 1);
    for (Index f = 0; f < element_count(mesh); ++f)
        if (const Element e = element_corners(mesh, f); e[3] < 0)
            quality[at(f)] =
                triangle_quality(place.row(e[0]), place.row(e[1]), place.row(e[2]), mesh.dimension == 2);
    return quality;
}

std::vector<bool> all_but(const Mesh& mesh, const std::vector<Index>& elements, int rings)
{
    std::vector<bool> kept(at(element_count(mesh)), true);
    for (const Index f : elements)
        kept[at(f)] = false;
    const std::vector<Element> corners = element_table(mesh);
    for (int ring = 0; ring < rings; ++ring)
        add_ring(corners, vertex_count(mesh), kept);
    for (std::size_t f = 0; f < kept.size(); ++f)
        kept[f] = kept[f] || corners[f][3] >= 0;
    for (const Index f : elements)
        kept[at(f)] = false;
    return kept;
}

std::vector<bool> all_but_bad(const Mesh& mesh, double quality, int rings)
{
    std::vector<Index> bad;
    const std::vector<double> qualities = triangle_qualities(mesh);
    for (std::size_t f = 0; f < qualities.size(); ++f)
        if (qualities[f] < quality)
            bad.push_back(static_cast<Index>(f));
    return all_but(mesh, bad, rings);
}

} // namespace morph
