#include "libmorph/geometry/outline.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/chords.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace morph {

namespace {

// Samples between two breakpoints that the search for crossings starts from: a polynomial piece of
// low degree does nothing unseen between them.
constexpr int kSamplesPerPiece = 16;

// A corner nearer to a node than this fraction of the node spacing is that node.
constexpr double kSameNode = 1e-6;

std::string quoted(const OutlineLoop& loop)
{
    return loop.is_box ? "the box" : "boundary '" + loop.name + "'";
}

std::string place(const Eigen::Vector2d& x)
{
    std::ostringstream text;
    text << " near (" << x.x() << ", " << x.y() << ")";
    return text.str();
}

OutlineLoop box_loop(const std::array<double, 4>& box)
{
    const double x[] = {box[0], box[2], box[2], box[0], box[0]};
    const double y[] = {box[1], box[1], box[3], box[3], box[1]};
    OutlineLoop loop;
    loop.name = kFarfield;
    loop.period = 4;
    loop.is_box = true;
    loop.point_at = [=](double u) -> Eigen::Vector2d {
        const int side = std::min(3, static_cast<int>(u));
        const double t = u - side;
        // Both coordinates of a corner and the fixed one of a side come out exactly.
        return {x[side] + t * (x[side + 1] - x[side]), y[side] + t * (y[side + 1] - y[side])};
    };
    for (int corner = 0; corner < 4; ++corner)
        loop.nodes.push_back({static_cast<double>(corner), loop.point_at(corner)});
    return loop;
}

OutlineLoop curve_loop(const DomainCurve& given, const std::vector<double>& parameters)
{
    OutlineLoop loop;
    loop.name = given.name;
    loop.point_at = [curve = given.curve](double u) { return curve.point(u); };
    for (const double u : parameters)
        loop.nodes.push_back(node_at(loop, u));
    return loop;
}

std::vector<double> equal_steps(Index nodes)
{
    std::vector<double> u(static_cast<std::size_t>(nodes));
    for (Index i = 0; i < nodes; ++i)
        u[i] = static_cast<double>(i) / nodes;
    return u;
}

/// The nodes asked for, and the corners between them: a chord would cut those off.
std::vector<double> node_parameters(const DomainCurve& given)
{
    std::vector<double> u = equal_steps(given.nodes);
    for (const double corner : given.curve.corners()) {
        const double step = corner * given.nodes;
        if (std::abs(step - std::round(step)) > kSameNode)
            u.push_back(corner);
    }
    std::sort(u.begin(), u.end());
    return u;
}

/// The nodes and so many more that no turn of the curve is missed.
std::vector<double> dense_parameters(const DomainCurve& given)
{
    std::vector<double> u = node_parameters(given);
    const std::vector<double> breaks = given.curve.breakpoints();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 0; k < kSamplesPerPiece; ++k)
            u.push_back(breaks[i] + k * (breaks[i + 1] - breaks[i]) / kSamplesPerPiece);
    std::sort(u.begin(), u.end());
    const double same = kSameNode / static_cast<double>(u.size());
    const auto end = std::unique(u.begin(), u.end(), [same](double a, double b) { return b - a <= same; });
    u.erase(end, u.end());
    return u;
}

/// Add the nodes halfway along the chords named by @p split, per loop a flag for each chord.
void split_chords(std::vector<OutlineLoop>& loops, const std::vector<std::vector<bool>>& split)
{
    for (std::size_t l = 0; l < loops.size(); ++l) {
        std::vector<OutlineNode> nodes;
        for (std::size_t i = 0; i < loops[l].nodes.size(); ++i) {
            nodes.push_back(loops[l].nodes[i]);
            if (split[l][i])
                nodes.push_back(loops[l].middle(i));
        }
        std::sort(nodes.begin(), nodes.end(),
                  [](const OutlineNode& a, const OutlineNode& b) { return a.u < b.u; });
        loops[l].nodes = std::move(nodes);
    }
}

std::vector<std::vector<bool>> no_chord(const std::vector<OutlineLoop>& loops)
{
    std::vector<std::vector<bool>> split(loops.size());
    for (std::size_t l = 0; l < loops.size(); ++l)
        split[l].assign(loops[l].nodes.size(), false);
    return split;
}

/// Add nodes until no chord is far from its piece of the curve.
void follow_curves(std::vector<OutlineLoop>& loops, double shortest)
{
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<std::vector<bool>> split = no_chord(loops);
        for (const Chord& chord : chords_of(loops)) {
            const double length = (chord.b - chord.a).norm();
            const bool far = chord.sagitta > kLargestSag * length;
            if (length <= shortest && (!far || chord.sagitta <= shortest))
                throw InputError(quoted(loops[chord.loop]) + " has two nodes at the same place" +
                                 place(chord.a) + "; use fewer nodes or another curve");
            split[chord.loop][chord.node] = far;
            changed = changed || far;
        }
        if (changed)
            split_chords(loops, split);
    }
}

void refuse_crossing(const OutlineLoop& first, const OutlineLoop& second, const Eigen::Vector2d& where)
{
    if (&first == &second)
        throw InputError(quoted(first) + " crosses or touches itself" + place(where));
    throw InputError(quoted(first) + " crosses or touches " + quoted(second) + place(where));
}

/// Add nodes until no two chords come as near each other as the pieces of curve they stand for may do.
void separate(std::vector<OutlineLoop>& loops, double touching)
{
    for (;;) {
        const std::vector<Chord> chords = chords_of(loops);
        std::vector<std::vector<bool>> split = no_chord(loops);
        bool changed = false;
        for (const auto& [i, j] : meeting_chords(chords, touching)) {
            const Chord& worst = chords[i].sagitta >= chords[j].sagitta ? chords[i] : chords[j];
            if (is_flat(chords[i], touching) && is_flat(chords[j], touching))
                refuse_crossing(loops[chords[i].loop], loops[chords[j].loop], 0.5 * (worst.a + worst.b));
            split[worst.loop][worst.node] = true;
            changed = true;
        }
        if (!changed)
            return;
        split_chords(loops, split);
    }
}

double signed_area(const OutlineLoop& loop)
{
    double twice = 0;
    const Eigen::Vector2d origin = loop.nodes.front().point;
    for (std::size_t i = 1; i + 1 < loop.nodes.size(); ++i) {
        const Eigen::Vector2d a = loop.nodes[i].point - origin;
        const Eigen::Vector2d b = loop.nodes[i + 1].point - origin;
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

bool is_inside(const Eigen::Vector2d& x, const OutlineLoop& loop)
{
    bool inside = false;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        const Eigen::Vector2d& a = loop.nodes[i].point;
        const Eigen::Vector2d& b = loop.nodes[(i + 1) % loop.nodes.size()].point;
        if ((a.y() > x.y()) != (b.y() > x.y()) &&
            x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

/// Each curve in the box and outside all others; they are known not to cross.
void require_side_by_side(const std::vector<OutlineLoop>& loops)
{
    for (std::size_t i = 0; i + 1 < loops.size(); ++i) {
        const Eigen::Vector2d& x = loops[i].nodes.front().point;
        if (!is_inside(x, loops.back()))
            throw InputError(quoted(loops[i]) + " lies outside the box" + place(x));
        for (std::size_t j = 0; j + 1 < loops.size(); ++j)
            if (i != j && is_inside(x, loops[j]))
                throw InputError(quoted(loops[i]) + " lies inside " + quoted(loops[j]) +
                                 ", where nothing is meshed");
    }
}

/// Loops that neither cross nor touch, through the parameters that @p parameters gives for a curve.
std::vector<OutlineLoop>
resolved_loops(const DomainSpec& spec,
               const std::function<std::vector<double>(const DomainCurve&)>& parameters)
{
    std::vector<OutlineLoop> loops;
    for (const DomainCurve& curve : spec.curves)
        loops.push_back(curve_loop(curve, parameters(curve)));
    loops.push_back(box_loop(spec.box));

    const double touching =
        1e-12 * Eigen::Vector2d(spec.box[2] - spec.box[0], spec.box[3] - spec.box[1]).norm();
    follow_curves(loops, touching);
    separate(loops, touching);
    require_side_by_side(loops);
    return loops;
}

} // namespace

OutlineNode node_at(const OutlineLoop& loop, double u)
{
    const double wrapped = u < loop.period ? u : u - loop.period;
    return {wrapped, loop.point_at(wrapped)};
}

OutlineNode OutlineLoop::middle(std::size_t i) const
{
    const double from = nodes[i].u;
    const double to = i + 1 < nodes.size() ? nodes[i + 1].u : nodes.front().u + period;
    return node_at(*this, 0.5 * (from + to));
}

std::vector<OutlineLoop> make_outline(const DomainSpec& spec)
{
    resolved_loops(spec, dense_parameters);
    std::vector<OutlineLoop> loops = resolved_loops(spec, node_parameters);
    for (OutlineLoop& loop : loops)
        loop.counter_clockwise = signed_area(loop) > 0;
    return loops;
}

} // namespace morph
