#pragma once

#include "libmorph/remesh/background_mesh.h"
#include "libmorph/remesh/corner_table.h"
#include "libmorph/remesh/feature_curve.h"

#include <optional>
#include <vector>

namespace morph {

/// A mesh during remeshing.
struct RemeshState {
    CornerTable table;
    std::vector<FeatureCurve> curves; ///< by TableVertex::curve and CornerTable::tag
    BackgroundMesh background;
    bool planar = true;
};

/// Edges are split above and collapsed below these parts of the target length. Their ratio is 2, so that the
/// halves of a split edge are not short.
inline constexpr double kLongEdge = 1.4;
inline constexpr double kShortEdge = 0.7;

/// 4 sqrt(3) area / sum of squared sides: 1 for an equilateral triangle, 0 for a degenerate one; in the plane
/// negative where the triangle runs clockwise.
double triangle_quality(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        bool planar);

/// Quality of a triangle of the corner table.
double triangle_quality(const RemeshState& state, Index triangle);

/// Length of an edge over the mean of the target lengths at its ends.
double relative_length(const CornerTable& table, Index a, Index b);

/// A triangle may be there: in the plane its area is positive (exact), on a surface its normal is within 60
/// degrees of that of the surface.
/// @param state   of the mesh being changed
/// @param a       first corner of the new triangle
/// @param b       second corner
/// @param c       third corner
/// @param normal  surface_normal() of the triangle it replaces
bool may_replace(const RemeshState& state, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c, const Eigen::Vector3d& normal);

/// Unit normal of the input's surface under a triangle of the corner table: the mean of those under its
/// corners, but for the ones on features, which are between two; its own when all are. Not needed, and zero,
/// in the plane.
Eigen::Vector3d surface_normal(const RemeshState& state, Index triangle);

/// Normal of a triangle of the corner table, not scaled; not needed, and zero, in the plane.
Eigen::Vector3d triangle_normal(const RemeshState& state, Index triangle);

/// Parameters of the ends of a halfedge on its feature curve, in the direction of the halfedge; those of a
/// closed curve may lie beyond its end.
std::array<double, 2> edge_parameters(const RemeshState& state, Index h);

/// Smallest quality of the triangles around a vertex if it were elsewhere; -1 where one of them may not be.
double star_quality(const RemeshState& state, Index vertex, const Eigen::Vector3d& point);

/// Put a vertex at a point of the background mesh, or at parameter @p u of a feature curve, and give it the
/// target size there.
void put_at(const RemeshState& state, TableVertex& vertex, const Eigen::Vector3d& point);
void put_on_curve(const RemeshState& state, TableVertex& vertex, Index curve, double u);

} // namespace morph
