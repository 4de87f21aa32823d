#pragma once

#include "libmorph/mesh/kernel.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// How the numbers inside the mesh go with the numbers in the file.
///
/// Inside, vertices and elements follow a space-filling curve, because every stage runs several times
/// faster when neighbours lie near each other in memory. Only build_mesh(), to_mesh_data() and whatever
/// prints an id for a person need to know.
struct Numbering {
    std::vector<Index> vertex;  ///< n: file number of each vertex; copies of a split vertex share it
    std::vector<Index> element; ///< m: file number of each element
    std::vector<bool> reversed; ///< m: the file lists this element the other way round, see reversed()
    Index file_vertices = 0;    ///< number of vertices in the file, at most n
};

/// Triangles and quads, planar or on a surface in space, with the markers and fields that go with them.
///
/// Row i of every matrix, and every index in markers and fields, is vertex i (or face i) of the kernel.
/// In a planar mesh the elements run counter-clockwise (unless inverted); the kernel has no deleted items.
struct Mesh {
    // In mesh.cpp, as each takes a compiler over a second.
    Mesh();
    Mesh(const Mesh& other);
    Mesh(Mesh&& other) noexcept(false); ///< OpenMesh copies the kernel
    Mesh& operator=(const Mesh& other);
    Mesh& operator=(Mesh&& other) noexcept(false);
    ~Mesh();

    int dimension = 2; ///< 2: planar, z = 0 throughout · 3: surface in space
    Kernel kernel;
    Numbering numbering;
    std::vector<Marker> markers;
    std::vector<ElementGroup> groups;
    std::vector<Field> fields;
    std::vector<OpaqueSection> sections;
};

inline Index vertex_count(const Mesh& mesh)
{
    return static_cast<Index>(mesh.kernel.n_vertices());
}

inline Index element_count(const Mesh& mesh)
{
    return static_cast<Index>(mesh.kernel.n_faces());
}

/// The number that the file has for vertex @p v; copies of a split vertex share it.
inline Index file_vertex(const Mesh& mesh, Index v)
{
    return mesh.numbering.vertex[v];
}

/// The number that the file has for element @p f.
inline Index file_element(const Mesh& mesh, Index f)
{
    return mesh.numbering.element[f];
}

/// The coordinates of the kernel as an n x 3 matrix; writing to it moves the mesh.
inline Eigen::Map<Points> points(Mesh& mesh)
{
    const Index n = vertex_count(mesh); // the kernel of an empty mesh has no first point
    return {n == 0 ? nullptr : const_cast<double*>(mesh.kernel.points()->data()), n, 3};
}

/// The coordinates of the kernel as an n x 3 matrix.
inline Eigen::Map<const Points> points(const Mesh& mesh)
{
    const Index n = vertex_count(mesh);
    return {n == 0 ? nullptr : mesh.kernel.points()->data(), n, 3};
}

/// For each vertex the first copy of it: itself, unless it is split.
std::vector<Index> representatives(const Numbering& numbering);

/// Corners of face @p face in order, the first as in the file.
Element element_corners(const Mesh& mesh, Index face);

/// Corners of every face, m rows: for loops that pass over the whole mesh several times.
std::vector<Element> element_table(const Mesh& mesh);

/// Marker of that name.
/// @throws InputError  there is none; names those that exist and the nearest
const Marker& marker(const Mesh& mesh, const std::string& name);

/// The vertices of a marker, each once, in the order the edges first name them.
std::vector<Index> marker_vertices(const Marker& marker);

} // namespace morph
