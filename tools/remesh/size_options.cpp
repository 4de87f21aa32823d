#include "tools/remesh/size_options.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/remesh/wanted_size.h"

#include <vector>

namespace morph::tools {

void add_size_options(CLI::App& app, SizeOptions& options)
{
    CLI::Option* size = app.add_option("--size", options.size, "Edge length wanted everywhere")
                            ->check(CLI::PositiveNumber)
                            ->type_name("H");
    app.add_option("--size-field", options.size_field,
                   "Nodal field of IN with the edge lengths wanted (default: those IN has)")
        ->excludes(size)
        ->type_name("NAME");
    app.add_option("--scale", options.scale, "Factor on the edge lengths wanted")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--vertices", options.vertices, "Scale them further, to about this many vertices")
        ->check(CLI::Range(3, 100000000))
        ->type_name("N");
    app.add_option("--gradation", options.gradation,
                   "Edges that follow each other differ in length by at most this factor, such as 1.2")
        ->check(CLI::Range(1.01, 100.0));
}

Eigen::VectorXd wanted_sizes(const Mesh& mesh, const SizeOptions& options, const std::string& input)
{
    Eigen::VectorXd sizes = own_sizes(mesh);
    if (options.size > 0)
        sizes.setConstant(options.size);
    else if (!options.size_field.empty()) {
        const Field* field = find_field(mesh.fields, options.size_field, FieldLocation::vertex);
        std::vector<std::string> names;
        for (const Field& f : mesh.fields)
            names.push_back(f.name);
        if (field == nullptr)
            throw InputError(input + ": has no nodal field '" + options.size_field + "'" +
                             did_you_mean(options.size_field, names));
        if (field->values.cols() != 1)
            throw InputError(input + ": field '" + options.size_field + "' has " +
                             std::to_string(field->values.cols()) + " components, but a size has 1");
        sizes = field->values.col(0);
    }
    sizes *= options.scale;
    // Each undoes a little of what the other did, less and less.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        if (options.vertices > 0)
            scale_to_vertices(mesh, options.vertices, sizes);
        if (options.gradation > 0)
            limit_gradation(mesh, options.gradation, sizes);
    }
    return sizes;
}

} // namespace morph::tools
