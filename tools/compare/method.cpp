#include "tools/compare/method.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/deform/apply.h"
#include "tools/common/report.h"
#include "tools/deform/case_weights.h"

#include <algorithm>

namespace morph::tools {

namespace {

/// The weights of the case, with another diffusivity.
MovedMesh move_harmonic(const Mesh& mesh, const PlacedCase& placed, CaseFile file,
                        const std::string& diffusivity)
{
    file.method = "harmonic";
    file.diffusivity = diffusivity;
    Stopwatch watch;
    const Weights weights = solve_weights(mesh, placed, file);
    MovedMesh moved;
    moved.weights_seconds = watch.lap();
    moved.positions = points(mesh);
    watch.lap();
    apply_weights(weights, placed.displacements,
                  Eigen::Map<Points>(moved.positions.data(), moved.positions.rows(), 3));
    moved.move_seconds = watch.lap();
    moved.control_variables = static_cast<Index>(placed.displacements.size());
    moved.weights_bytes = sizeof(double) * static_cast<std::size_t>(weights.values.size());
    return moved;
}

} // namespace

const std::vector<CompareMethod>& compare_methods()
{
    static const std::vector<CompareMethod> table{
        {"harmonic", "Laplace's equation, as in the thesis",
         [](const Mesh& mesh, const PlacedCase& placed, const CaseFile& file) {
             return move_harmonic(mesh, placed, file, "uniform");
         }},
        {"harmonic-distance", "harmonic, stiff near the body: diffusivity 1/distance",
         [](const Mesh& mesh, const PlacedCase& placed, const CaseFile& file) {
             return move_harmonic(mesh, placed, file, "inverse-distance");
         }},
        {"harmonic-area", "harmonic, small elements stiff: diffusivity 1/area",
         [](const Mesh& mesh, const PlacedCase& placed, const CaseFile& file) {
             return move_harmonic(mesh, placed, file, "inverse-area");
         }},
    };
    return table;
}

const CompareMethod& compare_method(const std::string& name)
{
    std::vector<std::string> names;
    for (const CompareMethod& method : compare_methods()) {
        if (method.name == name)
            return method;
        names.push_back(method.name);
    }
    throw InputError("method '" + name + "' is not known; known are " + joined(names) +
                     did_you_mean(name, names));
}

} // namespace morph::tools
