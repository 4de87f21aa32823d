#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>

namespace morph::tools {

/// A change of place: scaled, then turned about the origin, then moved.
struct Transform {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Eigen::RowVector3d shift = Eigen::RowVector3d::Zero();
    bool moves = false; ///< false: nothing was asked for, coordinates stay as they are, bit for bit

    void apply(MeshData& mesh) const;
};

/// @param scale      "" or one factor, or one for each axis: "0.001", "1,2,1"
/// @param rotate     "" or degrees about the z axis, or another axis in front: "30", "x:90"
/// @param translate  "" or two or three lengths: "1,0", "0,0,2"
/// @throws UsageError  not such numbers; a factor that is not positive
Transform make_transform(const std::string& scale, const std::string& rotate, const std::string& translate);

} // namespace morph::tools
