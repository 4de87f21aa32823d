#include "libmorph/mesh/triangulate.h"

#include <Eigen/Geometry>

namespace morph {

namespace {

using Triangles = std::array<Element, 2>;

Eigen::RowVector3d normal(const Points& points, const Element& t)
{
    const Eigen::RowVector3d a = points.row(t[1]) - points.row(t[0]);
    const Eigen::RowVector3d b = points.row(t[2]) - points.row(t[0]);
    return a.cross(b);
}

bool same_side(const Points& points, const Triangles& pair)
{
    return normal(points, pair[0]).dot(normal(points, pair[1])) > 0;
}

Triangles split(const Points& points, const Element& q)
{
    const Triangles first{{{q[0], q[1], q[2], -1}, {q[0], q[2], q[3], -1}}};
    const Triangles second{{{q[0], q[1], q[3], -1}, {q[1], q[2], q[3], -1}}};
    const bool first_allowed = same_side(points, first);
    if (first_allowed != same_side(points, second))
        return first_allowed ? first : second;
    const double first_length = (points.row(q[2]) - points.row(q[0])).squaredNorm();
    const double second_length = (points.row(q[3]) - points.row(q[1])).squaredNorm();
    return first_length <= second_length ? first : second;
}

/// Each group with all triangles of its elements; those of element e begin at starts[e].
void spread_groups(std::vector<ElementGroup>& groups, const std::vector<Index>& starts)
{
    for (ElementGroup& group : groups) {
        std::vector<Index> triangles;
        for (const Index element : group.elements) {
            const auto e = static_cast<std::size_t>(element);
            for (Index t = starts[e]; t < starts[e + 1]; ++t)
                triangles.push_back(t);
        }
        group.elements = std::move(triangles);
    }
}

} // namespace

MeshData triangulated(MeshData mesh)
{
    std::vector<Element> triangles;
    std::vector<Index> origin; // element of each triangle
    std::vector<Index> starts{0};
    triangles.reserve(mesh.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element& element = mesh.elements[e];
        if (corner_count(element) == 3)
            triangles.push_back(element);
        else
            for (const Element& triangle : split(mesh.points, element))
                triangles.push_back(triangle);
        origin.resize(triangles.size(), static_cast<Index>(e));
        starts.push_back(static_cast<Index>(triangles.size()));
    }
    if (triangles.size() == mesh.elements.size())
        return mesh;
    spread_groups(mesh.groups, starts);
    for (Field& field : mesh.fields)
        if (field.location == FieldLocation::element)
            field.values = Matrix(field.values(origin, Eigen::all));
    mesh.elements = std::move(triangles);
    return mesh;
}

} // namespace morph
