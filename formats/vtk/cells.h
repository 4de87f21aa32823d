#pragma once

#include "formats/format.h"
#include "formats/vtk/names.h"

#include <cstdint>
#include <vector>

namespace morph {

/// A grid as VTK's files hold it: cells of any type, fields with a row for every cell.
///
/// Markers travel as line cells next to the elements, numbered and named as VtkNames says, so that ParaView
/// shows and selects them.
struct VtkGrid {
    Points points;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> ends; ///< cell c has the corners from ends[c-1] (0 for the first) up to ends[c]
    std::vector<Index> corners;     ///< -1 for what is no Index
    std::vector<Field> fields;
    VtkNames markers, groups;

    std::int64_t begin_of(std::size_t cell) const { return cell == 0 ? 0 : ends[cell - 1]; }
    Index corner(std::int64_t position) const { return corners[static_cast<std::size_t>(position)]; }
};

/// Keep the strings of the field data called @p array if they name markers or groups.
void use_names(VtkGrid& grid, const std::string& array, std::vector<std::string> names);

/// Triangles and quads (pixels, strips, and polygons of 3 or 4 corners too) as elements, lines and polylines
/// as markers, single points dropped; of tetrahedra, pyramids, wedges, hexahedra and voxels the boundary, as
/// surface_of() says. Lines of a file that names no markers are distinguished by the numbers that mesh
/// generators leave in a cell array (`CellEntityIds`, `gmsh:physical`, `marker`, …), else they are one
/// marker `lines`. The mesh is planar when z = 0 throughout.
/// @throws InputError  "path: …": a cell of another type, corners out of range or of the wrong number,
///                     a coordinate that is not finite, a number without a name
MeshData mesh_from_vtk(VtkGrid grid, const InputBytes& file);

/// The polylines @p lines of the grid as markers; an array that only numbers them is taken out of its fields.
std::vector<Marker> take_markers(VtkGrid& grid, const std::vector<std::size_t>& lines,
                                 const std::string& path);

/// The groups that the grid names, by @p element_cells, the cell of each element; the arrays that number them
/// are taken out of its fields.
std::vector<ElementGroup> take_groups(VtkGrid& grid, const std::vector<Index>& element_cells,
                                      const std::string& path);

} // namespace morph
