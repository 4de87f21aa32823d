#include "tools/remesh/remesh_report.h"

#include "libmorph/core/names.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/wanted_size.h"
#include "tools/common/quality_json.h"

#include <numeric>
#include <vector>

namespace morph::tools {

namespace {

/// Smallest, mean and worst of the triangles: the measure that remeshing aims at.
nlohmann::ordered_json triangle_json(const Mesh& mesh)
{
    const std::vector<double> quality = triangle_qualities(mesh);
    std::vector<double> of_triangles;
    Index worst = -1;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const auto place = static_cast<std::size_t>(f);
        if (element_corners(mesh, f)[3] >= 0)
            continue;
        of_triangles.push_back(quality[place]);
        if (worst < 0 || quality[place] < quality[static_cast<std::size_t>(worst)])
            worst = f;
    }
    if (worst < 0)
        return nullptr;
    const double sum = std::accumulate(of_triangles.begin(), of_triangles.end(), 0.0);
    return {{"min", quality[static_cast<std::size_t>(worst)]},
            {"mean", sum / static_cast<double>(of_triangles.size())},
            {"worst_element", mesh.numbering.element[static_cast<std::size_t>(worst)]}};
}

} // namespace

void describe_remeshing(const Mesh& old, const Mesh& mesh, const Eigen::VectorXd& sizes,
                        const std::string& output, Report& report)
{
    const double conformity = size_conformity(mesh, sizes);
    const QualityReport before = quality_report(old), after = quality_report(mesh);
    report.json["quality"] = {{"before", quality_json(before)}, {"after", quality_json(after)}};
    report.json["triangle_quality"] = {{"before", triangle_json(old)}, {"after", triangle_json(mesh)}};
    report.json["size_conformity"] = conformity;
    report.say(output + ": " + std::to_string(after.vertices) + " vertices, " +
               std::to_string(after.triangles) + " triangles, " + std::to_string(after.quads) +
               " quads (from " + std::to_string(before.vertices) + ", " + std::to_string(before.triangles) +
               ", " + std::to_string(before.quads) + ")");
    report.say("  " + short_number(100 * conformity) +
               " % of the edges have 0.7 to 1.4 times the length wanted");
    for (const std::string& text : quality_summary(after))
        report.say("  " + text);
}

} // namespace morph::tools
