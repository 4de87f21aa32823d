#pragma once

#include <Eigen/Core>

namespace morph {

/// Whether three points of space lie on one line (or coincide), exact.
bool on_one_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Exact sign of a corner Jacobian of a quad in space against the quad's own mean normal, that of
/// ((next - corner) x (previous - corner)) . ((opposite - corner) x (previous - next)).
int quad_corner_sign(const Eigen::Vector3d& corner, const Eigen::Vector3d& next,
                     const Eigen::Vector3d& opposite, const Eigen::Vector3d& previous);

} // namespace morph
