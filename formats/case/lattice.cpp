#include "tools/case/lattice_entry.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cstdint>

namespace morph::tools {

namespace {

constexpr Index kMostPoints = 1000;                 // along one side
constexpr std::int64_t kMostControlPoints = 100000; // in all: more is a slip

const std::vector<std::string> kKeys{"basis",         "degree",         "points",     "knots_i",
                                     "knots_j",       "knots_k",        "box",        "origin",
                                     "axes",          "control_points", "su2_box",    "weights",
                                     "moved_weights", "displacements",  "continuity", "markers"};

std::vector<std::string> first(const std::vector<std::string>& names, int count)
{
    return {names.begin(), names.begin() + count};
}

/// Whole numbers, one for each dimension.
template <typename Number>
void take_counts(const TomlTable& table, const std::string& key, int dimension, Number least, Number most,
                 std::array<Number, 3>& counts)
{
    const auto values = table.numbers(key);
    if (!values)
        return;
    if (values->size() != static_cast<std::size_t>(dimension))
        table.fail(table.line(key), "[lattice] " + key + " has " + std::to_string(values->size()) +
                                        " numbers, but points has " + std::to_string(dimension));
    for (std::size_t axis = 0; axis < values->size(); ++axis) {
        const double value = (*values)[axis];
        if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
              value == static_cast<double>(static_cast<Number>(value))))
            table.fail(table.line(key), "[lattice] " + key + " must be whole numbers from " +
                                            std::to_string(least) + " to " + std::to_string(most));
        counts[axis] = static_cast<Number>(value);
    }
}

int dimension_of(const TomlTable& table)
{
    const auto points = table.numbers("points");
    if (!points)
        return 0;
    if (points->size() != 2 && points->size() != 3)
        table.fail(table.line("points"),
                   "[lattice] points must be [n, m] for planar meshes or [n, m, l] for surfaces");
    return static_cast<int>(points->size());
}

/// Rows of 2 or 3 numbers as rows of x, y, z.
Matrix in_space(const Matrix& rows)
{
    Matrix full = Matrix::Zero(rows.rows(), 3);
    full.leftCols(rows.cols()) = rows;
    return full;
}

void take_place(const TomlTable& table, LatticeEntry& entry)
{
    const int given = static_cast<int>(table.has("box")) + static_cast<int>(table.has("axes")) +
                      static_cast<int>(table.has("control_points")) + static_cast<int>(table.has("su2_box"));
    if (given != 1)
        table.fail(table.line(), "[lattice] needs one of box, origin with axes, control_points, su2_box");
    if (const auto box = table.numbers("box")) {
        if (box->size() != static_cast<std::size_t>(2 * entry.dimension))
            table.fail(table.line("box"), entry.dimension == 2
                                              ? "[lattice] box must be [xmin, ymin, xmax, ymax]"
                                              : "[lattice] box must be [xmin, ymin, zmin, xmax, ymax, zmax]");
        entry.corners = in_space(Eigen::Map<const Matrix>(box->data(), 2, entry.dimension));
    }
    const auto names = first({"x", "y", "z"}, entry.dimension);
    if (const auto axes = table.rows("axes", names)) {
        const auto origin = table.numbers("origin");
        if (!origin || origin->size() != static_cast<std::size_t>(entry.dimension))
            table.fail(table.line("axes"),
                       "[lattice] axes need an origin of " + std::to_string(entry.dimension) + " numbers");
        if (axes->rows() != entry.dimension)
            table.fail(table.line("axes"), "[lattice] axes must be " + std::to_string(entry.dimension) +
                                               " vectors, the edges of the box from its origin");
        entry.axes = Matrix::Zero(1 + entry.dimension, 3);
        entry.axes->topRows(1) = in_space(Eigen::Map<const Matrix>(origin->data(), 1, entry.dimension));
        entry.axes->bottomRows(entry.dimension) = in_space(*axes);
    }
    if (const auto control_points = table.rows("control_points", names)) {
        if (control_points->rows() != entry.count())
            table.fail(table.line("control_points"),
                       "[lattice] control_points has " + std::to_string(control_points->rows()) +
                           " rows, but points make " + std::to_string(entry.count()));
        entry.control_points = in_space(*control_points);
    }
    entry.su2_box = table.string("su2_box").value_or("");
}

std::vector<double> weights_of(const TomlTable& table, const std::string& key, Index count)
{
    const auto weights = table.numbers(key).value_or(std::vector<double>());
    if (!weights.empty() && static_cast<Index>(weights.size()) != count)
        table.fail(table.line(key), "[lattice] " + key + " has " + std::to_string(weights.size()) +
                                        " numbers, but there are " + std::to_string(count) +
                                        " control points");
    return weights;
}

void take_displacements(const TomlTable& table, LatticeEntry& entry)
{
    const auto names = entry.dimension == 2 ? std::vector<std::string>{"i", "j", "dx", "dy"}
                                            : std::vector<std::string>{"i", "j", "k", "dx", "dy", "dz"};
    const auto rows = table.rows("displacements", names);
    entry.sparse_displacements = Matrix::Zero(rows ? rows->rows() : 0, 6);
    if (rows && rows->rows() > 0) { // a block of an empty matrix would be an offset from a null pointer
        entry.sparse_displacements.leftCols(entry.dimension) = rows->leftCols(entry.dimension);
        entry.sparse_displacements.middleCols(3, entry.dimension) = rows->rightCols(entry.dimension);
    }
    if (entry.su2_box.empty())
        entry.displacements = spread_displacements(
            entry.sparse_displacements, entry.points,
            table.path() + ":" + std::to_string(rows ? table.line("displacements") : table.line()));
}

} // namespace

Matrix spread_displacements(const Matrix& sparse, const std::array<Index, 3>& points,
                            const std::string& place)
{
    Matrix all = Matrix::Zero(points[0] * points[1] * points[2], 3);
    for (Eigen::Index row = 0; row < sparse.rows(); ++row) {
        std::array<Index, 3> at{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = sparse(row, static_cast<Eigen::Index>(axis));
            at[axis] = static_cast<Index>(std::clamp(value, -1.0, static_cast<double>(points[axis])));
            if (value != static_cast<double>(at[axis]) || at[axis] < 0 || at[axis] >= points[axis])
                throw InputError(place + ": [lattice] displacements, entry " + std::to_string(row + 1) +
                                 ", names no control point: " + "ijk"[axis] +
                                 " must be a whole number from 0 to " + std::to_string(points[axis] - 1));
        }
        all.row(at[0] + points[0] * (at[1] + points[1] * at[2])) += sparse.row(row).tail(3);
    }
    return all;
}

LatticeEntry lattice_entry(const TomlTable& table)
{
    table.require_known(kKeys);
    LatticeEntry entry;
    entry.line = table.line();
    entry.basis = table.choice("basis", {"bspline", "bernstein"}).value_or(entry.basis);
    const int dimension = dimension_of(table);
    if (dimension == 0 && !table.has("su2_box"))
        table.fail_missing("points", "points = [7, 5]");
    entry.dimension = dimension == 0 ? 2 : dimension;
    take_counts<Index>(table, "points", entry.dimension, 2, kMostPoints, entry.points);
    for (std::size_t axis = 0; axis < 3; ++axis)
        entry.degree[axis] = entry.basis == "bernstein"
                                 ? static_cast<int>(entry.points[axis]) - 1
                                 : std::min(3, static_cast<int>(entry.points[axis]) - 1);
    take_counts<int>(table, "degree", entry.dimension, 1, entry.basis == "bernstein" ? kMostPoints : 7,
                     entry.degree);
    if (entry.dimension == 2) {
        entry.points[2] = 1;
        entry.degree[2] = 0;
    }
    if (std::int64_t{entry.points[0]} * entry.points[1] * entry.points[2] > kMostControlPoints)
        table.fail(table.line("points"), "[lattice] points make more than " +
                                             std::to_string(kMostControlPoints) + " control points");
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(entry.dimension); ++axis)
        if (entry.degree[axis] >= entry.points[axis])
            table.fail(table.line(table.has("degree") ? "degree" : "points"),
                       "[lattice] degree " + std::to_string(entry.degree[axis]) + " needs at least " +
                           std::to_string(entry.degree[axis] + 1) + " control points along " + "ijk"[axis] +
                           ", but there are " + std::to_string(entry.points[axis]));
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(entry.dimension); ++axis)
        entry.knots[axis] =
            table.numbers(std::string("knots_") + "ijk"[axis]).value_or(std::vector<double>());
    take_place(table, entry);
    entry.weights = weights_of(table, "weights", entry.count());
    entry.moved_weights = weights_of(table, "moved_weights", entry.count());
    entry.continuity = table.integer("continuity", 0, 5).value_or(-1);
    entry.markers = table.strings("markers").value_or(std::vector<std::string>());
    take_displacements(table, entry);
    return entry;
}

} // namespace morph::tools
