#include "libmorph/remap/mixed_mass.h"

namespace morph {

namespace {

using Triangle = std::array<PlanePoint, 3>;

Triangle relative_to(PlanePoint origin, const ConvexPolygon& triangle)
{
    Triangle shifted;
    for (int k = 0; k < 3; ++k)
        shifted[static_cast<std::size_t>(k)] = {triangle[k].x - origin.x, triangle[k].y - origin.y};
    return shifted;
}

/// Twice the areas of the triangles that a point makes with each side, at the opposite corners.
Eigen::Vector3d areas_at(const Triangle& triangle, PlanePoint p)
{
    const auto& [a, b, c] = triangle;
    const auto area = [p](PlanePoint q, PlanePoint r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    return {area(b, c), area(c, a), area(a, b)};
}

/// The basis functions at a point of the triangle. They sum to 1 and lie in [0, 1] also in slivers, where
/// rounding can move the point beyond a side.
Eigen::Vector3d basis_inside(const Triangle& triangle, PlanePoint p)
{
    const Eigen::Vector3d areas = areas_at(triangle, p).cwiseMax(0);
    const double sum = areas.sum();
    return sum > 0 ? (areas / sum).eval() : Eigen::Vector3d::Constant(1.0 / 3);
}

/// The basis functions at a point anywhere; they sum to 1.
Eigen::Vector3d basis_beyond(const Triangle& triangle, double area, PlanePoint p)
{
    const Eigen::Vector3d values = areas_at(triangle, p) / (2 * area);
    return {1 - values[1] - values[2], values[1], values[2]};
}

double triangle_area(PlanePoint a, PlanePoint b, PlanePoint c)
{
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

} // namespace

MixedMass mixed_mass(const ConvexPart& target, const Overlap& overlap)
{
    const Triangle target_triangle = relative_to(overlap.origin, target.outline);
    const Triangle source_triangle = relative_to(overlap.origin, overlap.source.outline);
    const ConvexPolygon& common = overlap.common;
    std::array<Eigen::Vector3d, ConvexPolygon::kMaxCorners> phi, psi;
    for (std::size_t k = 0; k < static_cast<std::size_t>(common.corners); ++k) {
        phi[k] = basis_inside(target_triangle, common.corner[k]);
        psi[k] = basis_inside(source_triangle, common.corner[k]);
    }
    MixedMass mass;
    for (std::size_t k = 2; k < static_cast<std::size_t>(common.corners); ++k) {
        const std::array<std::size_t, 3> corner{0, k - 1, k};
        const double weight = triangle_area(common.corner[0], common.corner[k - 1], common.corner[k]) / 3;
        for (std::size_t side = 0; side < 3; ++side) {
            const std::size_t a = corner[side], b = corner[(side + 1) % 3];
            const Eigen::Vector3d phi_middle = (phi[a] + phi[b]) / 2, psi_middle = (psi[a] + psi[b]) / 2;
            mass.own += weight * phi_middle * phi_middle.transpose();
            mass.mixed += weight * phi_middle * psi_middle.transpose();
        }
    }
    return mass;
}

MixedMass lumped_mixed_mass(const ConvexPart& target, const Overlap& overlap)
{
    const Triangle target_triangle = relative_to(overlap.origin, target.outline);
    const Triangle source_triangle = relative_to(overlap.origin, overlap.source.outline);
    const Eigen::Vector3d integrals = mixed_mass(target, overlap).own.rowwise().sum();
    MixedMass mass;
    mass.own.diagonal() = integrals;
    for (int i = 0; i < 3; ++i)
        mass.mixed.row(i) = integrals[i] * basis_beyond(source_triangle, overlap.source.area,
                                                        target_triangle[static_cast<std::size_t>(i)])
                                               .transpose();
    return mass;
}

} // namespace morph
