#pragma once

#include "libmorph/remesh/size_settings.h"

namespace morph::tools {

class CommandLine;

/// The options that say where the target sizes come from.
void add_size_options(CommandLine& line, SizeSettings& options);

} // namespace morph::tools
