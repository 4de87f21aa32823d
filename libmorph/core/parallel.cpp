#include "libmorph/core/parallel.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace morph {

namespace {

std::atomic<int> chosen_threads{0};
thread_local bool inside_parallel_for = false;

int every_core()
{
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Hands out blocks in order and keeps the exception of the first block that fails. When a block
/// fails, all before it have been handed out, so that one is the same for any number of threads.
class BlockQueue {
public:
    BlockQueue(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body)
        : n_(n), grain_(grain), body_(body)
    {
    }

    void work()
    {
        inside_parallel_for = true;
        for (;;) {
            const std::size_t begin = next_.fetch_add(grain_);
            if (begin >= n_)
                break;
            try {
                body_(begin, std::min(begin + grain_, n_));
            } catch (...) {
                keep(begin, std::current_exception());
                next_ = n_;
            }
        }
        inside_parallel_for = false;
    }

    void rethrow() const
    {
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    void keep(std::size_t block, std::exception_ptr failure)
    {
        const std::lock_guard lock(mutex_);
        if (failure_ && failed_block_ < block)
            return;
        failed_block_ = block;
        failure_ = std::move(failure);
    }

    std::size_t n_;
    std::size_t grain_;
    const std::function<void(std::size_t, std::size_t)>& body_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
    std::size_t failed_block_ = 0;
};

} // namespace

int thread_count()
{
    const int chosen = chosen_threads;
    return chosen > 0 ? chosen : every_core();
}

void set_thread_count(int count)
{
    if (count < 0)
        throw InputError("the number of threads is " + std::to_string(count) + ", but it must be 0 or more");
    chosen_threads = count;
}

void parallel_for(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body)
{
    grain = std::max<std::size_t>(grain, 1);
    if (n == 0)
        return;
    const std::size_t blocks = (n - 1) / grain + 1;
    const auto threads = static_cast<std::size_t>(inside_parallel_for ? 1 : thread_count());
    if (std::min(blocks, threads) == 1) {
        for (std::size_t begin = 0; begin < n; begin += grain)
            body(begin, std::min(begin + grain, n));
        return;
    }
    BlockQueue queue(n, grain, body);
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(blocks, threads); ++i)
        helpers.emplace_back([&queue] { queue.work(); });
    queue.work();
    helpers.clear(); // joins
    queue.rethrow();
}

} // namespace morph
