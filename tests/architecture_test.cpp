// The folders are the architecture: an include may only point upwards in the list of layers.
#include "tests/support/paths.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace morph;

struct Layer {
    std::string folder;
    std::vector<std::string> may_include; ///< besides itself
};

const std::vector<Layer>& layers()
{
    static const std::vector<std::string> low{"libmorph/core",     "libmorph/mesh",     "libmorph/basis",
                                              "libmorph/geometry", "libmorph/numerics", "libmorph/quality"};
    static const std::vector<std::string> above_deform = [] {
        auto list = low;
        list.emplace_back("libmorph/weights");
        list.emplace_back("libmorph/untangle");
        return list;
    }();
    static const std::vector<std::string> with_remap = [] {
        auto list = low;
        list.emplace_back("libmorph/remap");
        return list;
    }();
    static const std::vector<Layer> list{
        {"libmorph/core", {}},
        {"libmorph/mesh", {"libmorph/core"}},
        {"libmorph/basis", {"libmorph/core"}},
        {"libmorph/geometry", {"libmorph/core", "libmorph/mesh", "libmorph/basis"}},
        {"libmorph/numerics", {"libmorph/core", "libmorph/mesh", "libmorph/geometry"}},
        {"libmorph/quality", {"libmorph/core", "libmorph/mesh", "libmorph/geometry"}},
        {"libmorph/untangle",
         {"libmorph/core", "libmorph/mesh", "libmorph/geometry", "libmorph/numerics", "libmorph/quality"}},
        {"libmorph/weights", low},
        {"libmorph/deform", above_deform},
        {"libmorph/remap", {"libmorph/core", "libmorph/mesh", "libmorph/geometry"}},
        {"libmorph/remesh", with_remap},
        {"libmorph/pipeline", {"libmorph"}},
        {"formats",
         {"libmorph/core", "libmorph/mesh", "libmorph/basis", "libmorph/weights", "libmorph/pipeline"}},
        {"tools", {"libmorph", "formats"}},
    };
    return list;
}

bool lies_in(const std::string& path, const std::string& folder)
{
    return path.rfind(folder + "/", 0) == 0;
}

std::vector<std::string> includes_of(const std::filesystem::path& file)
{
    static const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)")re");
    std::vector<std::string> found;
    std::istringstream lines(test::read_text(file.string()));
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, include))
            found.push_back(match[1]);
    }
    return found;
}

/// The folder that a header in `FOLDER/detail/` belongs to; empty for other headers.
std::string owner(const std::string& included)
{
    const auto detail = included.find("/detail/");
    return detail == std::string::npos ? std::string() : included.substr(0, detail);
}

bool allowed(const Layer& layer, const std::string& included)
{
    if (!owner(included).empty() && !lies_in(owner(included) + "/", layer.folder))
        return false;
    return lies_in(included, layer.folder) ||
           std::any_of(layer.may_include.begin(), layer.may_include.end(),
                       [&](const std::string& folder) { return lies_in(included, folder); });
}

std::vector<std::filesystem::path> sources_below(const std::string& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_path(folder)))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            files.push_back(entry.path());
    return files;
}

TEST(Architecture, EveryIncludePointsUpwardsInTheListOfLayers)
{
    for (const Layer& layer : layers()) {
        const auto files = sources_below(layer.folder);
        EXPECT_FALSE(files.empty()) << layer.folder;
        for (const auto& file : files)
            for (const std::string& included : includes_of(file))
                EXPECT_TRUE(allowed(layer, included)) << file << " includes " << included;
    }
}

TEST(Architecture, EveryFolderOfTheLibraryIsALayer)
{
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("libmorph"))) {
        if (!entry.is_directory())
            continue;
        const std::string folder = "libmorph/" + entry.path().filename().string();
        EXPECT_TRUE(std::any_of(layers().begin(), layers().end(), [&](const Layer& l) {
            return l.folder == folder;
        })) << folder;
    }
}

TEST(Architecture, HeavyLibrariesStayOutOfHeaders)
{
    static const std::regex heavy(
        R"re(^\s*#\s*include\s*<(CGAL|flann|cholmod|suitesparse|cblas|lapacke|cairo|cgnslib|cgns_io|hdf5|toml\+\+|CLI|nlohmann/json)[/.])re");
    for (const std::string folder : {"libmorph", "formats", "tools"})
        for (const auto& file : sources_below(folder)) {
            if (file.extension() != ".h")
                continue;
            std::istringstream lines(test::read_text(file.string()));
            for (std::string line; std::getline(lines, line);)
                EXPECT_FALSE(std::regex_search(line, heavy)) << file << ": " << line;
        }
}

} // namespace
