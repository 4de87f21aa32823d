#include "libmorph/core/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <cmath>

namespace morph {

namespace {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Bounds on the relative rounding error of the two determinants below [Shewchuk 1997, Discrete &
// Computational Geometry 18(3), 305-363: ccwerrboundA and iccerrboundA].
constexpr double kUnit = 0x1p-53;
constexpr double kOrientationError = (3 + 16 * kUnit) * kUnit;
constexpr double kCircleError = (10 + 96 * kUnit) * kUnit;

// Far above what a product below the normal range can lose, which those bounds leave out.
constexpr double kUnderflow = 1e-290;

ExactKernel::Point_2 exact(PlanePoint p)
{
    return {p.x, p.y};
}

} // namespace

int orientation(PlanePoint a, PlanePoint b, PlanePoint c)
{
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double det = left - right;
    if (std::abs(det) > kOrientationError * (std::abs(left) + std::abs(right)) + kUnderflow)
        return det > 0 ? 1 : -1;
    return CGAL::orientation(exact(a), exact(b), exact(c));
}

int cross_sign(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
{
    const double left = (b.x - a.x) * (d.y - c.y);
    const double right = (b.y - a.y) * (d.x - c.x);
    const double det = left - right;
    if (std::abs(det) > kOrientationError * (std::abs(left) + std::abs(right)) + kUnderflow)
        return det > 0 ? 1 : -1;
    using Exact = CGAL::Exact_rational;
    return CGAL::compare((Exact(b.x) - Exact(a.x)) * (Exact(d.y) - Exact(c.y)),
                         (Exact(b.y) - Exact(a.y)) * (Exact(d.x) - Exact(c.x)));
}

int in_circle(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
{
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;
    const double a2 = ax * ax + ay * ay;
    const double b2 = bx * bx + by * by;
    const double c2 = cx * cx + cy * cy;
    const double bxcy = bx * cy, cxby = cx * by;
    const double cxay = cx * ay, axcy = ax * cy;
    const double axby = ax * by, bxay = bx * ay;
    const double det = a2 * (bxcy - cxby) + b2 * (cxay - axcy) + c2 * (axby - bxay);
    const double size = a2 * (std::abs(bxcy) + std::abs(cxby)) + b2 * (std::abs(cxay) + std::abs(axcy)) +
                        c2 * (std::abs(axby) + std::abs(bxay));
    if (std::abs(det) > kCircleError * size + kUnderflow)
        return det > 0 ? 1 : -1;
    return CGAL::side_of_oriented_circle(exact(a), exact(b), exact(c), exact(d));
}

} // namespace morph
