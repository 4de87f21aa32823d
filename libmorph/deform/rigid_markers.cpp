#include "libmorph/deform/rigid_markers.h"

#include "libmorph/core/error.h"

#include <complex>

namespace morph {

namespace {

/// Rows of the held vertices of a marker.
std::vector<Index> held_rows(const Mesh& mesh, const DirichletBoundary& held, const std::string& name)
{
    std::vector<Index> row(static_cast<std::size_t>(mesh.numbering.file_vertices), -1);
    const auto number = [&](Index v) {
        return static_cast<std::size_t>(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    };
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        row[number(held.vertices[i])] = static_cast<Index>(i);
    std::vector<Index> rows;
    for (const Index v : marker_vertices(marker(mesh, name))) {
        if (row[number(v)] < 0)
            throw InputError("marker '" + name +
                             "' is neither moved nor fixed, so it has no motion to take from its vertices");
        rows.push_back(row[number(v)]);
    }
    return rows;
}

/// Replace the displacement of these rows by the rigid one that fits it best.
void make_rigid(const Mesh& mesh, const DirichletBoundary& held, const std::vector<Index>& rows,
                Matrix& displacement)
{
    const auto place = [&](Index row) -> Eigen::RowVector2d {
        return points(mesh).row(held.vertices[static_cast<std::size_t>(row)]).head<2>();
    };
    Eigen::RowVector2d centre = Eigen::RowVector2d::Zero();
    Eigen::RowVector2d shift = Eigen::RowVector2d::Zero();
    for (const Index row : rows) {
        centre += place(row);
        shift += displacement.row(row);
    }
    centre /= static_cast<double>(rows.size());
    shift /= static_cast<double>(rows.size());
    std::complex<double> sum = 0;
    for (const Index row : rows) {
        const Eigen::RowVector2d before = place(row) - centre;
        const Eigen::RowVector2d after = before + displacement.row(row) - shift;
        sum += std::conj(std::complex<double>(before.x(), before.y())) *
               std::complex<double>(after.x(), after.y());
    }
    const std::complex<double> turn = std::polar(1.0, std::arg(sum));
    for (const Index row : rows) {
        const Eigen::RowVector2d arm = place(row) - centre;
        const std::complex<double> turned = turn * std::complex<double>(arm.x(), arm.y());
        displacement.row(row) << turned.real() - arm.x() + shift.x(), turned.imag() - arm.y() + shift.y();
    }
}

} // namespace

Matrix with_rigid_markers(const Mesh& mesh, const DirichletBoundary& held, Matrix displacement,
                          const std::vector<std::string>& markers)
{
    for (const std::string& name : markers)
        if (const std::vector<Index> rows = held_rows(mesh, held, name); !rows.empty())
            make_rigid(mesh, held, rows, displacement);
    return displacement;
}

} // namespace morph
