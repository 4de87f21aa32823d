#pragma once

#include "libmorph/basis/lattice.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace morph {

/// A part of one span of a lattice in Bernstein form: the bounds of LatticeTree come from its coefficients.
class LatticePiece {
public:
    /// @param span       of each direction
    /// @param low, high  parameters in the span
    LatticePiece(const Lattice& lattice, const std::array<int, 3>& span, const Eigen::Vector3d& low,
                 const Eigen::Vector3d& high);

    /// Holds the image.
    Eigen::AlignedBox3d box() const;

    /// Bound of ||J^-1 J(u) - I|| over the piece, largest sum of a row, the sides of the piece as units.
    ///
    /// It is a bound and not a guess: derivatives lie between the least and the greatest of their Bernstein
    /// coefficients.
    /// @param middle   S at a point of the piece
    /// @param inverse  J^-1 there, for the parameters of the lattice
    double variation(const Eigen::Vector3d& middle, const Eigen::Matrix3d& inverse) const;

    /// The Jacobians in its 2^d corners, for parameters with the sides of the piece as units.
    std::vector<Eigen::Matrix3d> corner_jacobians() const;

private:
    using Coefficient = Eigen::Vector4d; ///< (w x, w y, w z, w)

    void take_window(const Lattice& lattice, const std::array<int, 3>& span);
    template <typename Work>
    void along_lines(int direction, const Work& work);
    Eigen::Matrix3d corner_jacobian(const std::array<int, 3>& at) const;
    const Coefficient& coefficient(int i, int j, int k) const;

    int dimension_;
    std::array<int, 3> counts_{};
    Eigen::Vector3d sides_;
    std::vector<Coefficient> net_;
};

} // namespace morph
