#include "tools/common/report.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace morph::tools {

Report::Report(const CommonOptions& options)
    : options_(options), json_(std::make_unique<nlohmann::ordered_json>(nlohmann::ordered_json::object())),
      json(*json_)
{
    if (!options_.json.empty() && options_.json != "-")
        OutputFiles::require_writable(options_.json);
}

Report::~Report() = default;

void Report::say(const std::string& line)
{
    summary_ += line + '\n';
}

void Report::finish()
{
    OutputFiles none;
    finish(none);
}

void Report::finish(OutputFiles& outputs)
{
    // Names from a file may hold bytes that are not UTF-8; they must not stop the report.
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
    if (!options_.json.empty() && options_.json != "-")
        outputs.open(options_.json).append(text);
    outputs.commit();
    if (options_.json == "-")
        std::cout << text;
    else if (!options_.quiet)
        std::cout << summary_;
}

} // namespace morph::tools
