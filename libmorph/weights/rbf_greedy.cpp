#include "libmorph/weights/rbf_greedy.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/boundary_segments.h"
#include "libmorph/weights/rbf_setup.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kLeastGroups = 8;

void require_valid(const GreedyOptions& greedy)
{
    if (!(greedy.tolerance > 0))
        throw InputError("the tolerance of the greedy choice is " + std::to_string(greedy.tolerance) +
                         ", but it must be positive");
    if (greedy.most_centres < 8 || greedy.most_centres > kMostCentres)
        throw InputError("the greedy choice is allowed " + std::to_string(greedy.most_centres) +
                         " centres, but it must be 8 to " + std::to_string(kMostCentres));
}

/// Chooses among the rows of the held vertices.
class GreedyChoice {
public:
    GreedyChoice(const DomainView& domain, const UniqueDirichletVertices& held, Matrix values)
        : domain_(domain), vertices_(held.vertices()), values_(std::move(values)),
          positions_(held_points(domain, held)), along_(vertices_.size()), chosen_(vertices_.size())
    {
        // Vertices are numbered along a space-filling curve: neighbours in this order are neighbours in the
        // plane.
        std::iota(along_.begin(), along_.end(), 0);
        std::sort(along_.begin(), along_.end(), [this](Index a, Index b) { return vertex(a) < vertex(b); });
        choose_outermost();
    }

    std::size_t count() const { return count_; }

    /// Ascending.
    std::vector<Index> centres() const
    {
        std::vector<Index> list;
        for (const Index row : along_)
            if (chosen_[static_cast<std::size_t>(row)])
                list.push_back(vertex(row));
        return list;
    }

    /// Norm of what the centres chosen so far miss at each held vertex; 0 at the centres.
    Eigen::VectorXd errors(const RbfOptions& options, double support) const
    {
        const RadialInterpolant interpolant = radial_interpolant(domain_, centres(), options, support);
        std::vector<Index> rows;
        for (const Index row : along_)
            if (chosen_[static_cast<std::size_t>(row)])
                rows.push_back(row);
        const Matrix coefficients = interpolant.coefficients(values_(rows, Eigen::all));
        Eigen::VectorXd missed = (values_ - interpolant.evaluate(positions_, coefficients)).rowwise().norm();
        for (const Index row : rows)
            missed[row] = 0;
        return missed;
    }

    /// Add the worst of each group of neighbours whose error is above @p allowed, the worst first.
    void add_worst(const Eigen::VectorXd& errors, double allowed, std::size_t most)
    {
        const std::size_t groups = std::max(kLeastGroups, count_ / 2);
        const std::size_t size = (along_.size() - 1) / groups + 1;
        std::vector<Index> worst;
        const auto milder = [&](Index a, Index b) { return errors[a] < errors[b]; };
        for (std::size_t begin = 0; begin < along_.size(); begin += size) {
            const auto first = along_.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto last =
                along_.begin() + static_cast<std::ptrdiff_t>(std::min(begin + size, along_.size()));
            worst.push_back(*std::max_element(first, last, milder));
        }
        std::stable_sort(worst.begin(), worst.end(), [&](Index a, Index b) { return milder(b, a); });
        for (const Index row : worst)
            if (errors[row] > allowed && count_ < most)
                choose(row);
    }

private:
    Index vertex(Index row) const { return vertices_[static_cast<std::size_t>(row)]; }

    void choose(Index row)
    {
        count_ += chosen_[static_cast<std::size_t>(row)] ? 0 : 1;
        chosen_[static_cast<std::size_t>(row)] = true;
    }

    /// The farthest out in eight directions: they lie on a line only if all vertices do.
    void choose_outermost()
    {
        const auto x = positions_.col(0), y = positions_.col(1);
        for (const auto& [a, b] : {std::pair(1.0, 0.0), {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}) {
            Index low = 0, high = 0;
            (a * x + b * y).minCoeff(&low);
            (a * x + b * y).maxCoeff(&high);
            choose(low);
            choose(high);
        }
    }

    DomainView domain_;
    std::vector<Index> vertices_;
    Matrix values_;
    Points positions_;
    std::vector<Index> along_; ///< rows by number of their vertices
    std::vector<bool> chosen_;
    std::size_t count_ = 0;
};

} // namespace

std::vector<Index> greedy_centres(const DomainView& domain, const DirichletBoundary& boundary,
                                  const Matrix& values, const RbfOptions& options,
                                  const GreedyOptions& greedy)
{
    require_valid(greedy);
    const double support = support_radius(domain, boundary, options);
    const UniqueDirichletVertices vertices(domain, boundary);
    const Matrix joined = vertices.join(values);
    if (joined.rows() == 0)
        throw InputError("no vertex is held: radial functions have no centres");
    const double allowed = greedy.tolerance * joined.rowwise().norm().maxCoeff();
    const auto most = static_cast<std::size_t>(greedy.most_centres);
    GreedyChoice choice(domain, vertices, joined);
    for (;;) {
        const Eigen::VectorXd errors = choice.errors(options, support);
        if (errors.maxCoeff() <= allowed)
            return choice.centres();
        if (choice.count() >= most) {
            std::ostringstream text;
            text << choice.count() << " centres of radial functions leave an error of "
                 << errors.maxCoeff() / allowed * greedy.tolerance << " of the largest value, but "
                 << greedy.tolerance << " is asked for; allow more centres or a larger tolerance";
            throw SolverError(text.str());
        }
        choice.add_worst(errors, allowed, most);
    }
}

} // namespace morph
