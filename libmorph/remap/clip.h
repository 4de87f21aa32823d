#pragma once

#include "libmorph/core/predicates.h"

#include <array>

namespace morph {

/// The number of a side that none is asked for.
inline constexpr int kNoSide = -1;

/// A convex polygon of at most 8 corners, counter-clockwise. Each side keeps a number of the caller's when
/// the polygon is clipped.
struct ConvexPolygon {
    static constexpr int kMaxCorners = 8;

    std::array<PlanePoint, kMaxCorners> corner;
    std::array<int, kMaxCorners> side; ///< of the side from each corner to the next
    int corners = 0;                   ///< 0: empty

    PlanePoint operator[](int k) const { return corner[static_cast<std::size_t>(k)]; }
    /// The corner after corner @p k.
    PlanePoint after(int k) const { return (*this)[k + 1 < corners ? k + 1 : 0]; }
    void add(PlanePoint p, int side_number);
};

/// What two convex polygons have in common [Sutherland & Hodgman 1974, Communications of the ACM 17(1),
/// 32-42].
///
/// Its corners are relative to the first corner of @p subject, so that a polygon far from the origin loses no
/// digits; its sides have the numbers of those they lie on, the subject's where two coincide. Polygons that
/// only touch have nothing in common. Corners are right to rounding, about 1e-16 of the larger polygon, and
/// two clippers that share a side split a subject without gap or overlap; so the smaller polygon is best the
/// subject.
///
/// @param subject,clipper  at most 4 corners each; the subject may be degenerate
ConvexPolygon clip(const ConvexPolygon& subject, const ConvexPolygon& clipper);

/// Signed area; positive for a polygon that is not degenerate.
double area(const ConvexPolygon& polygon);

} // namespace morph
