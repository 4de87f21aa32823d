#include "tests/support/surface_cases.h"

namespace morph::test {

MeshData small_surface()
{
    MeshData mesh;
    mesh.dimension = 3;
    mesh.points.resize(6, 3);
    mesh.points << 0, 0, 0, 1, 0, 0.1, 1, 1, -1.0 / 3, 0, 1, 1e-300, 2, 0, 7, 2, 1, 1e22;
    mesh.elements = {{0, 1, 2, 3}, {1, 4, 2, -1}, {4, 5, 2, -1}};
    return mesh;
}

MeshData bare(MeshData mesh)
{
    mesh.markers.clear();
    mesh.groups.clear();
    mesh.fields.clear();
    mesh.sections.clear();
    return mesh;
}

MeshData with_groups(MeshData mesh)
{
    if (mesh.elements.empty())
        return mesh;
    const auto count = static_cast<Index>(mesh.elements.size());
    ElementGroup first{"first", {}};
    ElementGroup third{"upper side, 50 %", {}};
    for (Index e = 0; e < count; ++e) {
        if (2 * e < count)
            first.elements.push_back(e);
        if (e % 3 == 0)
            third.elements.push_back(e);
    }
    mesh.groups = {std::move(first), std::move(third), {"last", {count - 1}}};
    return mesh;
}

} // namespace morph::test
