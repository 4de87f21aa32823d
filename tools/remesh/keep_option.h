#pragma once

#include "libmorph/remesh/near_marker.h"

#include <string>
#include <vector>

namespace morph::tools {

class CommandLine;

/// --keep, which may be given several times.
void add_keep_option(CommandLine& line, std::vector<std::string>& texts);

/// The zones that the texts of --keep name; "quads", which are kept anyway, is none.
/// @throws UsageError  a text that is not "quads" or MARKER:DISTANCE with a distance of 0 or more
std::vector<KeptZone> kept_zones(const std::vector<std::string>& texts);

} // namespace morph::tools
