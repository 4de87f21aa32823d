#include "tools/common/progress_bar.h"

#include "libmorph/core/progress.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

#include <unistd.h>

namespace morph::tools {

namespace {

using Clock = std::chrono::steady_clock;

/// Redraws one line in place; wipes it when its stage is done.
class ProgressBar {
public:
    void show(std::string_view stage, double fraction)
    {
        const auto now = Clock::now();
        const bool finished = fraction >= 1;
        if (now - start_ < std::chrono::seconds(1))
            return;
        if (!finished && drawn_ && now - last_ < std::chrono::milliseconds(50))
            return;
        last_ = now;
        finished ? wipe() : draw(stage, fraction);
    }

private:
    void draw(std::string_view stage, double fraction)
    {
        constexpr int kCells = 30;
        const int filled = std::clamp(static_cast<int>(fraction * kCells), 0, kCells);
        const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                                std::string(static_cast<std::size_t>(kCells - filled), ' ');
        std::fprintf(stderr, "\r\033[K[%s] %3d%% %.*s", bar.c_str(), static_cast<int>(100 * fraction),
                     static_cast<int>(stage.size()), stage.data());
        std::fflush(stderr);
        drawn_ = true;
    }

    void wipe()
    {
        if (drawn_)
            std::fputs("\r\033[K", stderr);
        drawn_ = false;
    }

    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool drawn_ = false;
};

} // namespace

void show_progress_bar()
{
    if (isatty(STDERR_FILENO) == 0)
        return;
    set_progress_sink([bar = ProgressBar()](std::string_view stage, double fraction) mutable {
        bar.show(stage, fraction);
    });
}

} // namespace morph::tools
