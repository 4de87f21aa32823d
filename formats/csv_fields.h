#pragma once

#include "formats/csv_table.h"
#include "formats/output_file.h"
#include "libmorph/mesh/mesh_data.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// The nodal fields of a table whose rows are the vertices of a mesh.
///
/// Columns x, y, z and PointID are no fields. Columns v_0, v_1, ... that follow one another are the
/// components of one field v (at most 9).
struct CsvNodes {
    std::optional<Points> points; ///< from the columns x, y and, if there is one, z
    std::vector<Field> fields;
    std::vector<int> lines; ///< of each vertex in the file, from 1
    bool has_ids = false;   ///< there is a column PointID, and it ordered the rows
};

/// Sort out the columns of a table and bring its rows into the order of PointID, if it has that column.
/// @throws InputError  PointID are not the numbers from 0, each once; only one of x and y is there
CsvNodes csv_nodes(const CsvTable& table);

/// A mesh of points without elements, with nodal fields.
/// @throws InputError  as above, or there are no columns x and y
MeshData mesh_of(CsvNodes nodes, const std::string& path);

/// Write x, y, in space also z, and the nodal fields of a mesh, the points in order.
///
/// Numbers are the shortest texts that read back as the same bits.
/// @param as_restart  as SU2 has it: a column PointID in front, every name in quotes
void write_csv_nodes(const MeshData& mesh, bool as_restart, OutputFile& out);

} // namespace morph
