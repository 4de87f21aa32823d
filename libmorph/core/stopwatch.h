#pragma once

#include <chrono>

namespace morph {

/// Measures how long stages take.
class Stopwatch {
public:
    /// Seconds since it was made or last asked.
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace morph
