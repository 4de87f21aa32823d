#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/features.h"

#include <string>

namespace morph {

/// Where the target sizes of remeshing come from: @c size_field, or else @c adapt, or else @c size, or else the
/// edges of the mesh. These are lowered to those of @c curvature, multiplied by @c scale, and scaled to
/// @c vertices. No number is negative, and 0 stands for one that is not given.
struct SizeSettings {
    double size = 0;             ///< target edge length everywhere; with curvature or adapt the largest
    double scale = 1;            ///< factor on all of them
    std::string size_field = {}; ///< nodal field of the mesh with the target edge lengths
    double curvature = 0;   ///< chord error, see chord_sizes(); without a size they are limited to a tenth
                            ///  of the bounding box's diagonal
    std::string adapt = {}; ///< nodal field, see interpolation_sizes()
    Index vertices = 0;     ///< about so many; 0: any, with adapt as many as the mesh has
    double gradation = 0;   ///< above 1, see limit_gradation(); 0: 1.2 with size_field, curvature or adapt,
                            ///  else no limit
};

/// How many vertices the new mesh is to have; 0: any number.
Index target_vertices(const Mesh& mesh, const SizeSettings& settings);

/// The target edge length at each vertex: n values, length unit of the mesh.
/// @param mesh      n vertices
/// @param settings  where the sizes come from
/// @param features  whose curvature counts for SizeSettings::curvature
/// @param where     in front of messages about the fields of the mesh, as in "wing.vtu: "
/// @throws InputError  no such field (names the nearest), other than one value a vertex in size_field, a size
///                     that is not positive or another value that is not finite (names field and vertex); as
///                     chord_sizes()
Eigen::VectorXd target_sizes(const Mesh& mesh, const SizeSettings& settings,
                             const FeatureSettings& features = {}, const std::string& where = {});

} // namespace morph
