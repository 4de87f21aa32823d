#include "tools/deform/gradient_file.h"

#include "formats/csv/table.h"
#include "formats/text/number_text.h"
#include "libmorph/core/error.h"

namespace morph::tools {

namespace {

/// Rows of the table by the file numbers of their vertices; -1: the table has none.
std::vector<Index> rows_by_vertex(const CsvTable& table, Index vertices)
{
    const Matrix ids = csv_columns(table, {"id"});
    std::vector<Index> row_of(static_cast<std::size_t>(vertices), -1);
    for (Eigen::Index row = 0; row < ids.rows(); ++row) {
        const std::string line =
            table.path + ":" + std::to_string(table.lines[static_cast<std::size_t>(row)]) + ": ";
        const double id = ids(row, 0);
        if (!(id >= 0 && id < vertices && id == static_cast<double>(static_cast<Index>(id))))
            throw InputError(line + "id must be a vertex, a whole number from 0 to " +
                             std::to_string(vertices - 1));
        Index& place = row_of[static_cast<std::size_t>(id)];
        if (place >= 0)
            throw InputError(line + "vertex " + std::to_string(static_cast<Index>(id)) +
                             " is there a second time; the first was in line " +
                             std::to_string(table.lines[static_cast<std::size_t>(place)]));
        place = static_cast<Index>(row);
    }
    return row_of;
}

} // namespace

Matrix read_vertex_gradient(const std::string& path, const Mesh& mesh)
{
    const CsvTable table = read_csv_table(path);
    std::vector<std::string> names{"dx", "dy"};
    if (mesh.dimension == 3)
        names.emplace_back("dz");
    const Matrix values = csv_columns(table, names);
    const std::vector<Index> row_of = rows_by_vertex(table, mesh.numbering.file_vertices);
    Matrix gradient = Matrix::Zero(vertex_count(mesh), values.cols());
    for (Index v = 0; v < mesh.numbering.file_vertices; ++v) // copies of split vertices come after these
        if (const Index row =
                row_of[static_cast<std::size_t>(mesh.numbering.vertex[static_cast<std::size_t>(v)])];
            row >= 0)
            gradient.row(v) = values.row(row);
    return gradient;
}

void write_control_point_gradient(OutputFile& out, const std::vector<ControlPoint>& columns,
                                  const Matrix& gradient, const std::array<Index, 3>& lattice_points)
{
    const bool lattice = lattice_points[0] > 0;
    const bool space = gradient.cols() == 3;
    out.append(std::string(lattice ? (space ? "i,j,k" : "i,j") : "boundary,i") + ",dx,dy" +
               (space ? ",dz" : "") + "\n");
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Index number = columns[k].number;
        if (lattice) {
            append_number(out, number % lattice_points[0]);
            out.append(",");
            append_number(out, number / lattice_points[0] % lattice_points[1]);
            if (space)
                out.append("," + std::to_string(number / lattice_points[0] / lattice_points[1]));
        } else {
            out.append(columns[k].boundary + "," + std::to_string(number + 1));
        }
        for (Eigen::Index c = 0; c < gradient.cols(); ++c) {
            out.append(",");
            append_number(out, gradient(static_cast<Eigen::Index>(k), c));
        }
        out.append("\n");
    }
}

} // namespace morph::tools
