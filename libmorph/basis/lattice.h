#pragma once

#include "libmorph/basis/spline_axis.h"
#include "libmorph/core/names.h"
#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace morph {

enum class LatticeBasis {
    bspline,   ///< clamped B-splines [Griessmair & Purgathofer 1989, Eurographics, 137-148]
    bernstein, ///< degree = points - 1 [Sederberg & Parry 1986, SIGGRAPH 20(4), 151-160]
};

template <>
inline constexpr auto kEnumNames<LatticeBasis> = std::to_array<EnumName<LatticeBasis>>({
    {LatticeBasis::bspline, "bspline"},
    {LatticeBasis::bernstein, "bernstein"},
});

/// What a lattice of free-form deformation is made from. Directions i, j, k go with the parameters u, v, w;
/// in the plane k has one control point and degree 0.
struct LatticeDefinition {
    int dimension = 3; ///< 2: a planar lattice, x and y count · 3
    LatticeBasis basis = LatticeBasis::bspline;
    std::array<int, 3> degree = {3, 3, 3};
    std::array<Index, 3> points = {4, 4, 4}; ///< control points along i, j, k

    /// Along i, j, k, B-splines only: the clamped vector of points + degree + 1 values; empty: uniform.
    std::array<std::vector<double>, 3> knots = {};

    Points control_points =
        {}; ///< N x 3, length unit of the mesh; (i, j, k) is row i + points[0] (j + points[1] k)
    std::vector<double> weights = {}; ///< N positive values, ordered alike (rational); empty: all 1
};

/// The basis functions that are not zero at a point of a lattice.
struct LatticeRow {
    std::vector<Index> control; ///< rows of the control points, ascending
    std::vector<double> value;  ///< in [0, 1], sum 1
};

/// A lattice of free-form deformation: the map S(u, v, w) = sum R_ijk(u, v, w) P_ijk from the unit square or
/// cube, tensor products of B-splines or Bernstein polynomials, rational when there are weights
/// [Lamousin & Waggenspack 1994, IEEE Computer Graphics and Applications 14(6), 59-65].
class Lattice {
public:
    /// @throws InputError  says along which direction: a dimension other than 2 and 3; a degree less than 1,
    ///                     above 7 (B-splines) or 31 (Bernstein polynomials); not more control points than
    ///                     the degree, or not one more (Bernstein), or over 1e7 in all; knots as Curve
    ///                     refuses them; control points or weights of the wrong number, not finite, weights
    ///                     not positive; control points that enclose no volume (in the plane: no area)
    explicit Lattice(LatticeDefinition definition);

    const LatticeDefinition& definition() const { return definition_; }
    int dimension() const { return definition_.dimension; }
    bool rational() const { return !definition_.weights.empty(); }
    Index control_point_count() const { return static_cast<Index>(definition_.control_points.rows()); }

    /// Direction 0, 1 or 2: i, j or k.
    const SplineAxis& axis(int direction) const { return axes_[static_cast<std::size_t>(direction)]; }

    /// Row of the control point (i, j, k).
    Index row_of(Index i, Index j, Index k) const
    {
        return i + definition_.points[0] * (j + definition_.points[1] * k);
    }

    /// The (i, j, k) of a row.
    std::array<Index, 3> indices_of(Index row) const;

    /// Diagonal of the bounding box of the control points, which holds the image: the scale of tolerances.
    double size() const { return size_; }

    /// Basis functions at @p u, each component clamped to [0, 1].
    LatticeRow basis(const Eigen::Vector3d& u) const;

    /// S at @p u, each component clamped to [0, 1]; z = 0 in the plane.
    Eigen::Vector3d point(const Eigen::Vector3d& u) const;

    /// Columns dS/du, dS/dv, dS/dw at @p u. In the plane the third is (0, 0, 1), so that the determinant is
    /// the ratio of areas. Where S is not smooth: that from the right, at 1 from the left.
    Eigen::Matrix3d jacobian(const Eigen::Vector3d& u) const;

    /// The same lattice with other control points or weights (empty: all 1).
    /// @throws InputError  as the constructor
    Lattice with_control_points(const Points& control_points) const;
    Lattice with_weights(const std::vector<double>& weights) const;

private:
    LatticeDefinition definition_;
    std::array<SplineAxis, 3> axes_;
    double size_ = 0;
};

/// A lattice in a box along the axes.
///
/// The control points lie at the Greville abscissae, so that without weights S is affine: (0, 0, 0) goes to
/// @p low and (1, 1, 1) to @p high.
/// @param low    corner of least coordinates
/// @param high   opposite corner
/// @param shape  everything but the control points
/// @throws InputError  as the constructor; a box without volume (in the plane: without area)
Lattice lattice_in_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, LatticeDefinition shape);

/// The same in a box turned or sheared at will.
/// @param origin  corner of the box
/// @param axes    columns: the sides of the box from @p origin along i, j, k; in the plane the third is not
/// used
/// @param shape   its control points are replaced
Lattice lattice_on_axes(const Eigen::Vector3d& origin, const Eigen::Matrix3d& axes, LatticeDefinition shape);

} // namespace morph
