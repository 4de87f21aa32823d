#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// A new name of a marker or group.
struct Rename {
    std::string from;
    std::string to;
};

/// Rotation about a coordinate axis, counter-clockwise seen from its tip.
///
/// Exact at multiples of 90 degrees, so that a mesh turned by these stays planar and aligned.
/// @param axis     0, 1, 2: x, y, z
/// @param degrees  finite
Eigen::Matrix3d rotation(int axis, double degrees);

/// An affine map of points: x to linear x + shift.
struct Transform {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Eigen::RowVector3d shift = Eigen::RowVector3d::Zero(); ///< length unit of the mesh
};

/// Map every point; the mesh then is planar or a surface in space as its points are.
void apply_transform(const Transform& transform, MeshData& mesh);

/// What to change of a mesh, for instance between reading and writing.
struct Edits {
    std::vector<Rename> renames = {}; ///< of markers and groups, all at once: two names can be exchanged
    bool drop_all_fields = false;
    std::vector<std::string> drop_fields = {}; ///< names
    double merge_tolerance = 0;                ///< 0: vertices stay as they are; see merge_vertices()
    std::optional<Transform> transform = {};   ///< none: coordinates stay as they are, bit for bit
    bool triangulate = false;                  ///< see triangulated()
};

/// Apply the edits, in the order above.
/// @return what was left out, a warning each
/// @throws InputError  a marker or field to rename or drop does not exist (names the nearest); two markers
///                     would have one name
std::vector<std::string> apply_edits(const Edits& edits, MeshData& mesh);

} // namespace morph
