#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace morph::tools {

/// What every tool takes.
struct CommonOptions {
    std::string json; ///< file for the report, "-" for standard output, empty for none
    bool quiet = false;
    int threads = 0; ///< 0: every core
};

/// The command line of one tool: its own options on app(), the common ones already there.
class CommandLine {
public:
    /// @param example  a worked example, the last thing --help prints
    CommandLine(const std::string& tool, const std::string& description, const std::string& example);

    CLI::App& app() { return app_; }
    const CommonOptions& common() const { return common_; }

    /// --from and --to for the tools that read and write meshes.
    void add_from(std::string& from);
    void add_to(std::string& to);

    /// Takes the arguments and applies --threads and --quiet.
    /// @return false when --help or --version was asked for and has been answered
    /// @throws UsageError  unknown option (names the nearest), missing or extra argument, bad value
    bool parse(int argc, char** argv);

private:
    std::string unknown_options() const;

    CLI::App app_;
    CommonOptions common_;
};

} // namespace morph::tools
