#include "libmorph/geometry/mesh_domain.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/outline.h"
#include "libmorph/geometry/refine.h"
#include "libmorph/geometry/size_field.h"
#include "libmorph/geometry/small_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

namespace morph {

namespace {

std::string number(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

void require_box(const std::array<double, 4>& box)
{
    for (const double x : box)
        if (!std::isfinite(x))
            throw InputError("the box has a coordinate that is not finite");
    if (!(box[0] < box[2] && box[1] < box[3]))
        throw InputError("the box [" + number(box[0]) + ", " + number(box[1]) + ", " + number(box[2]) + ", " +
                         number(box[3]) + "] has no area; it is [xmin, ymin, xmax, ymax]");
}

void require_size(const DomainSpec& spec)
{
    if (!(std::isfinite(spec.size) && spec.size > 0))
        throw InputError("size is " + number(spec.size) + "; it is the edge length on the box, above 0");
    const double width = spec.box[2] - spec.box[0];
    const double height = spec.box[3] - spec.box[1];
    const double edge = std::min({spec.size, width, height});
    // Equilateral triangles have one vertex for each 0.866 of the square of their edge.
    const double vertices = width / edge * (height / edge) / 0.866;
    if (!(vertices <= spec.max_vertices))
        throw InputError("size " + number(spec.size) + " in a box of " + number(width) + " by " +
                         number(height) + " would give about " + number(vertices) + " vertices; at most " +
                         std::to_string(spec.max_vertices) + " are meshed");
}

void require_curves(const DomainSpec& spec)
{
    std::set<std::string> names = {kFarfield};
    for (const DomainCurve& curve : spec.curves) {
        const std::string who = "boundary '" + curve.name + "'";
        if (curve.name == kFarfield)
            throw InputError(who + " has the name of the box; give the curve another one");
        if (!names.insert(curve.name).second)
            throw InputError(who + " is given twice");
        if (!curve.curve.closed())
            throw InputError(who + " is open; a mesh can be generated around closed curves only");
        if (curve.nodes < 3)
            throw InputError(who + " has nodes = " + std::to_string(curve.nodes) +
                             "; a closed curve needs at least 3");
        if (curve.nodes > spec.max_vertices)
            throw InputError(who + " has nodes = " + std::to_string(curve.nodes) + "; at most " +
                             std::to_string(spec.max_vertices) + " vertices are meshed");
    }
}

/// The target size at a node of a curve is that of its two edges on the curve.
SizeField size_field(const std::vector<OutlineLoop>& loops, const DomainSpec& spec)
{
    std::vector<SizeSample> samples;
    for (const OutlineLoop& loop : loops) {
        const std::size_t n = loop.nodes.size();
        for (std::size_t i = 0; i < n && !loop.is_box; ++i) {
            const double before = (loop.nodes[i].point - loop.nodes[(i + n - 1) % n].point).norm();
            const double after = (loop.nodes[i].point - loop.nodes[(i + 1) % n].point).norm();
            samples.push_back({loop.nodes[i].point, std::sqrt(before * after)});
        }
    }
    return {samples, spec.growth, spec.size};
}

/// Nodes on one side of the box whose distances follow the size field: between two neighbours the
/// integral of 1 / size is the same everywhere.
void divide_side(const OutlineLoop& box, int side, const SizeField& size, Index max_vertices,
                 std::vector<OutlineNode>& nodes)
{
    constexpr double kStep = 0.125; // of the size: it changes by 1 / 40 over it
    const double length = (box.point_at(side + 1) - box.point_at(side)).norm();
    std::vector<double> t = {0};
    std::vector<double> edges = {0}; // that fit between the corner and t
    while (t.back() < 1) {
        const double here = size(box.point_at(side + t.back())) / length;
        const double next = std::min(1.0, t.back() + kStep * here);
        edges.push_back(edges.back() + (next - t.back()) / here);
        t.push_back(next);
        if (edges.back() > max_vertices)
            throw InputError("the mesh would have more than " + std::to_string(max_vertices) +
                             " vertices; use a larger size or fewer nodes");
    }
    const double count = std::max(1.0, std::round(edges.back()));
    std::size_t k = 0;
    for (double i = 0; i < count; ++i) {
        const double wanted = i * edges.back() / count;
        while (edges[k + 1] < wanted)
            ++k;
        const double part = (wanted - edges[k]) / (edges[k + 1] - edges[k]);
        nodes.push_back(node_at(box, side + t[k] + part * (t[k + 1] - t[k])));
    }
}

void divide_box(OutlineLoop& box, const SizeField& size, Index max_vertices)
{
    std::vector<OutlineNode> nodes;
    for (int side = 0; side < 4; ++side)
        divide_side(box, side, size, max_vertices, nodes);
    box.nodes = std::move(nodes);
}

/// About how many vertices there will be: samples of the size all over the box, and what a node of a curve
/// has in front of it until the size has grown to that of the samples' spacing.
double expected_vertices(const std::vector<OutlineLoop>& loops, const SizeField& size, const DomainSpec& spec)
{
    constexpr int kSamples = 64; // a side
    const Eigen::Vector2d cell(Eigen::Vector2d(spec.box[2] - spec.box[0], spec.box[3] - spec.box[1]) /
                               kSamples);
    double expected = 0;
    for (const OutlineLoop& loop : loops)
        expected += static_cast<double>(loop.nodes.size()) / spec.growth;
    for (int i = 0; i < kSamples; ++i)
        for (int j = 0; j < kSamples; ++j) {
            const Eigen::Vector2d x(spec.box[0] + (i + 0.5) * cell.x(), spec.box[1] + (j + 0.5) * cell.y());
            const double edge = std::max(size(x), spec.growth * cell.maxCoeff() / 2);
            expected += cell.prod() / (0.866 * edge * edge);
        }
    return expected;
}

/// The vertices in the order of the mesh: loop by loop along the parameter, then the inside as it is.
std::vector<Index> output_order(const Refined& refined, Index loops)
{
    std::vector<Index> order(refined.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
        const RefinedVertex& p = refined.vertices[a];
        const RefinedVertex& q = refined.vertices[b];
        const Index p_loop = p.loop < 0 ? loops : p.loop;
        const Index q_loop = q.loop < 0 ? loops : q.loop;
        return p_loop != q_loop ? p_loop < q_loop : p.u < q.u;
    });
    return order;
}

/// The edges of a loop whose vertices are first, first + 1, ..., with the domain on their left.
Marker loop_marker(const OutlineLoop& loop, Index first, Index count)
{
    Marker marker{loop.name, {}};
    const bool forward = loop.counter_clockwise == loop.is_box;
    for (Index i = 0; i < count; ++i) {
        const Index from = forward ? i : (count - i) % count;
        const Index to = forward ? (i + 1) % count : count - i - 1;
        marker.edges.push_back({first + from, first + to});
    }
    return marker;
}

MeshData to_mesh_data(const Refined& refined, const std::vector<OutlineLoop>& loops)
{
    const std::vector<Index> order = output_order(refined, static_cast<Index>(loops.size()));
    MeshData data;
    data.points.setZero(static_cast<Eigen::Index>(order.size()), 3);
    std::vector<Index> number_of(order.size());
    std::vector<Index> count(loops.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const RefinedVertex& v = refined.vertices[order[i]];
        data.points.row(static_cast<Eigen::Index>(i)).head<2>() = v.point;
        number_of[order[i]] = static_cast<Index>(i);
        if (v.loop >= 0)
            ++count[v.loop];
    }
    for (const auto& [a, b, c] : refined.triangles)
        data.elements.push_back({number_of[a], number_of[b], number_of[c], -1});
    Index first = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        data.markers.push_back(loop_marker(loops[l], first, count[l]));
        first += count[l];
    }
    return data;
}

double smallest_angle(const Points& points, const Element& element)
{
    double smallest = std::numbers::pi;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d x = points.row(element[i]).head<2>();
        const Eigen::Vector2d a = points.row(element[(i + 1) % 3]).head<2>().transpose() - x;
        const Eigen::Vector2d b = points.row(element[(i + 2) % 3]).head<2>().transpose() - x;
        smallest = std::min(smallest, std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
    }
    return smallest * 180 / std::numbers::pi;
}

/// What was promised is checked, not assumed.
void require_good_angles(const MeshData& data, const SmallCorners& corners)
{
    for (const Element& element : data.elements) {
        const double angle = smallest_angle(data.points, element);
        if (angle >= kMinMeshAngle)
            continue;
        const Eigen::Vector2d x = data.points.row(element[0]).head<2>();
        const auto& discs = corners.discs();
        const bool excused =
            angle > 0 && std::any_of(discs.begin(), discs.end(), [&](const SmallCorners::Disc& d) {
                return (x - d.centre).norm() <= 2 * d.radius;
            });
        if (!excused)
            throw SolverError("the mesh has an angle of " + number(angle) + " degrees near (" +
                              number(x.x()) + ", " + number(x.y()) + "), where at least " +
                              number(kMinMeshAngle) + " were asked for");
    }
}

} // namespace

MeshData mesh_domain(const DomainSpec& spec)
{
    require_box(spec.box);
    require_size(spec);
    require_curves(spec);

    std::vector<OutlineLoop> loops = make_outline(spec);
    const SizeField size = size_field(loops, spec);
    divide_box(loops.back(), size, spec.max_vertices);
    const double expected = expected_vertices(loops, size, spec);
    MeshData data = to_mesh_data(refine(loops, size, spec.max_vertices, expected), loops);
    require_good_angles(data, SmallCorners(loops));
    return data;
}

} // namespace morph
