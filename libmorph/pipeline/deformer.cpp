#include "tools/deform/case_motion.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/controlled_points.h"
#include "libmorph/deform/move_lattice.h"
#include "tools/deform/case_constraints.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace morph::tools {

namespace {

CaseMotion motion_of_lattice(const Mesh& mesh, const CaseFile& file)
{
    CaseMotion motion;
    motion.lattice = place_lattice(mesh, file);
    motion.displacements = motion.lattice->displacements;
    if (!file.boundaries.empty())
        motion.curves = parametrize_boundaries(mesh, file);
    motion.weights = motion.lattice->weights;
    return motion;
}

/// Displacements of the curves' nodes as their control points want them.
Matrix wanted_displacements(const PlacedBoundaries& curves, std::vector<Index>& vertices)
{
    std::vector<Eigen::RowVector2d> wanted;
    for (std::size_t b = 0; b < curves.boundaries.size(); ++b) {
        const CurveBoundary& boundary = curves.boundaries[b];
        const Curve moved = moved_curve(curves, b);
        for (std::size_t i = 0; i < boundary.vertices.size(); ++i) {
            const double u = boundary.parameters[i].u;
            vertices.push_back(boundary.vertices[i]);
            wanted.emplace_back((moved.point(u) - boundary.curve.point(u)).transpose());
        }
    }
    Matrix rows(static_cast<Index>(wanted.size()), 2);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        rows.row(static_cast<Index>(i)) = wanted[i];
    return rows;
}

/// Bring the nodes of the curves near to where they are wanted by a lattice.
///
/// Least squares alone would take any swing of control points far from the nodes for the last bit of
/// exactness, and tear the mesh around with it. A change of the control points therefore counts too,
/// kSmallest of what the control point that moves the nodes most does [Tikhonov & Arsenin 1977, Solutions of
/// Ill-Posed Problems].
double fit_lattice(const Mesh& mesh, CaseMotion& motion)
{
    constexpr double kSmallest = 1e-3;
    std::vector<Index> vertices;
    const Matrix wanted = wanted_displacements(motion.curves, vertices);
    const ControlledPoints nodes = controlled_vertices(motion.rows(), points(mesh), vertices);
    Eigen::MatrixXd R(nodes.weights);
    for (const Index held : motion.held())
        R.col(held).setZero();
    const Eigen::MatrixXd start = wanted - R * motion.displacements;
    const double damping = kSmallest * R.colwise().norm().maxCoeff();
    Eigen::MatrixXd normal = R.transpose() * R;
    normal.diagonal().array() += damping * damping;
    motion.displacements += normal.ldlt().solve(R.transpose() * start);
    return (wanted - R * motion.displacements).rowwise().norm().maxCoeff();
}

bool reweighs(const CaseFile& file)
{
    return file.lattice && !file.lattice->moved_weights.empty();
}

/// The weights of the boundary alone, as rows of all vertices.
SparseWeights boundary_weights(const Mesh& mesh, const BoundaryConditions& conditions)
{
    SparseWeights weights{conditions.columns, {}};
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (std::size_t i = 0; i < conditions.held.vertices.size(); ++i)
        for (Index k = 0; k < conditions.held.values.cols(); ++k)
            if (const double value = conditions.held.values(static_cast<Index>(i), k); value != 0)
                entries.emplace_back(conditions.held.vertices[i], k, value);
    weights.values.resize(vertex_count(mesh), conditions.held.values.cols());
    weights.values.setFromTriplets(entries.begin(), entries.end());
    return weights;
}

void require_no_weights_wanted(const CaseFile& file, const std::string& weights_file)
{
    if (!weights_file.empty())
        throw InputError(
            file.path + ":" + std::to_string(file.deform.line) +
            ": [deform] rotations, steps, slide, rigid and methods that couple x and y move the mesh by "
            "more than weights, so they cannot use those of " +
            weights_file);
}

/// With other weights of the control points the map is not linear in them.
void move_reweighed(const CaseFile& file, const CaseMotion& motion, const Eigen::Map<Points>& positions)
{
    const Lattice& before = motion.lattice->lattice;
    Points control_points = before.definition().control_points;
    control_points.leftCols(motion.displacements.cols()) += motion.displacements;
    const Lattice after =
        before.with_weights(file.lattice->moved_weights).with_control_points(control_points);
    move_by_lattice(before, after, motion.lattice->embedding, positions);
}

/// The vertices whose weights should sum to one.
std::vector<Index> whole_rows(const CaseMotion& motion)
{
    std::vector<Index> rows;
    if (motion.lattice && !motion.carry) {
        if (std::holds_alternative<SparseWeights>(motion.weights))
            for (std::size_t v = 0; v < motion.lattice->embedding.inside.size(); ++v)
                if (motion.lattice->embedding.inside[v] != 0)
                    rows.push_back(static_cast<Index>(v));
        return rows;
    }
    std::vector<Index> fixed;
    for (const SharedVertex& shared : motion.curves.conditions.shared)
        if (!shared.fixed_by.empty())
            fixed.push_back(shared.vertex);
    for (const CurveBoundary& boundary : motion.curves.boundaries)
        for (const Index v : boundary.vertices)
            if (std::find(fixed.begin(), fixed.end(), v) == fixed.end())
                rows.push_back(v);
    return rows;
}

} // namespace

const std::vector<ControlPoint>& CaseMotion::columns() const
{
    return std::visit([](const auto& filled) -> const std::vector<ControlPoint>& { return filled.columns; },
                      weights);
}

WeightsView CaseMotion::rows() const
{
    return std::visit([](const auto& filled) { return WeightsView(filled); }, weights);
}

std::vector<Index> CaseMotion::held() const
{
    return lattice ? lattice->held : std::vector<Index>();
}

CaseMotion prepare_motion(const Mesh& mesh, const CaseFile& file, const std::string& weights_file)
{
    if (file.deform.method == "ffd") {
        if (carries_boundary(file.deform))
            throw InputError(file.path + ":" + std::to_string(file.deform.line) +
                             ": [deform] rotations, steps, slide and rigid go with methods that carry the "
                             "boundary's move into the mesh, not with \"ffd\"");
        return motion_of_lattice(mesh, file);
    }
    CaseMotion motion;
    if (file.boundaries.empty()) {
        motion.lattice = place_lattice(mesh, file);
        motion.curves = lattice_boundary(mesh, file, *motion.lattice);
    } else {
        motion.curves = parametrize_boundaries(mesh, file);
    }
    motion.displacements = motion.curves.displacements;
    if (carries_boundary(file.deform)) {
        require_no_weights_wanted(file, weights_file);
        motion.carry = boundary_carry(motion.curves, file);
        motion.weights = boundary_weights(mesh, motion.curves.conditions);
        return motion;
    }
    motion.weights = weights_file.empty() ? solve_weights(mesh, motion.curves, file)
                                          : load_weights(weights_file, mesh, motion.curves);
    return motion;
}

ControlOutcome control_motion(const Mesh& mesh, const CaseFile& file, CaseMotion& motion)
{
    ControlOutcome outcome;
    if (reweighs(file) && (file.deform.method != "ffd" || !file.pulls.empty() || file.constraints))
        throw InputError(file.path + ":" + std::to_string(file.lattice->line) +
                         ": [lattice] moved_weights goes with method = \"ffd\" alone, without pulls and "
                         "constraints: the move is not linear in them");
    if (file.deform.method == "ffd" && !motion.curves.boundaries.empty())
        outcome.curve_misfit = fit_lattice(mesh, motion);
    if (!file.pulls.empty())
        outcome.pull = pull(mesh, file, motion.rows(), motion.held(), motion.displacements);
    if (file.constraints)
        outcome.constrained = constrain(mesh, file, outcome.pull, motion);
    if (file.deform.method == "ffd")
        return outcome;
    motion.curves.displacements = motion.displacements;
    if (!motion.curves.boundaries.empty())
        require_ends_together(mesh, motion.curves.boundaries, motion.curves.conditions,
                              motion.curves.displacements);
    return outcome;
}

bool is_linear(const CaseFile& file)
{
    return !reweighs(file) && !carries_boundary(file.deform);
}

int apply_motion(const Mesh& mesh, const CaseFile& file, const CaseMotion& motion,
                 Eigen::Map<Points> positions)
{
    if (motion.carry)
        return carry_boundary(mesh, *motion.carry, motion.displacements, positions);
    if (reweighs(file))
        move_reweighed(file, motion, positions);
    else
        std::visit([&](const auto& filled) { apply_weights(filled, motion.displacements, positions); },
                   motion.weights);
    return 1;
}

WeightsCheck check_weights(const CaseMotion& motion)
{
    const WeightsView rows = motion.rows();
    WeightsCheck check;
    std::vector<double> sums(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
        rows.for_each(row, [&](Eigen::Index, double value) {
            check.min = std::min(check.min, value);
            check.max = std::max(check.max, value);
            sums[static_cast<std::size_t>(row)] += value;
        });
    for (const Index v : whole_rows(motion))
        check.partition_error =
            std::max(check.partition_error, std::abs(sums[static_cast<std::size_t>(v)] - 1));
    return check;
}

Weights dense_weights(const CaseMotion& motion)
{
    if (const Weights* dense = std::get_if<Weights>(&motion.weights))
        return *dense;
    const auto& sparse = std::get<SparseWeights>(motion.weights);
    return {sparse.columns, Matrix(sparse.values)};
}

} // namespace morph::tools
