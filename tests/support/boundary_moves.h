#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace morph::test {

/// Hold the whole boundary of a mesh; the named markers move.
DirichletBoundary dirichlet_boundary(const Mesh& mesh, const std::vector<std::string>& moving);

/// For every held vertex whether it is the end of a moving edge, by file number.
std::vector<bool> is_moving(const Mesh& mesh, const DirichletBoundary& held);

/// A displacement of the plane.
using Move = std::function<Eigen::RowVector2d(double x, double y)>;

/// The turn by an angle (degrees, counter-clockwise) about a point.
Move turn(double degrees, std::array<double, 2> centre);

/// k x 2: @p move at the held vertices that move, 0 at the others.
Matrix boundary_displacement(const Mesh& mesh, const DirichletBoundary& held, const Move& move);

/// n x 2: @p move at every vertex.
Matrix displacement_everywhere(const Mesh& mesh, const Move& move);

/// How many elements are inverted once the mesh is displaced (n x 2).
Index inverted_after(const Mesh& mesh, const Matrix& displacement);

/// Largest difference of two matrices, NaN if there is one.
double difference(const Matrix& a, const Matrix& b);

/// An airfoil in a farfield: a file of tests/data/meshes and the marker of its body.
struct AirfoilMesh {
    const char* file;
    const char* body;
};

inline constexpr AirfoilMesh kAirfoilMeshes[] = {
    {"naca0012_inv.su2", "airfoil"}, {"naca0012_lam_hybrid.su2", "airfoil"}, {"rae2822_turb.su2", "AIRFOIL"}};

} // namespace morph::test
