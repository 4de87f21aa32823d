#include "libmorph/deform/slide.h"

#include "libmorph/basis/closest.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/chain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace morph {

namespace {

constexpr double kLeastDistanceRatio = 0.1; // of their distance, to which neighbours may come together

/// A line that nodes slide along, by a parameter that grows along it: of the curve, or arc length along the
/// marker. A straight marker goes on beyond its ends, which may move.
class Rail {
public:
    Rail(const Mesh& mesh, const SlidingMarker& sliding, const Chain& chain)
        : sliding_(sliding), closed_(chain.closed)
    {
        for (const Index v : chain.vertices)
            nodes_.emplace_back(points(mesh).row(v).head<2>());
        if (closed_)
            nodes_.push_back(nodes_.front());
        arc_.assign(nodes_.size(), 0);
        for (std::size_t i = 1; i < nodes_.size(); ++i)
            arc_[i] = arc_[i - 1] + (nodes_[i] - nodes_[i - 1]).norm();
        const Eigen::RowVector2d across = nodes_.back() - nodes_.front();
        straight_ = across.norm() > (1 - kStraight) * arc_.back();
        if (straight_)
            along_ = across.normalized();
    }

    /// The whole of a closed rail in its parameter; 0 when it is open.
    double period() const { return !closed_ ? 0 : sliding_.curve ? 1 : arc_.back(); }

    /// Parameter of the nearest place.
    double nearest(const Eigen::RowVector2d& x) const
    {
        if (sliding_.curve)
            return closest_parameter(*sliding_.curve, x.transpose()).u;
        return straight_ ? (x - nodes_[0]).dot(along_) : nearest_on_polygon(x);
    }

    Eigen::RowVector2d point(double s) const
    {
        if (sliding_.curve)
            return sliding_.curve->point(s).transpose();
        return straight_ ? Eigen::RowVector2d(nodes_[0] + s * along_) : on_polygon(s);
    }

private:
    static constexpr double kStraight = 1e-12; // of its length that a straight marker may lose to bends

    double nearest_on_polygon(const Eigen::RowVector2d& x) const
    {
        double best = 0;
        double best2 = (x - nodes_[0]).squaredNorm();
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const Eigen::RowVector2d side = nodes_[i] - nodes_[i - 1];
            const double length2 = side.squaredNorm();
            if (length2 == 0)
                continue;
            const double share = std::clamp((x - nodes_[i - 1]).dot(side) / length2, 0.0, 1.0);
            const double distance2 = (nodes_[i - 1] + share * side - x).squaredNorm();
            if (distance2 < best2) {
                best2 = distance2;
                best = arc_[i - 1] + share * (arc_[i] - arc_[i - 1]);
            }
        }
        return best;
    }

    Eigen::RowVector2d on_polygon(double s) const
    {
        if (closed_)
            s -= arc_.back() * std::floor(s / arc_.back());
        const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s) - arc_.begin();
        const auto i = static_cast<std::size_t>(after);
        const double share = (s - arc_[i - 1]) / (arc_[i] - arc_[i - 1]);
        return (1 - share) * nodes_[i - 1] + share * nodes_[i];
    }

    const SlidingMarker& sliding_;
    bool closed_;
    bool straight_ = false;
    Eigen::RowVector2d along_{0, 0};
    std::vector<Eigen::RowVector2d> nodes_; ///< along the marker; a closed one repeats the first
    std::vector<double> arc_;               ///< arc length up to each of them
};

/// The nodes of a marker that slide, and those between them that do not.
struct SlidingChain {
    Chain chain;
    std::vector<bool> slides; ///< for each vertex of the chain
};

/// Difference of two parameters, of a closed rail the one nearest to 0.
double difference(double to, double from, double period)
{
    const double gap = to - from;
    return period > 0 ? gap - period * std::round(gap / period) : gap;
}

/// The sliding nodes between two that do not, stretched evenly: what keeps the order of nodes for certain.
std::vector<double> stretched(const std::vector<double>& start, const std::vector<double>& target,
                              const std::vector<bool>& slides)
{
    std::vector<double> even = target;
    std::size_t before = 0;
    for (std::size_t i = 1; i < start.size(); ++i) {
        if (slides[i])
            continue;
        for (std::size_t k = before + 1; k < i; ++k) {
            const double share = (start[k] - start[before]) / (start[i] - start[before]);
            even[k] = (1 - share) * target[before] + share * target[i];
        }
        before = i;
    }
    return even;
}

/// Where nodes end: at their targets if neighbours keep apart there, else on the way to there from even
/// spacing.
/// @param period  of a closed rail, whose nodes start from where they are; 0: the ends do not slide
std::vector<double> let_slide(const std::vector<double>& start, const std::vector<double>& target,
                              const std::vector<bool>& slides, double period)
{
    const std::vector<double> even = period > 0 ? start : stretched(start, target, slides);
    double part = 1;
    for (std::size_t i = 0; i + (period > 0 ? 0 : 1) < start.size(); ++i) {
        const std::size_t next = (i + 1) % start.size();
        const double gap = difference(even[next], even[i], period);
        const double closing = ((target[i] - even[i]) - (target[next] - even[next])) * (gap < 0 ? -1 : 1);
        if (closing > (1 - kLeastDistanceRatio) * std::abs(gap))
            part = std::min(part, (1 - kLeastDistanceRatio) * std::abs(gap) / closing);
    }
    std::vector<double> end = even;
    for (std::size_t i = 0; i < end.size(); ++i)
        end[i] += part * (target[i] - even[i]);
    return end;
}

/// A held boundary, its displacement, and the rows of its vertices.
struct Held {
    DirichletBoundary boundary;
    Matrix displacement;
    std::map<Index, Index> row;

    void add(Index v, const Eigen::RowVector2d& move)
    {
        row[v] = static_cast<Index>(boundary.vertices.size());
        boundary.vertices.push_back(v);
        displacement.conservativeResize(displacement.rows() + 1, 2);
        displacement.bottomRows<1>() = move;
    }
};

class Sliding {
public:
    Sliding(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
        : mesh_(mesh), held_(held), displacement_(displacement)
    {
        for (std::size_t i = 0; i < held.vertices.size(); ++i)
            row_[held.vertices[i]] = static_cast<Index>(i);
        for (const Marker& any : mesh.markers)
            for (const Index v : marker_vertices(any))
                ++markers_at_[v];
    }

    SlidingChain chain_of(const SlidingMarker& sliding) const
    {
        SlidingChain result{marker_chain(marker(mesh_, sliding.name), mesh_.numbering), {}};
        const std::vector<Index>& vertices = result.chain.vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const bool end = !result.chain.closed && (i == 0 || i + 1 == vertices.size());
            result.slides.push_back(!end && markers_at_.at(vertices[i]) == 1);
            const auto row = row_.find(vertices[i]);
            if (result.slides.back() && row != row_.end() && !displacement_.row(row->second).isZero(0))
                throw InputError("marker '" + sliding.name + "' slides, but is moved as well");
        }
        return result;
    }

    /// The boundary without the sliding nodes, but with the others of their chains.
    Held without(const std::vector<SlidingChain>& chains) const
    {
        std::map<Index, bool> slides;
        for (const SlidingChain& sliding : chains)
            for (std::size_t i = 0; i < sliding.slides.size(); ++i)
                slides[sliding.chain.vertices[i]] = sliding.slides[i];
        const auto is_sliding = [&](Index v) { return slides.contains(v) && slides.at(v); };
        Held rest{{{}, held_.moving_edges, {}}, Matrix(0, 2), {}};
        std::vector<Index> rows;
        for (std::size_t i = 0; i < held_.vertices.size(); ++i) {
            if (is_sliding(held_.vertices[i]))
                continue;
            rest.row[held_.vertices[i]] = static_cast<Index>(rows.size());
            rest.boundary.vertices.push_back(held_.vertices[i]);
            rows.push_back(static_cast<Index>(i));
        }
        rest.displacement = displacement_(rows, Eigen::all);
        std::copy_if(held_.fixed_edges.begin(), held_.fixed_edges.end(),
                     std::back_inserter(rest.boundary.fixed_edges),
                     [&](const auto& edge) { return !is_sliding(edge[0]) && !is_sliding(edge[1]); });
        for (const auto& [v, sliding] : slides)
            if (!sliding && !rest.row.contains(v))
                rest.add(v, {0, 0});
        return rest;
    }

    /// Add the nodes of a chain, slid to where @p moved, n x 2, would take them.
    void slide(const SlidingMarker& sliding, const SlidingChain& nodes, const Matrix& moved, const Held& rest,
               Held& all) const
    {
        const Rail rail(mesh_, sliding, nodes.chain);
        std::vector<double> start;
        std::vector<double> target;
        for (std::size_t i = 0; i < nodes.slides.size(); ++i) {
            const Index v = nodes.chain.vertices[i];
            const Eigen::RowVector2d x = points(mesh_).row(v).head<2>();
            const Eigen::RowVector2d move =
                nodes.slides[i] ? moved.row(v) : rest.displacement.row(rest.row.at(v));
            start.push_back(rail.nearest(x));
            target.push_back(start.back() + difference(rail.nearest(x + move), start.back(), rail.period()));
        }
        const std::vector<double> end = let_slide(start, target, nodes.slides, rail.period());
        for (std::size_t i = 0; i < nodes.slides.size(); ++i)
            if (nodes.slides[i])
                all.add(nodes.chain.vertices[i], rail.point(end[i]) - rail.point(start[i]));
    }

private:
    const Mesh& mesh_;
    const DirichletBoundary& held_;
    const Matrix& displacement_;
    std::map<Index, Index> row_;      ///< of a vertex among the held ones
    std::map<Index, int> markers_at_; ///< how many markers have the vertex
};

} // namespace

BoundaryMove with_sliding(BoundaryMove move, std::vector<SlidingMarker> markers)
{
    return [move = std::move(move), markers = std::move(markers)](
               const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement) {
        const Sliding sliding(mesh, held, displacement);
        std::vector<SlidingChain> chains;
        chains.reserve(markers.size());
        for (const SlidingMarker& marker : markers)
            chains.push_back(sliding.chain_of(marker));
        const Held rest = sliding.without(chains);
        const Matrix moved = move(mesh, rest.boundary, rest.displacement);
        Held all = rest;
        for (std::size_t m = 0; m < markers.size(); ++m)
            sliding.slide(markers[m], chains[m], moved, rest, all);
        return move(mesh, all.boundary, all.displacement);
    };
}

} // namespace morph
