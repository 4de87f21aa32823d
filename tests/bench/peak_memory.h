#pragma once

#include <cstddef>

namespace morph::bench {

/// How far the resident memory of this process rises above what it is when this is made.
///
/// Linux only: resets and reads the high-water mark of the process (proc(5), clear_refs and VmHWM).
class PeakMemory {
public:
    PeakMemory();
    std::size_t bytes() const;

private:
    std::size_t start_;
};

} // namespace morph::bench
