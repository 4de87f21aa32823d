#pragma once

#include "libmorph/mesh/mesh.h"

#include <CLI/CLI.hpp>

#include <string>

namespace morph::tools {

/// Where the edge lengths wanted come from: options of the command line.
struct SizeOptions {
    double size = 0; ///< 0: not given, as for the others
    double scale = 1;
    std::string size_field;
    Index vertices = 0;
    double gradation = 0;
};

void add_size_options(CLI::App& app, SizeOptions& options);

/// The edge length wanted at each vertex: n values.
/// @param input  name of the mesh's file, for errors
/// @throws InputError  no such field of sizes, or not one value a vertex
Eigen::VectorXd wanted_sizes(const Mesh& mesh, const SizeOptions& options, const std::string& input);

} // namespace morph::tools
