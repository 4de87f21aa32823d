#include "libmorph/remesh/smoothing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr double kGoodStar =
    0.6; // a move may lower the worst of a star down to this, for the sake of the others

/// A vertex nearer to where it wants to be than this part of the size wanted stays, so that a mesh that was
/// relaxed once is left as it is and does not drift on.
constexpr double kSettled = 0.04;
constexpr double kSettledStar = 0.8; // unless a triangle there is worse

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Where a free vertex wants to be: the mean of the tips of equilateral triangles over the sides opposite to
/// it, bad triangles first.
Eigen::Vector3d wanted_place(const RemeshState& made, Index v)
{
    constexpr double kHeight = 0.8660254037844386;
    constexpr double kFloor = 0.05; // of the quality, which is divided by
    const CornerTable& net = made.net;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    net.around(v, [&](Index h) {
        const Eigen::Vector3d &b = net.point(net.to(h)), &c = net.point(net.apex(h));
        const Eigen::Vector3d side = c - b, middle = (b + c) / 2;
        Eigen::Vector3d up;
        if (made.planar)
            up = {-side.y(), side.x(), 0};
        else {
            const Eigen::Vector3d rise = net.point(v) - middle;
            up = rise - rise.dot(side) / std::max(side.squaredNorm(), 1e-300) * side;
            up *= side.norm() / std::max(up.norm(), 1e-300);
        }
        const double quality = std::max(triangle_quality(net.point(v), b, c, made.planar), kFloor);
        const double weight = 1 / (quality * quality);
        sum += weight * (middle + kHeight * up);
        total += weight;
    });
    return sum / total;
}

void relax_free(RemeshState& made, Index v)
{
    constexpr int kHalvings = 2;
    const Eigen::Vector3d old = made.net.point(v);
    const Eigen::Vector3d goal = wanted_place(made, v);
    const double quality = star_quality(made, v, old), before = std::min(quality, kGoodStar);
    if (quality > kSettledStar && (goal - old).norm() < kSettled * made.net.vertices[at(v)].size)
        return;
    double step = 1;
    for (int i = 0; i <= kHalvings; ++i, step /= 2) {
        TableVertex moved = made.net.vertices[at(v)];
        place_free(made, moved, old + step * (goal - old));
        const double after = star_quality(made, v, moved.point);
        if (after < 0 || after < before)
            continue;
        made.net.vertices[at(v)] = moved;
        return;
    }
}

/// The parameter on its curve where a vertex has both neighbours on it at the same part of the length wanted.
double wanted_parameter(const RemeshState& made, Index v)
{
    const CornerTable& net = made.net;
    const TableVertex& vertex = net.vertices[at(v)];
    double ahead = 0, behind = 0, ahead_size = 1, behind_size = 1;
    const auto look = [&](Index h, bool outgoing) {
        const Index mark = net.tag[at(h)];
        if (mark < 0 || mark == kKeptTag || mark / 2 != vertex.curve)
            return;
        const Index other = outgoing ? net.to(h) : net.from[at(h)];
        const double length = (net.point(other) - vertex.point).norm();
        const double size = (vertex.size + net.vertices[at(other)].size) / 2;
        if ((mark % 2 == 0) == outgoing) {
            ahead = length;
            ahead_size = size;
        } else {
            behind = length;
            behind_size = size;
        }
    };
    Index last = -1;
    net.around(v, [&](Index h) {
        look(h, true);
        last = CornerTable::previous(h);
    });
    if (net.twin[at(last)] < 0)
        look(last, false);
    const double wanted = (ahead + behind) * behind_size / (ahead_size + behind_size);
    return vertex.u + (wanted - behind) / made.curves[at(vertex.curve)].tangent(vertex.u).norm();
}

void relax_on_curve(RemeshState& made, Index v)
{
    constexpr double kDamping = 0.5;
    const TableVertex& old = made.net.vertices[at(v)];
    const double step = kDamping * (wanted_parameter(made, v) - old.u);
    const FeatureCurve& line = made.curves[at(old.curve)];
    if (std::abs(step) * line.tangent(old.u).norm() < kDamping * kSettled * old.size)
        return;
    const double u = old.u + step;
    if (!line.closed() && (u <= line.begin() || u >= line.end()))
        return;
    TableVertex moved = old;
    parametrize_marker(made, moved, old.curve, u);
    const double before = std::min(star_quality(made, v, old.point), kGoodStar);
    const double after = star_quality(made, v, moved.point);
    if (after >= 0 && after >= before)
        made.net.vertices[at(v)] = moved;
}

} // namespace

void relax_vertices(RemeshState& made, int sweeps)
{
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (Index v = 0; v < static_cast<Index>(made.net.vertices.size()); ++v) {
            const TableVertex& vertex = made.net.vertices[at(v)];
            if (vertex.out < 0)
                continue;
            if (vertex.curve == kFreeVertex)
                relax_free(made, v);
            else if (vertex.curve >= 0)
                relax_on_curve(made, v);
        }
}

} // namespace morph
