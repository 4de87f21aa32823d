#include "libmorph/remesh/start_from_boundary.h"

#include "libmorph/geometry/element_tree.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/corner_table_mesh.h"
#include "libmorph/remesh/retriangulate.h"

#include <functional>
#include <memory>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Finds triangles of the underlay, which are the elements of the mesh that are not kept, in their order.
std::function<Index(const Eigen::Vector3d&)> jump_in(const Mesh& mesh, const std::vector<bool>& kept)
{
    std::vector<Index> triangle(kept.size(), -1);
    Index count = 0;
    for (std::size_t f = 0; f < kept.size(); ++f)
        if (!kept[f])
            triangle[f] = count++;
    return [tree = std::make_shared<ElementTree>(mesh), triangle](const Eigen::Vector3d& point) {
        return triangle[at(tree->closest(point).face)];
    };
}

Outline outline_of(const Mesh& mesh, const std::vector<bool>& kept)
{
    RetriangulateSettings settings;
    settings.inner_vertices = false;
    settings.carry = false;
    const Retriangulated bare = retriangulate(mesh, kept, settings);
    Outline outline{build_mesh(bare.data), {}, {}};
    for (const Index element : outline.mesh.numbering.element)
        outline.kept.push_back(!bare.made[at(element)]);
    for (const Index vertex : outline.mesh.numbering.vertex)
        outline.vertex.push_back(bare.vertex[at(vertex)]);
    return outline;
}

/// The net of an outline whose vertices know their place and size on the mesh itself.
CornerTable net_on(const BackgroundMesh& underlay, const Mesh& mesh, const Outline& outline)
{
    const CornerTable& below = underlay.net();
    std::vector<Index> of_file(at(mesh.numbering.file_vertices), -1);
    for (std::size_t v = 0; v < below.vertices.size(); ++v)
        of_file[at(mesh.numbering.vertex[at(below.vertices[v].origin)])] = static_cast<Index>(v);
    CornerTable net = net_of(outline.mesh, outline.kept);
    for (TableVertex& vertex : net.vertices) {
        const TableVertex& same = below.vertices[at(of_file[at(outline.vertex[at(vertex.origin)])])];
        vertex.size = same.size;
        vertex.below = same.out / 3;
    }
    return net;
}

} // namespace

Outline start_from_outline(RemeshState& made, const Mesh& mesh, const std::vector<bool>& kept)
{
    Outline outline = outline_of(mesh, kept);
    made.net = net_on(made.underlay, mesh, outline);
    made.curves.clear();
    made.underlay.jump_with(jump_in(mesh, kept));
    return outline;
}

} // namespace morph
