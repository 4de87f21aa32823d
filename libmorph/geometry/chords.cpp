#include "libmorph/geometry/chords.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

// The sagitta is sampled, so the true one may be a little larger.
constexpr double kSagMargin = 1.5;
constexpr double kFlat = 1e-6;

// Between two nodes, and per unit of the period: enough for curves of many pieces and few nodes.
constexpr int kSamples = 8;
constexpr int kSamplesPerPeriod = 256;

using ChordBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

double distance_to_segment(const Eigen::Vector2d& x, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    const Eigen::Vector2d along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (x - a - t * along).norm();
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool cross_each_other(const Chord& p, const Chord& q)
{
    const Eigen::Vector2d along_p = p.b - p.a;
    const Eigen::Vector2d along_q = q.b - q.a;
    return (cross(along_p, q.a - p.a) > 0) != (cross(along_p, q.b - p.a) > 0) &&
           (cross(along_q, p.a - q.a) > 0) != (cross(along_q, p.b - q.a) > 0);
}

double distance_between(const Chord& p, const Chord& q)
{
    if (cross_each_other(p, q))
        return 0;
    return std::min({distance_to_segment(p.a, q.a, q.b), distance_to_segment(p.b, q.a, q.b),
                     distance_to_segment(q.a, p.a, p.b), distance_to_segment(q.b, p.a, p.b)});
}

bool share_a_node(const Chord& p, const Chord& q)
{
    return p.loop == q.loop &&
           ((p.node + 1) % p.loop_nodes == q.node || (q.node + 1) % q.loop_nodes == p.node);
}

double sag_of(const OutlineLoop& loop, const Chord& chord)
{
    if (loop.is_box)
        return 0;
    const double from = loop.nodes[chord.node].u;
    const double to = chord.node + 1 < loop.nodes.size() ? loop.nodes[chord.node + 1].u
                                                         : loop.nodes.front().u + loop.period;
    const int samples = kSamples + static_cast<int>(kSamplesPerPeriod * (to - from) / loop.period);
    double sagitta = 0;
    for (int k = 1; k < samples; ++k) {
        const OutlineNode between = node_at(loop, from + (to - from) * k / samples);
        sagitta = std::max(sagitta, distance_to_segment(between.point, chord.a, chord.b));
    }
    return sagitta;
}

ChordBox bounding_box(const Chord& chord, std::size_t number, double touching)
{
    const double margin = kSagMargin * chord.sagitta + touching;
    double low[2];
    double high[2];
    for (int c = 0; c < 2; ++c) {
        low[c] = std::min(chord.a[c], chord.b[c]) - margin;
        high[c] = std::max(chord.a[c], chord.b[c]) + margin;
    }
    return {low, high, number};
}

} // namespace

std::vector<Chord> chords_of(const std::vector<OutlineLoop>& loops)
{
    std::vector<Chord> chords;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const std::vector<OutlineNode>& nodes = loops[l].nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            Chord chord{l, i, nodes.size(), nodes[i].point, nodes[(i + 1) % nodes.size()].point};
            chord.sagitta = sag_of(loops[l], chord);
            chords.push_back(chord);
        }
    }
    return chords;
}

std::vector<std::pair<std::size_t, std::size_t>> meeting_chords(const std::vector<Chord>& chords,
                                                                double touching)
{
    std::vector<ChordBox> boxes;
    for (std::size_t i = 0; i < chords.size(); ++i)
        boxes.push_back(bounding_box(chords[i], i, touching));

    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const ChordBox& p, const ChordBox& q) {
        const Chord& first = chords[p.info()];
        const Chord& second = chords[q.info()];
        const double near = kSagMargin * (first.sagitta + second.sagitta) + touching;
        if (!share_a_node(first, second) && distance_between(first, second) <= near)
            pairs.push_back(std::minmax(p.info(), q.info()));
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

bool is_flat(const Chord& chord, double touching)
{
    return chord.sagitta <= std::max(touching, kFlat * (chord.b - chord.a).norm());
}

} // namespace morph
