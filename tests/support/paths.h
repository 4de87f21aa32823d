#pragma once

#include <string>

namespace morph::test {

/// Absolute path of a file in tests/data.
std::string data_path(const std::string& name);

/// Absolute path of a file in examples.
std::string example_path(const std::string& name);

/// Absolute path of a file or folder of the project.
std::string source_path(const std::string& name);

/// Absolute path of a tool that was built, such as "morph-deform".
std::string tool_path(const std::string& name);

} // namespace morph::test
