#pragma once

#include "libmorph/mesh/edits.h"

#include <optional>
#include <string>

namespace morph::tools {

/// The transform that options ask for: scaled, then turned about the origin, then moved. None when nothing is
/// asked for.
/// @param scale      "" or one factor, or one for each axis: "0.001", "1,2,1"
/// @param rotate     "" or degrees about the z axis, or another axis in front: "30", "x:90"
/// @param translate  "" or two or three lengths: "1,0", "0,0,2"
/// @throws UsageError  not such numbers; a factor that is not positive
std::optional<Transform> make_transform(const std::string& scale, const std::string& rotate,
                                        const std::string& translate);

} // namespace morph::tools
