#pragma once

#include "formats/vtk/cells.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace morph {

/// Points along each axis of a grid of VTK; those of x follow each other.
using GridSize = std::array<std::size_t, 3>;

/// Points of a grid in all.
/// @throws InputError  more than fit an Index, or than the machine has memory for
std::size_t point_count(const GridSize& size, const std::string& path);

/// Append the cells of a grid with that many points, as point_count() found them to fit: quads where one axis
/// has one point (counter-clockwise about that axis), hexahedra where none has, lines where two have.
void add_structured_cells(VtkGrid& grid, const GridSize& size);

/// The points with every combination of the coordinates on three axes.
Points rectilinear_points(const std::array<std::vector<double>, 3>& axes);

} // namespace morph
