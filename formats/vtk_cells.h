#pragma once

#include "formats/vtk_numbers.h"
#include "libmorph/mesh/mesh_data.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace morph {

/// An unstructured grid as VTK's files hold it: cells of any type, fields with a row for every cell.
///
/// Markers travel as line cells behind the elements. The cell array `marker` numbers them from 1 (0:
/// an element) and the field data `marker_names` names them, so that ParaView shows and selects them.
/// When a field is called `marker` already, both names start with `marker_`, `marker__` and so on.
struct VtkGrid {
    Points points;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> ends; ///< cell c has the corners from ends[c-1] (0 for the first) up to ends[c]
    std::vector<Index> corners;     ///< -1 for what is no Index
    std::vector<Field> fields;

    std::string marker_array; ///< element field that numbers the markers; empty: the file names no markers
    std::vector<std::string> marker_names;
};

/// Triangles and quads (pixels and polygons of 3 or 4 corners too) as elements, lines and polylines as
/// markers, single points dropped. Lines of a file that names no markers are told apart by the numbers
/// that mesh generators leave in a cell array (`CellEntityIds`, `gmsh:physical`, `marker`, …), else
/// they are one marker `lines`. The mesh is planar when z = 0 throughout.
/// @throws InputError  "path: …": a cell of another type, corners out of range or of the wrong number,
///                     a coordinate that is not finite
MeshData mesh_from_vtk(VtkGrid grid, const std::string& path);

/// Names of the field-data array that names the markers of the cell array @p marker_array, and back:
/// empty when @p names_array is no such name.
std::string marker_names_array(const std::string& marker_array);
std::string marker_array_of(const std::string& names_array);

/// Takes the numbers of one array, possibly in several pieces.
using NumberSink = std::function<void(const NumberArray&)>;

/// One array on its way into a file. It refers to the mesh it was made from.
struct VtkArray {
    std::string name;
    NumberType type;
    std::size_t rows;
    std::size_t components;
    std::function<void(const NumberSink&)> numbers;
};

/// The arrays of a file that holds @p mesh as described at VtkGrid. The line cells carry in each
/// element field the values of an element beside them: a padding value such as 0 would stretch the
/// colour range of the field, and NaN cannot be read from ASCII files by VTK.
struct VtkOutput {
    VtkArray points, corners, ends, types;
    std::vector<VtkArray> point_data, cell_data;
    std::string marker_array; ///< empty: the mesh has no markers
};

VtkOutput vtk_output(const MeshData& mesh);

/// The 4-byte integers "corner count, corners" of every cell, as legacy files want them.
std::vector<std::int32_t> counted_corners(const MeshData& mesh);

} // namespace morph
