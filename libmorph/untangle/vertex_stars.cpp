#include "libmorph/untangle/vertex_stars.h"

namespace morph {

VertexStars::VertexStars(const Mesh& mesh)
    : vertex_of(representatives(mesh.numbering)), elements(element_table(mesh)), start(vertex_of.size() + 1)
{
    for (Element& element : elements)
        for (Index& v : element)
            if (v >= 0)
                ++start[static_cast<std::size_t>(v = vertex_of[static_cast<std::size_t>(v)]) + 1];
    for (std::size_t v = 1; v < start.size(); ++v)
        start[v] += start[v - 1];
    around.resize(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (std::size_t f = 0; f < elements.size(); ++f)
        for (const Index v : elements[f])
            if (v >= 0)
                around[next[static_cast<std::size_t>(v)]++] = static_cast<Index>(f);
}

} // namespace morph
