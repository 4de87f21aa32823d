#include "libmorph/remesh/smoothing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr double kGoodStar =
    0.6; // a move may lower the worst of a star down to this, for the sake of the others

/// A vertex nearer to its target position than this part of the target size stays, so that a mesh that was
/// smoothed once is left as it is and does not drift on.
constexpr double kSettled = 0.04;
constexpr double kSettledStar = 0.8; // unless a triangle there is worse

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// The target position of a free vertex: the mean of the tips of equilateral triangles over the sides
/// opposite to it, bad triangles first.
Eigen::Vector3d target_position(const RemeshState& state, Index v)
{
    constexpr double kHeight = 0.8660254037844386;
    constexpr double kFloor = 0.05; // of the quality, which is divided by
    const CornerTable& table = state.table;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    table.around(v, [&](Index h) {
        const Eigen::Vector3d &b = table.point(table.to(h)), &c = table.point(table.apex(h));
        const Eigen::Vector3d side = c - b, middle = (b + c) / 2;
        Eigen::Vector3d up;
        if (state.planar)
            up = {-side.y(), side.x(), 0};
        else {
            const Eigen::Vector3d rise = table.point(v) - middle;
            up = rise - rise.dot(side) / std::max(side.squaredNorm(), 1e-300) * side;
            up *= side.norm() / std::max(up.norm(), 1e-300);
        }
        const double quality = std::max(triangle_quality(table.point(v), b, c, state.planar), kFloor);
        const double weight = 1 / (quality * quality);
        sum += weight * (middle + kHeight * up);
        total += weight;
    });
    return sum / total;
}

void smooth_free(RemeshState& state, Index v)
{
    constexpr int kHalvings = 2;
    const Eigen::Vector3d old = state.table.point(v);
    const Eigen::Vector3d goal = target_position(state, v);
    const double quality = star_quality(state, v, old), before = std::min(quality, kGoodStar);
    if (quality > kSettledStar && (goal - old).norm() < kSettled * state.table.vertices[at(v)].size)
        return;
    double step = 1;
    for (int i = 0; i <= kHalvings; ++i, step /= 2) {
        TableVertex moved = state.table.vertices[at(v)];
        put_at(state, moved, old + step * (goal - old));
        const double after = star_quality(state, v, moved.point);
        if (after < 0 || after < before)
            continue;
        state.table.vertices[at(v)] = moved;
        return;
    }
}

/// The parameter on its curve where a vertex has both neighbours on it at the same part of the target length.
double target_parameter(const RemeshState& state, Index v)
{
    const CornerTable& table = state.table;
    const TableVertex& vertex = table.vertices[at(v)];
    double ahead = 0, behind = 0, ahead_size = 1, behind_size = 1;
    const auto look = [&](Index h, bool outgoing) {
        const Index mark = table.tag[at(h)];
        if (mark < 0 || mark == kKeptTag || mark / 2 != vertex.curve)
            return;
        const Index other = outgoing ? table.to(h) : table.from[at(h)];
        const double length = (table.point(other) - vertex.point).norm();
        const double size = (vertex.size + table.vertices[at(other)].size) / 2;
        if ((mark % 2 == 0) == outgoing) {
            ahead = length;
            ahead_size = size;
        } else {
            behind = length;
            behind_size = size;
        }
    };
    Index last = -1;
    table.around(v, [&](Index h) {
        look(h, true);
        last = CornerTable::previous(h);
    });
    if (table.twin[at(last)] < 0)
        look(last, false);
    const double wanted = (ahead + behind) * behind_size / (ahead_size + behind_size);
    return vertex.u + (wanted - behind) / state.curves[at(vertex.curve)].tangent(vertex.u).norm();
}

void smooth_on_curve(RemeshState& state, Index v)
{
    constexpr double kDamping = 0.5;
    const TableVertex& old = state.table.vertices[at(v)];
    const double step = kDamping * (target_parameter(state, v) - old.u);
    const FeatureCurve& line = state.curves[at(old.curve)];
    if (std::abs(step) * line.tangent(old.u).norm() < kDamping * kSettled * old.size)
        return;
    const double u = old.u + step;
    if (!line.closed() && (u <= line.begin() || u >= line.end()))
        return;
    TableVertex moved = old;
    put_on_curve(state, moved, old.curve, u);
    const double before = std::min(star_quality(state, v, old.point), kGoodStar);
    const double after = star_quality(state, v, moved.point);
    if (after >= 0 && after >= before)
        state.table.vertices[at(v)] = moved;
}

} // namespace

void smooth_vertices(RemeshState& state, int sweeps)
{
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (Index v = 0; v < static_cast<Index>(state.table.vertices.size()); ++v) {
            const TableVertex& vertex = state.table.vertices[at(v)];
            if (vertex.out < 0)
                continue;
            if (vertex.curve == kFreeVertex)
                smooth_free(state, v);
            else if (vertex.curve >= 0)
                smooth_on_curve(state, v);
        }
}

} // namespace morph
