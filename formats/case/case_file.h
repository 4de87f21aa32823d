#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/pipeline/generate.h"
#include "libmorph/pipeline/settings.h"

#include <optional>
#include <string>
#include <string_view>

namespace morph {

/// A case file, checked: every key known, every number finite, every path made relative to the file.
struct CaseFile {
    std::string path;
    std::string mesh_file;                    ///< empty with generate
    std::optional<GenerateSettings> generate; ///< the domain to be meshed, without its curves
    MotionSettings motion;
    std::string output_mesh; ///< empty when not given

    std::string su2_box;          ///< tag of the FFD box that is to be the lattice, see take_su2_box()
    Matrix su2_box_displacements; ///< rows i, j, k, dx, dy, dz
};

/// @throws InputError  "case.toml:12: what is wrong"; unknown keys name the nearest known one
CaseFile read_case_file(const std::string& path);

/// As read_case_file(), from bytes in memory; paths in it are relative to the folder of @p path.
CaseFile parse_case_file(std::string_view bytes, const std::string& path);

/// The mesh of a case, read or generated.
/// @param file  from read_case_file()
/// @param from  format of the file, when its extension does not say
/// @throws InputError, SolverError  as read_mesh() and generate_mesh()
Mesh case_mesh(const CaseFile& file, const std::string& from = "");

/// Make the FFD box that the case names the lattice of its motion; nothing changes without such a name, or where
/// the motion uses no lattice.
/// @param file  from read_case_file(); its motion gets the lattice
/// @param mesh  read from the SU2 file of the case
/// @throws InputError  the file has no such box; a displacement beyond it
void take_su2_box(CaseFile& file, const Mesh& mesh);

} // namespace morph
