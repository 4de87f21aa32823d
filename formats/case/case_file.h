#pragma once

#include "libmorph/basis/curve.h"
#include "tools/case/constraints_entry.h"
#include "tools/case/deform_entry.h"
#include "tools/case/lattice_entry.h"
#include "tools/case/pull_entry.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morph::tools {

/// [mesh] generate: the domain to be meshed.
struct GenerateEntry {
    std::array<double, 4> box{}; ///< xmin, ymin, xmax, ymax
    double size = 0;             ///< target edge length on the box
};

/// One [[boundary]]: a marker and the curve that carries it.
struct BoundaryEntry {
    std::string name;
    CurveDefinition curve;
    Index nodes = 0;       ///< with generate: how many nodes the curve gets; 0 when not given
    Points2 displacements; ///< K x 2, zero when not given
    int line = 0;          ///< in the case file, for messages
};

/// A case file, checked: every key known, every number finite, every path made relative to the file.
struct CaseFile {
    std::string path;
    std::string mesh_file; ///< empty with generate
    std::optional<GenerateEntry> generate;
    std::vector<BoundaryEntry> boundaries;
    std::optional<LatticeEntry> lattice;
    std::vector<PullEntry> pulls;
    std::optional<ConstraintsEntry> constraints;
    DeformEntry deform;
    std::string output_mesh; ///< empty when not given
};

/// @throws InputError  "case.toml:12: what is wrong"; unknown keys name the nearest known one
CaseFile read_case_file(const std::string& path);

/// As read_case_file(), from bytes in memory; paths in it are relative to the folder of @p path.
CaseFile parse_case_file(std::string_view bytes, const std::string& path);

} // namespace morph::tools
