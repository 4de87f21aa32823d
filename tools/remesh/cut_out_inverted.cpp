#include "tools/remesh/cut_out_inverted.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/retriangulate.h"

#include <nlohmann/json.hpp>

namespace morph::tools {

namespace {

constexpr int kRings = 2; // of elements around an inverted one

Retriangulated retriangulated(const Mesh& mesh, const std::vector<bool>& kept, const std::string& name)
{
    try {
        return retriangulate(mesh, kept);
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
}

} // namespace

Mesh without_inverted(const Mesh& mesh, const std::string& name, Report& report)
{
    if (mesh.dimension != 2)
        return mesh;
    const std::vector<Index> inverted = inverted_elements(mesh, points(mesh));
    if (inverted.empty())
        return mesh;
    const Retriangulated remeshed = retriangulated(mesh, all_but(mesh, inverted, kRings), name);
    report.json["cut_out"] = {
        {"inverted", inverted.size()},
        {"elements", remeshed.cut_out},
        {"vertices_left_out", mesh.numbering.file_vertices - remeshed.data.points.rows()}};
    report.say(std::to_string(inverted.size()) + " inverted elements were cut out, with " +
               std::to_string(remeshed.cut_out - static_cast<Index>(inverted.size())) +
               " around them, and remeshed");
    return build_mesh(remeshed.data);
}

} // namespace morph::tools
