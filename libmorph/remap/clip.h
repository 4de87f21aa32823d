#pragma once

#include "libmorph/geometry/plane_element.h"

#include <array>
#include <span>

namespace morph {

/// A convex polygon of few corners, counter-clockwise.
class ConvexPolygon {
public:
    /// What two quads can have in common has at most eight corners; rounding may double some of them.
    static constexpr std::size_t kMostCorners = 16;

    void add(PlanePoint p)
    {
        if (size_ < kMostCorners)
            corners_[size_++] = p;
    }
    void clear() { size_ = 0; }
    std::span<const PlanePoint> corners() const { return {corners_.data(), size_}; }

private:
    std::array<PlanePoint, kMostCorners> corners_;
    std::size_t size_ = 0;
};

/// The area of a polygon, positive when it runs counter-clockwise; length unit squared.
double area(const ConvexPolygon& polygon);

/// What two convex polygons have in common [Sutherland & Hodgman 1974, Communications of the ACM 17(1),
/// 32-42]. Empty, or without area, when they only touch or are apart. Exact but for the rounding of the new
/// corners.
ConvexPolygon intersection(const ConvexPolygon& one, const ConvexPolygon& other);

/// Into which convex parts elements are cut.
enum class Parts {
    convex,    ///< one for a triangle or a convex quad, else two triangles
    triangles, ///< always triangles: quads along the diagonal 1-3, or the inner one where they are not convex
};

/// A part of an element: its corners as numbers of the element's, counter-clockwise by their coordinates, and
/// where they lie relative to some origin.
struct ElementPart {
    std::array<int, 4> corner{};
    int corners = 0;
    ConvexPolygon polygon;
};

/// The parts of an element; parts without area are left out.
struct ElementParts {
    std::array<ElementPart, 2> part;
    int count = 0;
};
ElementParts parts_of(const PlaneElement& element, PlanePoint origin, Parts parts);

} // namespace morph
