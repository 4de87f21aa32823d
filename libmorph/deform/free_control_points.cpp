#include "libmorph/deform/free_control_points.h"

namespace morph {

namespace {

constexpr Index kNotFree = -1;

using SparseRow = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>::InnerIterator;

} // namespace

FreeControlPoints::FreeControlPoints(const ConstraintSet& constraints, const Matrix& wanted)
    : constraints_(constraints), wanted_(wanted), place_(static_cast<std::size_t>(wanted.rows()), kNotFree)
{
    for (const AreaKept& area : constraints.areas)
        concern(constraints.boundaries[area.boundary].nodes);
    for (const Thickness& thickness : constraints.thicknesses)
        concern(constraints.boundaries[thickness.boundary].nodes);
    for (const Distance& distance : constraints.distances)
        concern(distance.ends);
    for (const FixedPoints& fixed : constraints.fixed)
        concern(fixed.points);
    for (const Tie& tie : constraints.ties)
        for (const Index k : tie.control_points)
            place_[static_cast<std::size_t>(k)] = 0;
    for (const Symmetry& symmetry : constraints.symmetries)
        for (const auto& pair : symmetry.pairs)
            for (const Index k : pair)
                place_[static_cast<std::size_t>(k)] = 0;
    for (const Index k : constraints.held)
        place_[static_cast<std::size_t>(k)] = kNotFree;
    for (std::size_t k = 0; k < place_.size(); ++k)
        if (place_[k] != kNotFree) {
            place_[k] = static_cast<Index>(numbers_.size());
            numbers_.push_back(static_cast<Index>(k));
        }
}

void FreeControlPoints::concern(const ControlledPoints& points)
{
    for (Index i = 0; i < points.weights.rows(); ++i)
        for (SparseRow weight(points.weights, i); weight; ++weight)
            place_[static_cast<std::size_t>(weight.col())] = 0;
}

ControlledPoints FreeControlPoints::restricted(const ControlledPoints& points) const
{
    Matrix others = wanted_;
    others(numbers_, Eigen::all).setZero();
    ControlledPoints result{moved(points, others),
                            {points.weights.rows(), static_cast<Index>(numbers_.size())}};
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index i = 0; i < points.weights.rows(); ++i)
        for (SparseRow weight(points.weights, i); weight; ++weight)
            if (const Index k = place_[static_cast<std::size_t>(weight.col())]; k != kNotFree)
                entries.emplace_back(i, k, weight.value());
    result.weights.setFromTriplets(entries.begin(), entries.end());
    return result;
}

void FreeControlPoints::add_term(Index control_point, Index component, double coefficient,
                                 LinearEquation& equation) const
{
    const Index k = place_[static_cast<std::size_t>(control_point)];
    if (k == kNotFree)
        equation.value -= coefficient * wanted_(control_point, component);
    else
        equation.terms.emplace_back(k * static_cast<Index>(wanted_.cols()) + component, coefficient);
}

std::vector<LinearEquation> FreeControlPoints::of_fixed(const FixedPoints& fixed) const
{
    std::vector<LinearEquation> equations;
    for (Index i = 0; i < fixed.points.weights.rows(); ++i)
        for (Index a = 0; a < wanted_.cols(); ++a) {
            LinearEquation equation;
            equation.value = fixed.displacements.size() == 0 ? 0 : fixed.displacements(i, a);
            for (SparseRow weight(fixed.points.weights, i); weight; ++weight)
                add_term(weight.col(), a, weight.value(), equation);
            equations.push_back(std::move(equation));
        }
    return equations;
}

std::vector<LinearEquation> FreeControlPoints::of_tie(const Tie& tie) const
{
    std::vector<LinearEquation> equations;
    for (std::size_t i = 1; i < tie.control_points.size(); ++i)
        for (Index a = 0; a < wanted_.cols(); ++a) {
            LinearEquation equation;
            add_term(tie.control_points[i], a, 1, equation);
            add_term(tie.control_points[0], a, -1, equation);
            equations.push_back(std::move(equation));
        }
    return equations;
}

/// d_j = d_i - 2 n (n . d_i) for a pair, n . d_i = 0 for a point of the mirror.
std::vector<LinearEquation> FreeControlPoints::of_symmetry(const Symmetry& symmetry) const
{
    const auto c = static_cast<Index>(wanted_.cols());
    const Eigen::VectorXd n = symmetry.normal.head(c).normalized();
    std::vector<LinearEquation> equations;
    for (const auto& [i, j] : symmetry.pairs) {
        if (i == j) {
            LinearEquation equation;
            for (Index a = 0; a < c; ++a)
                add_term(i, a, n[a], equation);
            equations.push_back(std::move(equation));
            continue;
        }
        for (Index a = 0; a < c; ++a) {
            LinearEquation equation;
            add_term(j, a, 1, equation);
            for (Index b = 0; b < c; ++b)
                add_term(i, b, 2 * n[a] * n[b] - (a == b ? 1 : 0), equation);
            equations.push_back(std::move(equation));
        }
    }
    return equations;
}

std::vector<LinearEquation> FreeControlPoints::equations(std::size_t source) const
{
    std::vector<LinearEquation> all;
    const auto append = [&](std::vector<LinearEquation> equations) {
        for (LinearEquation& equation : equations) {
            equation.source = source;
            all.push_back(std::move(equation));
        }
        ++source;
    };
    for (const FixedPoints& fixed : constraints_.fixed)
        append(of_fixed(fixed));
    for (const Tie& tie : constraints_.ties)
        append(of_tie(tie));
    for (const Symmetry& symmetry : constraints_.symmetries)
        append(of_symmetry(symmetry));
    return all;
}

} // namespace morph
