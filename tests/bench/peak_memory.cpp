#include "tests/bench/peak_memory.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace morph::bench {

namespace {

/// A line "key:  123 kB" of /proc/self/status, in bytes.
std::size_t status_bytes(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key + ":"))
            return 1024 * std::stoull(line.substr(key.size() + 1));
    throw std::runtime_error("/proc/self/status has no " + key);
}

} // namespace

PeakMemory::PeakMemory()
{
    // Freed memory goes back to the system at once: what earlier stages left free would otherwise be
    // reused unseen, or count although nothing refers to it.
    constexpr int kReturnedFrom = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, kReturnedFrom);
    mallopt(M_TRIM_THRESHOLD, kReturnedFrom);
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    start_ = status_bytes("VmRSS");
}

std::size_t PeakMemory::bytes() const
{
    return status_bytes("VmHWM") - start_;
}

} // namespace morph::bench
