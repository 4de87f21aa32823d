#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace morph {

/// What a child process may take before the system ends it.
struct ChildLimits {
    std::size_t memory; ///< bytes beyond what this process has now; also of any file it writes
    unsigned seconds;   ///< of processor time; ten times as much by the clock
};

/// Run @p work in a forked copy of this process: for libraries that meet broken data by crashing, by
/// ending the process, by allocating what a damaged count says or by printing. None of it reaches this
/// process; what @p work leaves in a MemoryFile does.
/// @param path  for messages
/// @throws InputError   as @p work; "path: what became of the child" when it did not come to its end
/// @throws SolverError  as @p work; there is no memory for another process
/// @note No sandbox: the child has the rights of this process. Under AddressSanitizer, which reserves
///       terabytes of addresses, its memory is not limited.
void run_in_child(const std::string& path, const ChildLimits& limits, const std::function<void()>& work);

} // namespace morph
