#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace morph::tools {

/// What the shell gets.
enum ExitStatus : int {
    kDone = 0,
    kFailed = 1,     ///< bad input or a failure; nothing was written
    kWrongUsage = 2, ///< the command line cannot be understood
    kInverted = 3,   ///< done and written, but the resulting mesh has inverted elements or crosses itself
};

/// The command line cannot be understood.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Run a tool's work; whatever it throws becomes one line "TOOL: what" on standard error and a status.
int run(const std::string& tool, const std::function<int()>& work);

/// One line "TOOL: warning: what" on standard error, unless --quiet was given.
void warn(const std::string& tool, const std::string& what);

/// --quiet: from now on only errors are printed.
void set_quiet(bool quiet);
bool is_quiet();

} // namespace morph::tools
