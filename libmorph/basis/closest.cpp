#include "libmorph/basis/closest.h"

#include "libmorph/basis/distance_minima.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kBranches = 8; // local minima looked at per node
// Arc length over node distance that is still a bend between neighbours, not a jump: a half circle has 1.6.
constexpr double kBend = 3;
// Ends of an open curve this close, relative to its size, make it a loop.
constexpr double kEndsMeet = 1e-9;

/// Arc length from the start of a curve to any parameter, by a polyline along it.
class ArcLength {
public:
    explicit ArcLength(const Curve& curve)
    {
        const std::vector<double> breaks = curve.breakpoints();
        Eigen::Vector2d last = curve.point(0);
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
            for (int i = 0; i < kSamples; ++i) {
                const double u = breaks[k] + (breaks[k + 1] - breaks[k]) * i / kSamples;
                last = add(u, last, curve.point(u));
            }
        add(1.0, last, curve.point(curve.closed() ? 0.0 : 1.0));
    }

    double total() const { return length_.back(); }

    double operator()(double u) const
    {
        const auto after = std::upper_bound(parameter_.begin(), parameter_.end() - 1, u);
        const auto k = static_cast<std::size_t>(after - parameter_.begin());
        const double share = (u - parameter_[k - 1]) / (parameter_[k] - parameter_[k - 1]);
        return length_[k - 1] + share * (length_[k] - length_[k - 1]);
    }

private:
    static constexpr int kSamples = 32; // for each polynomial piece

    Eigen::Vector2d add(double u, const Eigen::Vector2d& last, const Eigen::Vector2d& point)
    {
        length_.push_back((length_.empty() ? 0 : length_.back()) + (point - last).norm());
        parameter_.push_back(u);
        return point;
    }

    std::vector<double> parameter_;
    std::vector<double> length_;
};

/// A branch of the curve that a node may belong to.
struct Branch {
    DistanceMinimum minimum;
    double arc = 0; ///< arc length at its parameter
};
using Branches = std::vector<Branch>;

/// Picks one branch for each node of a sequence (Viterbi's algorithm).
class BranchChoice {
public:
    BranchChoice(const Points2& nodes, const std::vector<Branches>& branches, double size, double loop_length)
        : nodes_(nodes), branches_(branches), size_(size), loop_length_(loop_length)
    {
    }

    struct Path {
        double cost = 0;
        std::vector<std::size_t> branch; ///< of each node
    };

    /// The sequence of least cost whose parameters grow (@p direction 1) or fall (-1).
    ///
    /// A closed sequence is passed twice and the answer taken from the middle, where neither end of
    /// what was passed has a say.
    Path choose(double direction, bool closed) const
    {
        const std::size_t count = branches_.size();
        const std::size_t length = closed ? 2 * count : count;
        std::vector<double> cost = own_costs(0);
        std::vector<std::vector<std::size_t>> from(length);
        for (std::size_t step = 1; step < length; ++step)
            cost = advance(cost, (step - 1) % count, step % count, direction, from[step]);
        const auto best = std::min_element(cost.begin(), cost.end());
        Path path{*best, std::vector<std::size_t>(count)};
        auto branch = static_cast<std::size_t>(best - cost.begin());
        const std::size_t first = closed ? count / 2 : 0;
        for (std::size_t step = length; step-- > first;) {
            if (step < first + count)
                path.branch[step % count] = branch;
            if (step > 0)
                branch = from[step][branch];
        }
        return path;
    }

private:
    /// How much farther than the nearest branch each one is, times the node's share of the curve.
    std::vector<double> own_costs(std::size_t node) const
    {
        const auto count = static_cast<Eigen::Index>(branches_.size());
        const auto i = static_cast<Eigen::Index>(node);
        const double spacing = (nodes_.row((i + 1) % count) - nodes_.row(i)).norm();
        const double share = size_ > 0 ? std::min(spacing / size_, 1.0) : 0.0;
        std::vector<double> costs;
        for (const Branch& branch : branches_[node])
            costs.push_back(share * (branch.minimum.distance - branches_[node].front().minimum.distance));
        return costs;
    }

    double jump(const Branch& a, const Branch& b, double distance, double direction) const
    {
        double ahead = direction * (b.arc - a.arc);
        if (loop_length_ > 0) { // a step back is short: most of the loop is ahead
            ahead -= loop_length_ * std::floor(ahead / loop_length_);
            if (ahead > 0.75 * loop_length_)
                ahead -= loop_length_;
        }
        return ahead < 0 ? -ahead : std::max(0.0, ahead - kBend * distance);
    }

    std::vector<double> advance(const std::vector<double>& cost, std::size_t last, std::size_t node,
                                double direction, std::vector<std::size_t>& from) const
    {
        const double distance =
            (nodes_.row(static_cast<Eigen::Index>(node)) - nodes_.row(static_cast<Eigen::Index>(last)))
                .norm();
        std::vector<double> next = own_costs(node);
        from.resize(next.size());
        for (std::size_t b = 0; b < next.size(); ++b) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t a = 0; a < cost.size(); ++a) {
                const double sum =
                    cost[a] + jump(branches_[last][a], branches_[node][b], distance, direction);
                if (sum < least) {
                    least = sum;
                    from[b] = a;
                }
            }
            next[b] += least;
        }
        return next;
    }

    const Points2& nodes_;
    const std::vector<Branches>& branches_;
    double size_;
    double loop_length_; ///< 0: the curve is no loop
};

std::vector<Branches> find_branches(const DistanceMinima& minima, const ArcLength& arc, const Points2& nodes)
{
    std::vector<Branches> branches(static_cast<std::size_t>(nodes.rows()));
    parallel_for(branches.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const DistanceMinimum& minimum :
                 minima.find(nodes.row(static_cast<Eigen::Index>(i)).transpose(), kBranches))
                branches[i].push_back({minimum, arc(minimum.u)});
    });
    return branches;
}

void require_nodes(const Points2& nodes)
{
    if (nodes.rows() == 0)
        throw InputError("there are no nodes to be placed on the curve");
    for (Eigen::Index i = 0; i < nodes.rows(); ++i)
        if (!nodes.row(i).allFinite())
            throw InputError("node " + std::to_string(i) + " of the sequence is not finite");
}

} // namespace

CurveParameter closest_parameter(const Curve& curve, const Eigen::Vector2d& point)
{
    const DistanceMinimum nearest = DistanceMinima(curve).find(point, 1).front();
    return {nearest.u, nearest.distance};
}

std::vector<CurveParameter> node_parameters(const Curve& curve, const Points2& nodes, bool closed)
{
    require_nodes(nodes);
    const DistanceMinima minima(curve);
    const double gap = curve.closed() ? 0 : (curve.point(1) - curve.point(0)).norm();
    const bool loop = gap <= kEndsMeet * minima.size();
    if (closed && !loop)
        throw InputError("the nodes form a closed loop, but the curve is open: its ends do not meet");

    const ArcLength arc(curve);
    const std::vector<Branches> branches = find_branches(minima, arc, nodes);
    const BranchChoice choice(nodes, branches, minima.size(), loop ? arc.total() : 0);
    const BranchChoice::Path forwards = choice.choose(1, closed);
    const BranchChoice::Path backwards = choice.choose(-1, closed);
    const BranchChoice::Path& path = backwards.cost < forwards.cost ? backwards : forwards;
    std::vector<CurveParameter> parameters;
    for (std::size_t i = 0; i < branches.size(); ++i) {
        const DistanceMinimum& chosen = branches[i][path.branch[i]].minimum;
        parameters.push_back({chosen.u, chosen.distance});
    }
    return parameters;
}

} // namespace morph
