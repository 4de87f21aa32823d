#pragma once

#include "formats/binary/number_array.h"
#include "formats/vtk/names.h"
#include "libmorph/mesh/mesh_data.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace morph {

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

/// Poly data list lines before polygons; in an unstructured grid the elements keep the front.
enum class VtkOrder { elements_first, lines_first };

/// A list of cells: the corners of each, one after another, and where they end.
struct VtkCellList {
    VtkArray corners, ends;
};

/// The arrays of a file that holds @p mesh as described at VtkGrid. The line cells carry in each
/// element field the values of an element next to them: a padding value such as 0 would stretch the
/// colour range of the field, and NaN cannot be read from ASCII files by VTK.
struct VtkOutput {
    VtkArray points;
    VtkCellList cells;           ///< elements first
    VtkCellList elements, lines; ///< the same, each alone
    VtkArray types;              ///< of cells
    std::vector<VtkArray> point_data, cell_data;
    std::vector<VtkNames> names; ///< of markers and groups, as far as there are any
};

VtkOutput vtk_output(const MeshData& mesh, VtkOrder order);

/// The 4-byte integers "corner count, corners" of every cell, as legacy files want them.
std::vector<std::int32_t> counted_corners(const MeshData& mesh);

} // namespace morph
