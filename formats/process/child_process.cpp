#include "formats/process/child_process.h"

#include "formats/binary/memory_file.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define MORPH_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define MORPH_ADDRESS_SANITIZER
#endif
#endif

namespace morph {

namespace {

/// How the child says what became of it. None is a status that a library or a sanitizer ends with.
enum Status { kDone = 0, kInputError = 93, kSolverError = 94, kNoMemory = 95 };

void set_limit(__rlimit_resource resource, rlim_t value)
{
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0)
        return;
    limit.rlim_cur = limit.rlim_max = std::min(value, limit.rlim_max);
    setrlimit(resource, &limit);
}

/// Bytes of addresses that this process has.
[[maybe_unused]] std::size_t address_space()
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void silence()
{
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        dup2(nowhere, stream);
}

void limit_child(const ChildLimits& limits)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL); // no work for a parent that is gone
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU, SIGXFSZ, SIGTERM})
        std::signal(signal, SIG_DFL);
    silence();
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, limits.seconds);
    set_limit(RLIMIT_FSIZE, limits.memory);
#ifndef MORPH_ADDRESS_SANITIZER
    set_limit(RLIMIT_AS, address_space() + limits.memory);
#endif
    alarm(10 * limits.seconds);
}

int status_of(const std::function<void()>& work, MemoryFile& message)
{
    try {
        work();
        return kDone;
    } catch (const InputError& error) {
        message.append(error.what());
        return kInputError;
    } catch (const std::bad_alloc&) {
        return kNoMemory;
    } catch (const std::exception& error) {
        message.append(error.what());
        return kSolverError;
    }
}

/// Ends without the parent's exit handlers and buffers, which are not the child's to run.
[[noreturn]] void be_child(const ChildLimits& limits, const std::function<void()>& work, MemoryFile& message)
{
    int status = kNoMemory;
    try {
        limit_child(limits);
        status = status_of(work, message);
    } catch (...) { // the message found no memory
    }
    _exit(status);
}

int wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw SolverError(std::string("a child process was lost: ") + std::strerror(errno));
    return status;
}

[[noreturn]] void fail_of_signal(const std::string& path, int signal)
{
    if (signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL)
        throw InputError(path + ": took more time than its size accounts for; it is damaged");
    if (signal == SIGXFSZ)
        throw InputError(path + ": took more memory than its size accounts for; it is damaged");
    throw InputError(path + ": damaged so that the library for its format crashed (signal " +
                     std::to_string(signal) + ")");
}

} // namespace

void run_in_child(const std::string& path, const ChildLimits& limits, const std::function<void()>& work)
{
    MemoryFile message;
    const pid_t child = fork();
    if (child < 0)
        throw SolverError(std::string("no process could be started: ") + std::strerror(errno));
    if (child == 0)
        be_child(limits, work, message);
    const int status = wait_for(child);
    if (WIFSIGNALED(status))
        fail_of_signal(path, WTERMSIG(status));
    switch (WEXITSTATUS(status)) {
    case kDone:
        return;
    case kInputError:
        throw InputError(std::string(message.bytes()));
    case kSolverError:
        throw SolverError(std::string(message.bytes()));
    case kNoMemory:
        throw InputError(path + ": took more memory than its size accounts for; it is damaged");
    default:
        throw InputError(path + ": damaged so that the library for its format ended with status " +
                         std::to_string(WEXITSTATUS(status)));
    }
}

} // namespace morph
