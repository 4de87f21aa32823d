#include "libmorph/mesh/duplicates.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <tuple>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 32768;

/// The vertices of an element in increasing order, and which element it is.
struct VertexSet {
    Element vertices;
    std::size_t element;

    bool operator<(const VertexSet& other) const
    {
        return std::tie(vertices, element) < std::tie(other.vertices, other.element);
    }
};

VertexSet vertex_set(const Element& element, std::size_t number)
{
    VertexSet set{element, number};
    std::sort(set.vertices.begin(), set.vertices.begin() + corner_count(element));
    return set;
}

[[noreturn]] void throw_duplicate(const VertexSet& a, const VertexSet& b, const Numbering& numbering)
{
    std::vector<Index> ids(a.vertices.begin(), a.vertices.begin() + corner_count(a.vertices));
    for (Index& id : ids)
        id = numbering.vertex[static_cast<std::size_t>(id)];
    std::sort(ids.begin(), ids.end());
    std::string vertices;
    for (const Index id : ids)
        vertices += (vertices.empty() ? "" : ", ") + std::to_string(id);
    const auto [first, second] = std::minmax(numbering.element[a.element], numbering.element[b.element]);
    throw InputError("elements " + std::to_string(first) + " and " + std::to_string(second) +
                     " have the same vertices " + vertices);
}

/// Check elements that have the smallest vertex in common.
void check_group(std::vector<VertexSet>& group, const Numbering& numbering)
{
    if (group.size() < 2)
        return;
    std::sort(group.begin(), group.end());
    for (std::size_t i = 1; i < group.size(); ++i)
        if (group[i].vertices == group[i - 1].vertices)
            throw_duplicate(group[i - 1], group[i], numbering);
}

Index smallest(const Element& element)
{
    return *std::min_element(element.begin(), element.begin() + corner_count(element));
}

} // namespace

void require_distinct_elements(const std::vector<Element>& elements, const Numbering& numbering)
{
    const std::size_t m = elements.size();
    const auto starts_group = [&](std::size_t f) {
        return f == 0 || f == m || smallest(elements[f]) != smallest(elements[f - 1]);
    };
    parallel_for(m, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::vector<VertexSet> group;
        while (begin < end && !starts_group(begin)) // the block before goes on with that group
            ++begin;
        for (std::size_t f = begin; f < m && (f < end || !group.empty());) {
            group.push_back(vertex_set(elements[f], f));
            if (starts_group(++f)) {
                check_group(group, numbering);
                group.clear();
            }
        }
    });
}

} // namespace morph
