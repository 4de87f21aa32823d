#include "formats/case/entries.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cstdint>

namespace morph {

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

/// 2 or 3 numbers as x, y, z.
Eigen::Vector3d in_space(const Eigen::Ref<const Eigen::RowVectorXd>& numbers)
{
    Eigen::Vector3d full = Eigen::Vector3d::Zero();
    full.head(numbers.size()) = numbers.transpose();
    return full;
}

Index count_of(const LatticeDefinition& shape)
{
    return shape.points[0] * shape.points[1] * shape.points[2];
}

LatticeBox box_of(const TomlTable& table, const std::vector<double>& numbers, int dimension)
{
    if (numbers.size() != static_cast<std::size_t>(2 * dimension))
        table.fail(table.line("box"), dimension == 2
                                          ? "[lattice] box must be [xmin, ymin, xmax, ymax]"
                                          : "[lattice] box must be [xmin, ymin, zmin, xmax, ymax, zmax]");
    const Eigen::Map<const Eigen::RowVectorXd> low(numbers.data(), dimension);
    const Eigen::Map<const Eigen::RowVectorXd> high(numbers.data() + dimension, dimension);
    return {in_space(low), in_space(high)};
}

LatticeAxes axes_of(const TomlTable& table, const Matrix& axes, int dimension)
{
    const auto origin = table.numbers("origin");
    if (!origin || origin->size() != static_cast<std::size_t>(dimension))
        table.fail(table.line("axes"),
                   "[lattice] axes need an origin of " + std::to_string(dimension) + " numbers");
    if (axes.rows() != dimension)
        table.fail(table.line("axes"), "[lattice] axes must be " + std::to_string(dimension) +
                                           " vectors, the edges of the box from its origin");
    LatticeAxes placed{in_space(Eigen::Map<const Eigen::RowVectorXd>(origin->data(), dimension)),
                       Eigen::Matrix3d::Identity()};
    for (Eigen::Index axis = 0; axis < dimension; ++axis)
        placed.axes.col(axis) = in_space(axes.row(axis));
    return placed;
}

void take_place(const TomlTable& table, LatticeEntry& entry)
{
    const int given = static_cast<int>(table.has("box")) + static_cast<int>(table.has("axes")) +
                      static_cast<int>(table.has("control_points")) + static_cast<int>(table.has("su2_box"));
    if (given != 1)
        table.fail(table.line(), "[lattice] needs one of box, origin with axes, control_points, su2_box");
    LatticeSettings& lattice = entry.settings;
    const int dimension = lattice.shape.dimension;
    if (const auto box = table.numbers("box"))
        lattice.box = box_of(table, *box, dimension);
    const auto names = first({"x", "y", "z"}, dimension);
    if (const auto axes = table.rows("axes", names))
        lattice.axes = axes_of(table, *axes, dimension);
    if (const auto control_points = table.rows("control_points", names)) {
        const Index count = count_of(lattice.shape);
        if (control_points->rows() != count)
            table.fail(table.line("control_points"), "[lattice] control_points has " +
                                                         std::to_string(control_points->rows()) +
                                                         " rows, but points make " + std::to_string(count));
        lattice.shape.control_points = Points::Zero(count, 3);
        lattice.shape.control_points.leftCols(dimension) = *control_points;
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
    const int dimension = entry.settings.shape.dimension;
    const auto names = dimension == 2 ? std::vector<std::string>{"i", "j", "dx", "dy"}
                                      : std::vector<std::string>{"i", "j", "k", "dx", "dy", "dz"};
    const auto rows = table.rows("displacements", names);
    entry.sparse_displacements = Matrix::Zero(rows ? rows->rows() : 0, 6);
    if (rows && rows->rows() > 0) { // a block of an empty matrix would be an offset from a null pointer
        entry.sparse_displacements.leftCols(dimension) = rows->leftCols(dimension);
        entry.sparse_displacements.middleCols(3, dimension) = rows->rightCols(dimension);
    }
    if (entry.su2_box.empty())
        entry.settings.displacements =
            full_displacements(entry.sparse_displacements, entry.settings.shape.points,
                               table.where(rows ? table.line("displacements") : table.line()));
}

/// Points, degree and knots along i, j, k.
void take_shape(const TomlTable& table, LatticeDefinition& shape)
{
    shape.basis = table.choice<LatticeBasis>("basis").value_or(shape.basis);
    const bool bernstein = shape.basis == LatticeBasis::bernstein;
    const int dimension = dimension_of(table);
    if (dimension == 0 && !table.has("su2_box"))
        table.fail_missing("points", "points = [7, 5]");
    shape.dimension = dimension == 0 ? 2 : dimension;
    take_counts<Index>(table, "points", shape.dimension, 2, kMostPoints, shape.points);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int most = static_cast<int>(shape.points[axis]) - 1;
        shape.degree[axis] = bernstein ? most : std::min(3, most);
    }
    take_counts<int>(table, "degree", shape.dimension, 1, bernstein ? kMostPoints : 7, shape.degree);
    if (shape.dimension == 2) {
        shape.points[2] = 1;
        shape.degree[2] = 0;
    }
    if (std::int64_t{shape.points[0]} * shape.points[1] * shape.points[2] > kMostControlPoints)
        table.fail(table.line("points"), "[lattice] points make more than " +
                                             std::to_string(kMostControlPoints) + " control points");
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(shape.dimension); ++axis)
        if (shape.degree[axis] >= shape.points[axis])
            table.fail(table.line(table.has("degree") ? "degree" : "points"),
                       "[lattice] degree " + std::to_string(shape.degree[axis]) + " needs at least " +
                           std::to_string(shape.degree[axis] + 1) + " control points along " + "ijk"[axis] +
                           ", but there are " + std::to_string(shape.points[axis]));
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(shape.dimension); ++axis)
        shape.knots[axis] =
            table.numbers(std::string("knots_") + "ijk"[axis]).value_or(std::vector<double>());
}

} // namespace

Matrix full_displacements(const Matrix& sparse, const std::array<Index, 3>& points, const std::string& where)
{
    Matrix all = Matrix::Zero(points[0] * points[1] * points[2], 3);
    for (Eigen::Index row = 0; row < sparse.rows(); ++row) {
        std::array<Index, 3> at{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = sparse(row, static_cast<Eigen::Index>(axis));
            at[axis] = static_cast<Index>(std::clamp(value, -1.0, static_cast<double>(points[axis])));
            if (value != static_cast<double>(at[axis]) || at[axis] < 0 || at[axis] >= points[axis])
                throw InputError(where + "[lattice] displacements, entry " + std::to_string(row + 1) +
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
    LatticeSettings& lattice = entry.settings;
    lattice.where = table.where();
    take_shape(table, lattice.shape);
    take_place(table, entry);
    const Index count = count_of(lattice.shape);
    lattice.shape.weights = weights_of(table, "weights", count);
    lattice.moved_weights = weights_of(table, "moved_weights", count);
    lattice.continuity = table.integer("continuity", 0, 5).value_or(-1);
    lattice.markers = table.strings("markers").value_or(std::vector<std::string>());
    take_displacements(table, entry);
    return entry;
}

} // namespace morph
