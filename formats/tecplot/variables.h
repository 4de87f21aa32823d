#pragma once

#include "formats/format.h"
#include "formats/tecplot/nodes.h"

namespace morph {

/// The variables called x, y and z ("X", "x [m]", "CoordinateX", "x_coord"), or the first two.
TecplotCoordinates tecplot_coordinates(const std::vector<std::string>& variables);

/// True for a name that tecplot_coordinates() takes for that axis (0, 1, 2).
bool is_tecplot_coordinate(const std::string& name, int axis);

/// The other variables as fields of the vertices and elements of the chosen zones.
/// @throws InputError  a variable is at nodes in one zone and at cells in another
std::vector<Field> tecplot_fields(const TecplotFile& file, const std::vector<std::size_t>& zones,
                                  const TecplotNodes& nodes, const TecplotCoordinates& xyz,
                                  const InputBytes& input);

} // namespace morph
