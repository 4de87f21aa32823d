#include "libmorph/deform/local_measure.h"

#include <limits>

namespace morph {

namespace {

/// Where side p q crosses the line, in coordinates across (s) and along (r) it.
struct Crossing {
    Index p = 0;
    Index q = 0;
    double s_p = 0;
    double s_q = 0;
    double place = 0;   ///< r of the crossing
    double slope_p = 0; ///< dr / ds of the shape at the two ends
    double slope_q = 0;
};

/// A polygon in the coordinates of a line.
struct Sides {
    Eigen::VectorXd s; ///< across the line, from it
    Eigen::VectorXd r; ///< along the line

    Index count() const { return static_cast<Index>(s.size()); }
    Index next(Index i) const { return i + 1 < count() ? i + 1 : 0; }
    Index before(Index i) const { return i > 0 ? i - 1 : count() - 1; }
};

Sides sides_of(const Points& polygon, const Eigen::Vector2d& at, const Eigen::Vector2d& along)
{
    const auto from = polygon.leftCols<2>().rowwise() - at.transpose();
    return {from * Eigen::Vector2d(along.y(), -along.x()), from * along};
}

/// Slope at node i of side p q, from the nodes around i; that of the side where these turn back.
double node_slope(const Sides& sides, Index i, Index p, Index q)
{
    const Index a = sides.before(i);
    const Index b = sides.next(i);
    const double side = sides.s[q] - sides.s[p];
    const double around = sides.s[b] - sides.s[a];
    if (around / side > 0.5)
        return (sides.r[b] - sides.r[a]) / around;
    return (sides.r[q] - sides.r[p]) / side;
}

Crossing crossing_of(const Sides& sides, Index p, Index q)
{
    const double s_p = sides.s[p];
    const double s_q = sides.s[q];
    const double place = sides.r[p] + s_p / (s_p - s_q) * (sides.r[q] - sides.r[p]);
    return {p, q, s_p, s_q, place, node_slope(sides, p, p, q), node_slope(sides, q, p, q)};
}

/// Gradient of the place by s_p, r_p, s_q, r_q, for the slope that runs from node to node.
Eigen::Vector4d gradient_of(const Crossing& c)
{
    const double t = c.s_p / (c.s_p - c.s_q);
    const double slope = (1 - t) * c.slope_p + t * c.slope_q;
    return {-slope * (1 - t), 1 - t, -slope * t, t};
}

/// Second derivative of r_p + t (r_q - r_p), and the bend of the shape on top.
Eigen::Matrix4d hessian_of(const Crossing& c)
{
    const double width = c.s_p - c.s_q;
    const double t = c.s_p / width;
    const double t_p = (1 - t) / width; // derivatives of t by s_p and s_q
    const double t_q = t / width;
    const double rise = -((1 - t) * c.slope_p + t * c.slope_q) * width;
    const double bend = (c.slope_p - c.slope_q) / width;
    const double s_pp = -2 * rise * t_p / width + bend * (1 - t) * (1 - t);
    const double s_pq = rise * (t_p - t_q) / width + bend * (1 - t) * t;
    const double s_qq = 2 * rise * t_q / width + bend * t * t;
    Eigen::Matrix4d H;
    H << s_pp, -t_p, s_pq, t_p, //
        -t_p, 0, -t_q, 0,       //
        s_pq, -t_q, s_qq, t_q,  //
        t_p, 0, t_q, 0;
    return H;
}

/// The two crossings that are farthest apart.
struct Ends {
    Crossing first;
    Crossing last;
    int count = 0;
};

Ends ends_of(const Sides& sides)
{
    Ends ends;
    for (Index p = sides.count() - 1, q = 0; q < sides.count(); p = q++) {
        if ((sides.s[p] < 0) == (sides.s[q] < 0))
            continue;
        const Crossing crossing = crossing_of(sides, p, q);
        if (ends.count == 0 || crossing.place < ends.first.place)
            ends.first = crossing;
        if (ends.count == 0 || crossing.place > ends.last.place)
            ends.last = crossing;
        ++ends.count;
    }
    return ends;
}

} // namespace

LocalMeasure extent_along(const Points& polygon, const Eigen::Vector2d& at, const Eigen::Vector2d& along)
{
    const Ends ends = ends_of(sides_of(polygon, at, along));
    LocalMeasure extent;
    extent.value = std::numeric_limits<double>::quiet_NaN();
    if (ends.count == 0)
        return extent;
    Eigen::Matrix4d turn = Eigen::Matrix4d::Zero(); // from x, y of p and q to s, r of p and q
    turn.topLeftCorner<2, 2>() << along.y(), -along.x(), along.x(), along.y();
    turn.bottomRightCorner<2, 2>() = turn.topLeftCorner<2, 2>();
    extent.value = ends.last.place - ends.first.place;
    extent.points = {ends.last.p, ends.last.q, ends.first.p, ends.first.q};
    extent.gradient.resize(8);
    extent.gradient << turn.transpose() * gradient_of(ends.last), -turn.transpose() * gradient_of(ends.first);
    extent.hessian = Eigen::MatrixXd::Zero(8, 8);
    extent.hessian.topLeftCorner<4, 4>() = turn.transpose() * hessian_of(ends.last) * turn;
    extent.hessian.bottomRightCorner<4, 4>() = -turn.transpose() * hessian_of(ends.first) * turn;
    return extent;
}

LocalMeasure distance_between(const Points& ends, Eigen::Index components)
{
    const Eigen::VectorXd difference = (ends.row(1) - ends.row(0)).head(components);
    const double length = difference.norm();
    LocalMeasure distance{length, {0, 1}, Eigen::VectorXd::Zero(2 * components), {}};
    distance.hessian = Eigen::MatrixXd::Zero(2 * components, 2 * components);
    if (length == 0)
        return distance;
    const Eigen::VectorXd unit = difference / length;
    const Eigen::MatrixXd bend =
        (Eigen::MatrixXd::Identity(components, components) - unit * unit.transpose()) / length;
    distance.gradient << -unit, unit;
    distance.hessian << bend, -bend, -bend, bend;
    return distance;
}

} // namespace morph
