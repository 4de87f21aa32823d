#pragma once

#include "formats/csv/table.h"
#include "formats/output_file.h"
#include "libmorph/mesh/mesh_data.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// The nodal fields of a table whose rows are the vertices of a mesh.
struct CsvNodes {
    std::optional<Points> points; ///< from the columns x, y and, if there is one, z
    std::vector<Field> fields;
    std::vector<int> lines; ///< of each vertex in the file, from 1
    bool has_ids = false;   ///< there is a column PointID, and it ordered the rows
};

/// Sort out the columns of a table and bring its rows into the order of PointID, if it has that column.
///
/// Columns x, y, z and PointID, letter case aside, are no fields (z is one where there are no x and y).
/// Columns v_0, v_1, … that follow one another, 2 to 9 of them, are the components of one field v, unless
/// there is a column v as well.
/// @throws InputError  "path:line: …": PointID are not the numbers from 0, each once; only one of x and y is
///                     there; a column has no name
CsvNodes csv_nodes(const CsvTable& table);

/// A mesh of points without elements, with nodal fields; planar where z is 0 throughout.
/// @throws InputError  as csv_nodes(), or there are no columns x and y
MeshData csv_mesh(const CsvTable& table);

/// Write x, y, in space also z, and the nodal fields of a mesh, the points in order.
///
/// Numbers are the shortest texts that read back as the same bits.
/// @param as_restart  as SU2 has it: a column PointID in front, every name in quotes
/// @throws InputError  two columns would have the same name, or a field's name is empty or has a line end
void write_csv_nodes(const MeshData& mesh, bool as_restart, OutputFile& out);

} // namespace morph
