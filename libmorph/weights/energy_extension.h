#pragma once

#include "libmorph/numerics/assembly.h"
#include "libmorph/numerics/dirichlet_system.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <array>
#include <functional>

namespace morph {

/// Corners of an element, counter-clockwise.
struct ElementPoints {
    Index element = 0;
    int corners = 3; ///< 3 or 4
    std::array<Eigen::Vector2d, 4> at{};

    const Eigen::Vector2d& next(int corner) const
    {
        return at[static_cast<std::size_t>((corner + 1) % corners)];
    }
    const Eigen::Vector2d& previous(int corner) const
    {
        return at[static_cast<std::size_t>((corner + corners - 1) % corners)];
    }
};

/// The displacement that needs the least of an energy which is the sum of one for each element: springs,
/// elasticity.
class EnergyExtension final : public BoundaryExtension {
public:
    /// Sets the matrix Q of an element, 2 x corners rows and zero before: its energy is u^T Q u / 2 with u
    /// the displacement x, y of each corner in order. Called from several threads; may throw.
    using Energy = std::function<void(const ElementPoints& element, ElementMatrix& matrix)>;

    /// @throws InputError   as UniqueDirichletVertices and DirichletSystem, and what @p energy throws
    /// @throws SolverError  the system is singular
    EnergyExtension(const DomainView& domain, const DirichletBoundary& boundary, const Energy& energy);

private:
    Matrix solve(const Matrix& joined) const override { return system_.solve(joined); }

    DirichletSystem system_;
};

} // namespace morph
