#pragma once

#include "libmorph/core/names.h"
#include "libmorph/geometry/plane_element.h"

#include <Eigen/Core>

#include <array>

namespace morph {

/// How values vary inside a quad.
enum class QuadRule {
    bilinear, ///< by the inverse of the bilinear map: smooth inside, the same from both sides of a side
    split,    ///< linear in each of the triangles 1 2 3 and 1 3 4, as in the thesis (4.2)
};

template <>
inline constexpr auto kEnumNames<QuadRule> = std::to_array<EnumName<QuadRule>>({
    {QuadRule::bilinear, "bilinear"},
    {QuadRule::split, "split"},
});

/// Barycentric coordinates of @p p in triangle a b c: they sum to 1, and the corners weighted by them give
/// the point, both to rounding also in slivers, whose single coordinates rounding may move by more. Outside
/// of the triangle some are negative. Without area, they are those along a side.
std::array<double, 3> barycentric(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint p);

/// Weights of the corners of an element at a point in it; the fourth of a triangle is 0.
///
/// They sum to 1, and the corners weighted by them give the point; both to rounding also in slivers, whose
/// single weights rounding may move by more, even slightly below 0. At a corner they are 1 and 0, exactly.
/// Triangle: barycentric coordinates. Quad: as @p rule says; one that is not convex is always its two
/// triangles along the inner diagonal, because its bilinear map folds.
///
/// @param element  with 3 or 4 corners
/// @param p        in the element or on its sides
/// @param rule     how quads are interpolated
std::array<double, 4> corner_weights(const PlaneElement& element, PlanePoint p, QuadRule rule);

/// The same for an element in space, seen along the coordinate axis nearest to its normal.
///
/// @param corner   the fourth of a triangle is not looked at
/// @param corners  3 or 4
/// @param p        on the element, to rounding
/// @param rule     how quads are interpolated
std::array<double, 4> corner_weights(const std::array<Eigen::Vector3d, 4>& corner, int corners,
                                     const Eigen::Vector3d& p, QuadRule rule);

} // namespace morph
