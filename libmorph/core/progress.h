#pragma once

#include <functional>
#include <string_view>

namespace morph {

/// Receives what long work is doing: a stage in a few words and the fraction done, in [0, 1].
using ProgressSink = std::function<void(std::string_view stage, double fraction)>;

/// Where progress goes from now on; an empty sink (the default) drops it. The sink is called from
/// the thread that called the library.
void set_progress_sink(ProgressSink sink);

/// Say how far @p stage has come. Cheap enough for a few hundred calls a stage.
void report_progress(std::string_view stage, double fraction);

} // namespace morph
