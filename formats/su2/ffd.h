#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// A free-form deformation box of an SU2 mesh file.
struct Su2FfdBox {
    std::string tag;
    int dimension = 2;           ///< 2: control points of k = 0 only, z = 0
    std::array<int, 3> points{}; ///< control points along i, j, k; k: 1 in the plane
    std::array<int, 3> degree{}; ///< of the basis; k: 0 in the plane
    bool bspline = false;        ///< uniform B-splines; false: Bernstein polynomials
    Points control_points;       ///< N x 3, i fastest, then j, then k
};

/// The boxes in the opaque sections of an SU2 file:
/// https://su2code.github.io/docs_v7/Mesh-Deformation/.
///
/// A file that was set up but never run through SU2_DEF has corner points only; the control points are then
/// those of the box between them.
/// @param carried  sections of an SU2 mesh, Mesh::sections
/// @param path     for messages
/// @throws InputError  a box without tag, degrees or points, or with a number of them that does not go with
/// its
///                     degrees; names the box
std::vector<Su2FfdBox> su2_ffd_boxes(const std::vector<OpaqueSection>& carried, const std::string& path);

} // namespace morph
