#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/features.h"

#include <string>

namespace morph::tools {

class CommandLine;

/// Where the edge lengths wanted come from: options of the command line.
struct SizeOptions {
    double size = 0; ///< 0: not given, as for the others
    double scale = 1;
    std::string size_field;
    double curvature = 0; ///< chord error
    std::string adapt;
    Index vertices = 0;
    double gradation = 0;
};

void add_size_options(CommandLine& line, SizeOptions& options);

/// How many vertices the new mesh is to have; 0: as many as come.
Index wanted_vertices(const Mesh& mesh, const SizeOptions& options);

/// The edge length wanted at each vertex: n values.
/// @param features  whose curvature counts for SizeOptions::curvature
/// @param input     name of the mesh's file, for errors
/// @throws InputError  no such field, not one value a vertex where sizes are asked for, a size that is not
/// positive or
///                     another value that is not finite (names file, field and vertex)
Eigen::VectorXd target_sizes(const Mesh& mesh, const SizeOptions& options, const FeatureSettings& features,
                             const std::string& input);

} // namespace morph::tools
