#include "tests/support/mesh_checks.h"

#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <sstream>

namespace morph::test {

void expect_sound(const Mesh& mesh)
{
    Kernel kernel = mesh.kernel;
    std::ostringstream complaints;
    EXPECT_TRUE(OpenMesh::Utils::MeshCheckerT<Kernel>(kernel).check(
        OpenMesh::Utils::MeshCheckerT<Kernel>::CHECK_ALL, complaints))
        << complaints.str();
    for (const HalfedgeHandle h : kernel.halfedges()) {
        EXPECT_EQ(kernel.from_vertex_handle(kernel.next_halfedge_handle(h)), kernel.to_vertex_handle(h));
        EXPECT_EQ(kernel.face_handle(kernel.next_halfedge_handle(h)), kernel.face_handle(h));
    }
    EXPECT_EQ(mesh.numbering.vertex.size(), kernel.n_vertices());
    EXPECT_EQ(mesh.numbering.element.size(), kernel.n_faces());
}

MeshData shuffled(const MeshData& mesh, unsigned seed)
{
    std::mt19937 random(seed);
    MeshData result = mesh;
    std::vector<Index> number(static_cast<std::size_t>(mesh.points.rows()));
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    const auto rename = [&](Index& v) { v = v < 0 ? v : number[static_cast<std::size_t>(v)]; };
    for (Index v = 0; v < mesh.points.rows(); ++v)
        result.points.row(number[static_cast<std::size_t>(v)]) = mesh.points.row(v);
    for (Element& e : result.elements) {
        std::for_each(e.begin(), e.end(), rename);
        const auto first = static_cast<std::ptrdiff_t>(random() % 3);
        std::rotate(e.begin(), e.begin() + first, e.begin() + corner_count(e));
    }
    for (Marker& marker : result.markers)
        for (auto& edge : marker.edges)
            std::for_each(edge.begin(), edge.end(), rename);
    std::shuffle(result.elements.begin(), result.elements.end(), random);
    return result;
}

void turn_some(MeshData& mesh, double share, unsigned seed)
{
    std::mt19937 random(seed);
    std::bernoulli_distribution chosen(share);
    for (Element& e : mesh.elements)
        if (chosen(random))
            std::reverse(e.begin(), e.begin() + corner_count(e));
}

} // namespace morph::test
