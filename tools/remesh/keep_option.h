#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph::tools {

class CommandLine;

/// Elements near a marker, to be kept as they are.
struct KeptZone {
    std::string marker;
    double distance = 0; ///< length unit of the mesh
};

/// --keep, which may be given several times.
void add_keep_option(CommandLine& line, std::vector<std::string>& texts);

/// The zones that the texts of --keep name; "quads", which are kept anyway, is none.
/// @throws UsageError  a text that is not "quads" or MARKER:DISTANCE with a distance of 0 or more
std::vector<KeptZone> kept_zones(const std::vector<std::string>& texts);

/// Mark the elements in the zones in @p kept, which is empty or has m marks.
/// @throws InputError  no such marker (names the nearest)
void keep_zones(const Mesh& mesh, const std::vector<KeptZone>& zones, std::vector<bool>& kept);

} // namespace morph::tools
