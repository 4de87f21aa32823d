#include "libmorph/deform/rigid_frames.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/weights/boundary_segments.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace morph {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kRowsPerBlock = 8192; // vertices a thread takes at a time

// Where less than this part of the bodies arrives, pivots are no longer blended in full: the quotient of two
// small numbers would blow up what a method leaves there. The angle is small there as well.
constexpr double kLeastShare = 0.1;

/// The frames of the joined held vertices.
class FrameFit {
public:
    FrameFit(const Eigen::Ref<const Points>& x, const std::vector<Index>& vertices,
             const Matrix& displacement, const std::vector<BoundarySegment>& edges, double reach)
        : reach_(reach), neighbours_(vertices.size()), turn_(vertices.size()), lengths_(vertices.size()),
          seen_from_(vertices.size(), -1)
    {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto row = static_cast<Index>(i);
            before_.emplace_back(x(vertices[i], 0), x(vertices[i], 1));
            shift_.emplace_back(displacement(row, 0), displacement(row, 1));
        }
        for (const auto& [a, b] : edges)
            add_edge(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
        frames_.angle.assign(vertices.size(), 0);
        frames_.body.assign(vertices.size(), -1);
    }

    BoundaryFrames fit()
    {
        std::vector<Complex> pivots;
        for (std::size_t i = 0; i < before_.size(); ++i)
            if (!neighbours_[i].empty() && frames_.body[i] < 0)
                pivots.push_back(fit_body(i, static_cast<Index>(pivots.size())));
        frames_.pivot.resize(static_cast<Index>(pivots.size()), 2);
        for (std::size_t b = 0; b < pivots.size(); ++b)
            frames_.pivot.row(static_cast<Index>(b)) << pivots[b].real(), pivots[b].imag();
        frames_.translation.resize(static_cast<Index>(before_.size()), 2);
        for (std::size_t i = 0; i < before_.size(); ++i) {
            Complex left = shift_[i];
            if (const Index b = frames_.body[i]; b >= 0)
                left -= (std::polar(1.0, frames_.angle[i]) - 1.0) *
                        (before_[i] - pivots[static_cast<std::size_t>(b)]);
            frames_.translation.row(static_cast<Index>(i)) << left.real(), left.imag();
        }
        return std::move(frames_);
    }

private:
    void add_edge(std::size_t a, std::size_t b)
    {
        const Complex edge = before_[b] - before_[a];
        const Complex after = (before_[b] + shift_[b]) - (before_[a] + shift_[a]);
        const double length = std::abs(edge);
        const Complex turn = length > 0 ? std::conj(edge) * after / length : Complex(0);
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
            neighbours_[from].push_back(static_cast<Index>(to));
            turn_[from] += turn;
            lengths_[from] += length;
        }
    }

    /// The vertices connected with @p start by moving edges; each but the first follows a neighbour.
    std::vector<std::pair<std::size_t, std::size_t>> connected(std::size_t start, Index body)
    {
        std::vector<std::pair<std::size_t, std::size_t>> found{{start, start}}; // vertex, whom it follows
        frames_.body[start] = body;
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const Index next : neighbours_[found[i].first])
                if (Index& known = frames_.body[static_cast<std::size_t>(next)]; known < 0) {
                    known = body;
                    found.emplace_back(next, found[i].first);
                }
        return found;
    }

    /// @return the pivot
    Complex fit_body(std::size_t start, Index body)
    {
        const auto vertices = connected(start, body);
        Complex whole = 0, moment = 0;
        double length = 0;
        for (const auto& [i, followed] : vertices) { // both ends count an edge: the mean is the same
            whole += turn_[i];
            moment += lengths_[i] * (before_[i] - before_[start]);
            length += lengths_[i];
        }
        const double reach = reach_ * length / 2;
        for (const auto& [i, followed] : vertices)
            frames_.angle[i] = argument(turn_around(i, reach) * std::conj(whole));
        unwrap(vertices, whole);
        return before_[start] + (length > 0 ? moment / length : Complex(0));
    }

    /// The turn of the edges within @p reach along the boundary, the nearer the more.
    Complex turn_around(std::size_t centre, double reach)
    {
        Complex sum = turn_[centre];
        std::vector<std::pair<std::size_t, double>> found{{centre, 0.0}}; // vertex, how far it is
        seen_from_[centre] = static_cast<Index>(centre);
        for (std::size_t k = 0; k < found.size(); ++k)
            for (const Index next : neighbours_[found[k].first]) {
                const auto i = static_cast<std::size_t>(next);
                const double distance = found[k].second + std::abs(before_[i] - before_[found[k].first]);
                if (distance >= reach || seen_from_[i] == static_cast<Index>(centre))
                    continue;
                seen_from_[i] = static_cast<Index>(centre);
                sum += (1 - distance / reach) * turn_[i];
                found.emplace_back(i, distance);
            }
        return sum;
    }

    /// Angles against that of the whole body, at first within half a turn, become angles without jumps.
    void unwrap(const std::vector<std::pair<std::size_t, std::size_t>>& vertices, const Complex& whole)
    {
        constexpr double kTurn = 2 * std::numbers::pi;
        double mean = 0;
        for (const auto& [i, followed] : vertices) {
            double& angle = frames_.angle[i];
            angle += kTurn * std::round((frames_.angle[followed] - angle) / kTurn);
            mean += angle / static_cast<double>(vertices.size());
        }
        const double offset = argument(whole) - kTurn * std::round(mean / kTurn);
        for (const auto& [i, followed] : vertices)
            frames_.angle[i] += offset;
    }

    /// 0 for the number 0, whatever the signs of its parts.
    static double argument(const Complex& z) { return z == Complex(0) ? 0 : std::arg(z); }

    double reach_;
    std::vector<Complex> before_, shift_; ///< position and displacement of each vertex as complex numbers
    std::vector<std::vector<Index>> neighbours_;
    std::vector<Complex> turn_;    ///< sum over the edges there; its argument is the angle that fits best
    std::vector<double> lengths_;  ///< sum over the edges there
    std::vector<Index> seen_from_; ///< the last centre that turn_around() came from
    BoundaryFrames frames_;
};

/// What is extended: angle, translation, how much of the bodies arrives, and that times their pivot.
Matrix frame_values(const BoundaryFrames& frames, const Eigen::RowVector2d& centre)
{
    Matrix values = Matrix::Zero(frames.translation.rows(), 6);
    for (Index i = 0; i < values.rows(); ++i) {
        values(i, 0) = frames.angle[static_cast<std::size_t>(i)];
        values.row(i).segment<2>(1) = frames.translation.row(i);
        if (const Index body = frames.body[static_cast<std::size_t>(i)]; body >= 0) {
            values(i, 3) = 1;
            values.row(i).tail<2>() = frames.pivot.row(body) - centre;
        }
    }
    return values;
}

/// The displacement of every vertex from what has arrived there.
Matrix rebuilt(const Eigen::Ref<const Points>& x, const Matrix& arrived, const Eigen::RowVector2d& centre)
{
    Matrix moved(x.rows(), 2);
    parallel_for(static_cast<std::size_t>(x.rows()), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
            const auto a = arrived.row(v);
            const Eigen::RowVector2d arm =
                x.row(v).head<2>() - centre - a.tail<2>() / std::max(a[3], kLeastShare);
            const double s = std::sin(a[0]), half = std::sin(a[0] / 2), versine = 2 * half * half;
            moved(v, 0) = a[1] - versine * arm[0] - s * arm[1];
            moved(v, 1) = a[2] + s * arm[0] - versine * arm[1];
        }
    });
    return moved;
}

/// Rows of the joined vertices for all that are held.
BoundaryFrames expanded(const BoundaryFrames& joined, const std::vector<Index>& held,
                        const std::vector<Index>& row_of)
{
    BoundaryFrames frames{{}, Points2(static_cast<Index>(held.size()), 2), {}, joined.pivot};
    for (std::size_t i = 0; i < held.size(); ++i) {
        const Index row = row_of[static_cast<std::size_t>(held[i])];
        frames.angle.push_back(joined.angle[static_cast<std::size_t>(row)]);
        frames.body.push_back(joined.body[static_cast<std::size_t>(row)]);
        frames.translation.row(static_cast<Index>(i)) = joined.translation.row(row);
    }
    return frames;
}

} // namespace

BoundaryFrames boundary_frames(const DomainView& domain, const DirichletBoundary& held,
                               const Matrix& displacement, double reach)
{
    if (!(reach >= 0 && reach <= 1))
        throw InputError("the reach of the boundary's rotation is " + std::to_string(reach) +
                         ", but it must lie in [0, 1]");
    if (displacement.cols() != 2)
        throw InputError("the displacement of the boundary has " + std::to_string(displacement.cols()) +
                         " columns, expected x and y");
    const UniqueDirichletVertices vertices(domain, held);
    const std::vector<Index> row_of = vertices.rows();
    FrameFit fit(domain.positions(), vertices.vertices(), vertices.join(displacement),
                 boundary_segments(domain, held, vertices).moving, reach);
    return expanded(fit.fit(), held.vertices, row_of);
}

Matrix extend_with_rotations(const BoundaryExtension& extension, const DomainView& domain,
                             const DirichletBoundary& held, const Matrix& displacement, double reach)
{
    const BoundaryFrames frames = boundary_frames(domain, held, displacement, reach);
    const bool moves = frames.pivot.rows() > 0;
    const Eigen::RowVector2d centre = moves ? frames.pivot.colwise().mean() : Eigen::RowVector2d(0, 0);
    Matrix moved = rebuilt(domain.positions(), extension.extend(frame_values(frames, centre)), centre);
    const UniqueDirichletVertices vertices(domain, held);
    vertices.restore(vertices.join(displacement), moved);
    return moved;
}

} // namespace morph
