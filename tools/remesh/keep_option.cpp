#include "tools/remesh/keep_option.h"

#include "tools/common/command_line.h"
#include "tools/common/run.h"

#include <cmath>

namespace morph::tools {

void add_keep_option(CommandLine& line, std::vector<std::string>& texts)
{
    line.add("--keep", texts,
             "What stays as it is and keeps its numbers: quads (they always do), or MARKER:DISTANCE, the\n"
             "elements with a vertex within that distance of the marker; may be given several times")
        .one_value_each_time()
        .type_name("WHAT");
}

std::vector<KeptZone> kept_zones(const std::vector<std::string>& texts)
{
    std::vector<KeptZone> zones;
    for (const std::string& text : texts) {
        if (text == "quads")
            continue;
        const std::size_t colon = text.rfind(':'); // names of markers may have some too
        const auto distance = number_in(colon == std::string::npos ? "" : text.substr(colon + 1));
        if (colon == 0 || !distance || !(*distance >= 0) || !std::isfinite(*distance))
            throw UsageError(
                "--keep needs 'quads', or a marker and a distance of 0 or more as in wall:0.1, not '" + text +
                "'");
        zones.push_back({text.substr(0, colon), *distance});
    }
    return zones;
}

} // namespace morph::tools
