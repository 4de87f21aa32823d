#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <vector>

namespace morph {

enum class VolumeShape { tetrahedron, pyramid, prism, hexahedron };

/// 4, 5, 6 or 8.
int corner_count(VolumeShape shape);

/// A cell of a volume mesh, its corners in the order that VTK, SU2, CGNS and Gmsh share: the base (seen
/// from the rest of the cell counter-clockwise), then the apex or the opposite face in the same order.
struct VolumeCell {
    VolumeShape shape;
    std::array<Index, 8> corners;
};

/// The cells of a file that may hold a volume mesh. What the file lists as faces, with its groups and the
/// fields of vertices and faces, is in @p mesh; the cells are separate.
struct VolumeFile {
    MeshData mesh;
    std::vector<VolumeCell> cells;
};

/// The mesh that a reader returns: the faces listed, when the file has no cells. Of a volume mesh, the faces
/// that belong to one cell only, pointing outwards, in the order of the cells; a listed face keeps its
/// groups, and where all boundary faces are listed, its element fields. Vertices that lie on no boundary face
/// are left out. Markers (edges) stay where their edge does. Interior listed faces, and element fields that
/// do not cover the boundary, are left out and warned of.
/// @throws InputError  there are cells and @p file.options do not ask for the surface; a corner out of range
///                     or named twice; a face of three cells
MeshData surface_of(VolumeFile volume, const InputBytes& file);

} // namespace morph
