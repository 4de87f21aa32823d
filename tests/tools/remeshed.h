#pragma once

#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace morph::test {

/// The report of a run of morph-remesh that has to succeed.
inline nlohmann::json remeshed(const std::vector<std::string>& arguments)
{
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--json", "-"});
    const ProcessResult result = run_tool("morph-remesh", all);
    EXPECT_EQ(result.status, 0) << result.errors;
    return nlohmann::json::parse(result.output);
}

} // namespace morph::test
