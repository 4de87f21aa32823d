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

/// Finds triangles of the background mesh: the elements of the mesh that are not kept, in their order.
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
    settings.transfer = false;
    const Retriangulated bare = retriangulate(mesh, kept, settings);
    Outline outline{build_mesh(bare.data), {}, {}};
    for (const Index element : outline.mesh.numbering.element)
        outline.kept.push_back(!bare.made[at(element)]);
    for (const Index vertex : outline.mesh.numbering.vertex)
        outline.vertex.push_back(bare.vertex[at(vertex)]);
    return outline;
}

/// The corner table of an outline whose vertices know their place and size on the mesh itself.
CornerTable corner_table_on(const BackgroundMesh& background, const Mesh& mesh, const Outline& outline)
{
    const CornerTable& below = background.table();
    std::vector<Index> of_file(at(mesh.numbering.file_vertices), -1);
    for (std::size_t v = 0; v < below.vertices.size(); ++v)
        of_file[at(mesh.numbering.vertex[at(below.vertices[v].origin)])] = static_cast<Index>(v);
    CornerTable table = corner_table_of(outline.mesh, outline.kept);
    for (TableVertex& vertex : table.vertices) {
        const TableVertex& same = below.vertices[at(of_file[at(outline.vertex[at(vertex.origin)])])];
        vertex.size = same.size;
        vertex.below = same.out / 3;
    }
    return table;
}

} // namespace

Outline start_from_boundary(RemeshState& state, const Mesh& mesh, const std::vector<bool>& kept)
{
    Outline outline = outline_of(mesh, kept);
    state.table = corner_table_on(state.background, mesh, outline);
    state.curves.clear();
    state.background.jump_with(jump_in(mesh, kept));
    return outline;
}

} // namespace morph
