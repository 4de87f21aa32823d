#pragma once

#include "libmorph/mesh/mesh_data.h"
#include "libmorph/pipeline/settings.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// The domain to be meshed: a box without the insides of curves.
struct GenerateSettings {
    std::string where = {};      ///< in front of messages: "case.toml: "
    std::array<double, 4> box{}; ///< xmin, ymin, xmax, ymax
    double size = 0;             ///< target edge length on the box
};

/// Mesh the box without the insides of the curves: a marker for each curve in their order, each with
/// CurveMove::nodes nodes, and kFarfield for the box. See mesh_domain().
///
/// @throws InputError   a curve without nodes, or as mesh_domain()
/// @throws SolverError  as mesh_domain()
MeshData generate_mesh(const GenerateSettings& settings, const std::vector<CurveMove>& curves);

} // namespace morph
