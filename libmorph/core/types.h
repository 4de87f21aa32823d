#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace morph {

/// 0-based number of a vertex, element or control point = row in every matrix that speaks of it.
using Index = std::int32_t;

/// One row per point: x, y, z in the length unit of the mesh. Planar meshes have z = 0.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Positions of the vertices of a mesh, n x 3: the mesh's own, or where they are to go.
using PositionsView = Eigen::Ref<const Points>;

/// Dense real matrix, rows contiguous, so that what belongs to one vertex lies together.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Control points of planar curves: one row x, y each.
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

} // namespace morph
