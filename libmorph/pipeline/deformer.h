#pragma once

#include "libmorph/pipeline/lattice_placement.h"
#include "libmorph/pipeline/move_result.h"
#include "libmorph/pipeline/settings.h"
#include "libmorph/weights/weights_view.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace morph {

/// A mesh that is ready to be moved by its control points, as often as one likes: curves are on their markers,
/// vertices in their lattice, systems factored and weights solved for. The mesh itself is never changed, and a
/// move does not depend on those before it.
///
///     Deformer deformer(mesh, {.curves = {{.marker = "airfoil", .curve = curve, .displacements = D}}});
///     MoveResult moved = deformer.move();
///     points(mesh) = moved.positions; // when the deformer is needed no more
///
/// Equal bytes for any number of threads.
class Deformer {
public:
    /// @param mesh      undeformed, n vertices; it is kept by reference: it must outlive the deformer and stay as
    ///                  it is
    /// @param settings  what moves and how
    /// @param weights   n x K, rows as the vertices of @p mesh, to be used instead of solving for them; the rows
    ///                  of boundary nodes are set so that these land on their curves
    /// @throws InputError   names the entry that cannot be, or that does not go with the mesh
    /// @throws SolverError  as the method
    Deformer(const Mesh& mesh, MotionSettings settings, std::optional<Weights> weights = std::nullopt);
    ~Deformer();
    Deformer(Deformer&&) noexcept;
    Deformer& operator=(Deformer&&) noexcept;

    const Mesh& mesh() const;
    const MotionSettings& settings() const;
    const std::vector<CurveBoundary>& boundaries() const;    ///< one for each curve
    const PlacedLattice* lattice() const;                    ///< null without one
    const std::vector<ControlPoint>& control_points() const; ///< K
    const Matrix& displacements() const; ///< K x d as the settings have them, d = 2 or, on surfaces, 3

    /// Control points that must keep their displacement, ascending.
    std::vector<Index> held() const;

    /// What a person should know before trusting the result.
    const std::vector<std::string>& warnings() const;

    /// Whether the vertices move in proportion to the displacements.
    bool is_linear() const;

    /// New positions = old positions + weights * displacements; none where the move is not linear.
    std::optional<WeightsView> weights() const;

    /// Of the weights, where the move is not linear of those of the boundary.
    WeightsCheck weights_check() const;

    /// Memory of the weights in bytes.
    std::size_t weights_bytes() const;

    /// Derivatives of an objective by the control points from those by the vertices.
    /// @param dJdX  n x d, rows as the vertices of the mesh
    /// @return K x d
    /// @throws InputError  the move is not linear; the sizes do not fit
    Matrix gradient(const Matrix& dJdX) const;

    /// Fit a lattice to the moved curves, then reach the pulls, then the constraints, each by the least change
    /// of the displacements.
    /// @param displacements  K x d, changed in place
    /// @throws InputError, SolverError  names the entry; as satisfy_constraints()
    ControlOutcome satisfy(Matrix& displacements) const;

    /// Move by the displacements of the settings after satisfy(), then check and repair as the guard says.
    /// @throws InputError, SolverError  as satisfy() and move_points()
    MoveResult move() const;

    /// The same for other displacements, which are used as they are.
    /// @param displacements  K x d, length unit of the mesh
    MoveResult move(const Matrix& displacements) const;

    /// The move alone, without checks.
    /// @param displacements  K x d, length unit of the mesh
    /// @param positions      n x 3, points(mesh()) before, moved in place
    /// @return the number of steps taken
    /// @throws InputError   the sizes do not fit; ends of curves that meet are moved apart
    /// @throws SolverError  as the method
    int move_points(const Matrix& displacements, Eigen::Map<Points> positions) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

} // namespace morph
