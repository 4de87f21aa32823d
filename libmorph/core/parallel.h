#pragma once

#include <cstddef>
#include <functional>

namespace morph {

/// Number of threads that parallel_for uses; at least 1.
int thread_count();

/// Use @p count threads from now on; 0 means every core of the machine.
/// @throws InputError  count is negative
void set_thread_count(int count);

/// Call body(begin, end) on consecutive blocks of at most @p grain items that cover [0, n).
///
/// The blocks depend on n and grain only, never on the number of threads. A body that writes only
/// what belongs to its own items, or its own slot begin / grain, therefore gives the same bytes for
/// any thread count. The exception of the first block that throws is rethrown here once all have ended.
/// A call from inside a body runs in the calling thread.
void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body);

} // namespace morph
