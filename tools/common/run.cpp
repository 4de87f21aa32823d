#include "tools/common/run.h"

#include <exception>
#include <iostream>
#include <new>

namespace morph::tools {

namespace {

bool quiet_run = false;

int fail(const std::string& tool, const std::string& what, ExitStatus status)
{
    std::cerr << tool << ": " << what << '\n';
    return status;
}

} // namespace

int run(const std::string& tool, const std::function<int()>& work)
{
    try {
        const int status = work();
        if (!std::cout.flush())
            return fail(tool, "standard output cannot be written", kFailed);
        return status;
    } catch (const UsageError& error) {
        return fail(tool, error.what(), kWrongUsage);
    } catch (const std::bad_alloc&) {
        return fail(tool, "out of memory", kFailed);
    } catch (const std::exception& error) {
        return fail(tool, error.what(), kFailed);
    }
}

void warn(const std::string& tool, const std::string& what)
{
    if (!quiet_run)
        std::cerr << tool << ": warning: " << what << '\n';
}

void set_quiet(bool quiet)
{
    quiet_run = quiet;
}

bool is_quiet()
{
    return quiet_run;
}

} // namespace morph::tools
