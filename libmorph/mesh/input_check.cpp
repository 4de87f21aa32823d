#include "libmorph/mesh/input_check.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 65536;

std::string text(double x)
{
    std::ostringstream out;
    out << x;
    return out.str();
}

void check_point(const MeshData& data, Index v)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(data.points(v, axis)))
            throw InputError("vertex " + std::to_string(v) + " has the coordinate " +
                             text(data.points(v, axis)) + ", but coordinates must be finite");
    if (data.dimension == 2 && data.points(v, 2) != 0)
        throw InputError("vertex " + std::to_string(v) + " has z = " + text(data.points(v, 2)) +
                         ", but in a planar mesh z is 0");
}

void require_vertex(const std::string& owner, Index v, const MeshData& data)
{
    if (v < 0 || v >= data.points.rows())
        throw InputError(owner + " names vertex " + std::to_string(v) + ", but the mesh has " +
                         std::to_string(data.points.rows()) + " vertices");
}

[[noreturn]] void throw_repeated(const std::string& owner, Index v)
{
    throw InputError(owner + " names vertex " + std::to_string(v) + " twice");
}

bool in_range_and_distinct(const Element& e, Index vertices)
{
    const auto inside = [vertices](Index v) { return v >= 0 && v < vertices; };
    const bool triangle =
        inside(e[0]) && inside(e[1]) && inside(e[2]) && e[0] != e[1] && e[1] != e[2] && e[2] != e[0];
    return triangle && (e[3] == -1 || (inside(e[3]) && e[3] != e[0] && e[3] != e[1] && e[3] != e[2]));
}

/// Says what is wrong with an element that is not in_range_and_distinct().
void explain_element(const MeshData& data, Index id)
{
    const Element& e = data.elements[static_cast<std::size_t>(id)];
    const std::string owner = "element " + std::to_string(id);
    for (std::size_t k = 0; k < (e[3] == -1 ? 3 : 4); ++k) {
        require_vertex(owner, e[k], data);
        for (std::size_t j = 0; j < k; ++j)
            if (e[j] == e[k])
                throw_repeated(owner, e[k]);
    }
}

void check_elements(const MeshData& data)
{
    const auto vertices = static_cast<Index>(data.points.rows());
    parallel_for(data.elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            if (!in_range_and_distinct(data.elements[f], vertices))
                explain_element(data, static_cast<Index>(f));
    });
}

void check_points(const MeshData& data)
{
    parallel_for(static_cast<std::size_t>(data.points.rows()), kRowsPerBlock,
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t v = begin; v < end; ++v)
                         check_point(data, static_cast<Index>(v));
                 });
}

void check_marker(const Marker& marker, const MeshData& data)
{
    const std::string owner = "marker '" + marker.name + "'";
    for (const auto& edge : marker.edges) {
        require_vertex(owner, edge[0], data);
        require_vertex(owner, edge[1], data);
        if (edge[0] == edge[1])
            throw InputError(owner + " has an edge that names vertex " + std::to_string(edge[0]) + " twice");
    }
}

void check_group(const ElementGroup& group, const MeshData& data)
{
    std::vector<bool> seen(data.elements.size());
    for (const Index element : group.elements) {
        const std::string owner = "group '" + group.name + "' names element " + std::to_string(element);
        if (element < 0 || static_cast<std::size_t>(element) >= data.elements.size())
            throw InputError(owner + ", but the mesh has " + std::to_string(data.elements.size()));
        if (seen[static_cast<std::size_t>(element)])
            throw InputError(owner + " twice");
        seen[static_cast<std::size_t>(element)] = true;
    }
}

void check_field(const Field& field, const MeshData& data)
{
    constexpr Eigen::Index kMostComponents = 9;
    const bool nodal = field.location == FieldLocation::vertex;
    const auto rows = nodal ? data.points.rows() : static_cast<Eigen::Index>(data.elements.size());
    if (field.values.rows() != rows)
        throw InputError("field '" + field.name + "' has " + std::to_string(field.values.rows()) +
                         " rows, but the mesh has " + std::to_string(rows) +
                         (nodal ? " vertices" : " elements"));
    if (field.values.cols() < 1 || field.values.cols() > kMostComponents)
        throw InputError("field '" + field.name + "' has " + std::to_string(field.values.cols()) +
                         " components, but 1 to 9 can be held");
}

} // namespace

void require_countable(std::size_t vertices, std::size_t elements)
{
    constexpr std::size_t kMostIndices = std::numeric_limits<Index>::max();
    constexpr std::size_t kMostElements = kMostIndices / 8;
    if (vertices > kMostIndices)
        throw InputError("the mesh has " + std::to_string(vertices) + " vertices, but at most " +
                         std::to_string(kMostIndices) + " can be numbered");
    if (elements > kMostElements)
        throw InputError("the mesh has " + std::to_string(elements) + " elements, but at most " +
                         std::to_string(kMostElements) + " can be numbered");
}

void check_input(const MeshData& data)
{
    if (data.dimension != 2 && data.dimension != 3)
        throw InputError("the mesh has dimension " + std::to_string(data.dimension) +
                         ", but it must be 2 or 3");
    require_countable(static_cast<std::size_t>(data.points.rows()), data.elements.size());
    check_points(data);
    check_elements(data);
    for (const Marker& marker : data.markers)
        check_marker(marker, data);
    for (const ElementGroup& group : data.groups)
        check_group(group, data);
    for (const Field& field : data.fields)
        check_field(field, data);
}

} // namespace morph
