#include "tests/support/paths.h"

// The only source that knows where the project and its build are, so that all other objects are the same
// in every folder.
namespace morph::test {

std::string data_path(const std::string& name)
{
    return source_path("tests/data/" + name);
}

std::string example_path(const std::string& name)
{
    return source_path("examples/" + name);
}

std::string source_path(const std::string& name)
{
    return std::string(MORPH_SOURCE) + "/" + name;
}

std::string tool_path(const std::string& name)
{
    return std::string(MORPH_BIN) + "/" + name;
}

} // namespace morph::test
