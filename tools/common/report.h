#pragma once

#include "formats/output_files.h"
#include "tools/common/command_line.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>

namespace morph::tools {

/// What a tool did: as JSON where --json asks for it, and as a short readable summary on standard
/// output unless the JSON goes there or --quiet was given.
class Report {
public:
    /// Makes sure that the JSON file can be written, before the tool's work.
    /// @throws InputError  the file cannot be written
    explicit Report(const CommonOptions& options);
    ~Report();
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

    /// Add a line to the summary.
    void say(const std::string& line);

    /// Add the JSON to the tool's files, commit them all, and print the summary. Call it once, at the end.
    void finish(OutputFiles& outputs);

    /// As finish(outputs), for a tool with no files of its own.
    void finish();

private:
    CommonOptions options_;
    std::string summary_;
    std::unique_ptr<nlohmann::ordered_json> json_; ///< declared before the reference to it

public:
    /// The report's fields, written in the order they are set.
    nlohmann::ordered_json& json;
};

} // namespace morph::tools
