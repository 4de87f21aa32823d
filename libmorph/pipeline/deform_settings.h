#pragma once

#include "tools/case/method_options.h"

#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// A marker that moves as one rigid body, or the cells beside it that move with it.
struct RigidEntry {
    int line = 0;
    std::string marker;
    double distance = 0; ///< of the cells, length unit of the mesh; 0: the marker itself
};

/// [deform]: how the boundary takes the mesh along.
struct DeformEntry {
    int line = 1; ///< in the case file, for messages
    std::string method = "harmonic";
    std::string diffusivity = "uniform";
    std::string guard = "check";
    std::optional<std::vector<std::string>> fixed;
    std::optional<bool> rotations; ///< not given: with "idw" only, see uses_rotations()
    int steps = 1;                 ///< 0: as many as the safe step asks for
    std::vector<std::string> slide;
    std::vector<RigidEntry> rigid;
    MethodOptions options;
};

/// What [deform] method, diffusivity and guard may be.
const std::vector<std::string>& move_methods();
const std::vector<std::string>& diffusivities();
const std::vector<std::string>& guards();

/// Whether the boundary's rotation is spread too. Inverse distance weighting does it unless told otherwise,
/// as in the paper it comes from.
bool uses_rotations(const DeformEntry& deform);

/// Read [deform].
/// @throws InputError  "case.toml:12: what is wrong"
DeformEntry deform_entry(const TomlTable& table);

} // namespace morph::tools
