#pragma once

namespace morph::tools {

/// From now on draw the library's progress as a bar on standard error, if that is a terminal, for
/// work that takes over a second.
void show_progress_bar();

} // namespace morph::tools
