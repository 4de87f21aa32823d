#pragma once

#include "formats/case/toml_table.h"
#include "libmorph/pipeline/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

// The tables of a case file. Each is refused with an InputError "case.toml:12: what is wrong".

/// [lattice]; of an FFD box only what the box does not have.
struct LatticeEntry {
    LatticeSettings settings;
    std::string su2_box; ///< tag of an FFD box of the mesh's SU2 file; empty: the settings have the shape
    Matrix sparse_displacements; ///< rows i, j, k, dx, dy, dz as given
};

LatticeEntry lattice_entry(const TomlTable& table);
DeformSettings deform_settings(const TomlTable& table);
ConstraintSettings constraint_settings(const TomlTable& table);
std::vector<PullSettings> pull_settings(const TomlTable& root);

/// The tables of methods in [deform] and the keys they have there.
void read_method_options(const TomlTable& table, DeformSettings& deform);
const std::vector<std::string>& method_option_keys();

/// Rows i, j, k, dx, dy, dz as a matrix of all control points.
/// @param where  in front of the message
/// @throws InputError  a number beyond the lattice; names the row
Matrix full_displacements(const Matrix& sparse, const std::array<Index, 3>& points, const std::string& where);

} // namespace morph
