#include "libmorph/core/progress.h"

#include <utility>

namespace morph {

namespace {

ProgressSink& current_sink()
{
    static ProgressSink sink;
    return sink;
}

} // namespace

void set_progress_sink(ProgressSink sink)
{
    current_sink() = std::move(sink);
}

void report_progress(std::string_view stage, double fraction)
{
    if (current_sink())
        current_sink()(stage, fraction);
}

} // namespace morph
