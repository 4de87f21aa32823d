#pragma once

#include <string>
#include <vector>

namespace morph::test {

/// What a finished process left.
struct ProcessResult {
    int status = -1; ///< exit status; 128 + signal when it was killed
    std::string output;
    std::string errors;
};

/// Run a tool of build/bin (such as "morph-deform") with these arguments and wait for it, at most
/// @p seconds (then it is killed and the status is 128 + SIGKILL).
ProcessResult run_tool(const std::string& tool, const std::vector<std::string>& arguments, int seconds = 120);

/// A folder that is removed, with all in it, when this goes.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    /// Write a file in it and return its path.
    std::string write(const std::string& name, const std::string& text) const;
    /// Names of what is in it, sorted.
    std::vector<std::string> names() const;

private:
    std::string path_;
};

/// The whole file.
std::string read_text(const std::string& path);

} // namespace morph::test
