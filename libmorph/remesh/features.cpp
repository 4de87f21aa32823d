#include "libmorph/remesh/features.h"

#include "libmorph/basis/closest.h"
#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Which markers an edge belongs to, and for each whether it runs along the edge.
using Membership = std::vector<std::pair<Index, bool>>;

/// Vertices along feature edges, from one where the line must stop to the next, or all around.
struct Line {
    std::vector<Index> vertices; ///< closed: the first is not repeated
    std::vector<Index> edges;    ///< halfedge or, at a border, its opposite: from vertex i to the next
    bool closed = false;
};

class FeatureFinder {
public:
    FeatureFinder(RemeshState& state, const Mesh& mesh, const FeatureSettings& settings)
        : state_(state), table_(state.table), mesh_(mesh), settings_(settings),
          edges_of_(table_.vertices.size())
    {
    }

    void run()
    {
        collect_markers();
        collect_borders();
        if (!state_.planar)
            collect_creases();
        for (const auto& [h, membership] : edges_) {
            edges_of_[at(table_.from[at(h)])].push_back(h);
            edges_of_[at(table_.to(h))].push_back(h);
        }
        for (std::size_t v = 0; v < edges_of_.size(); ++v)
            if (!edges_of_[v].empty() && must_stop(static_cast<Index>(v)))
                table_.vertices[v].curve = kFixedVertex;
        trace_lines();
    }

private:
    Index standing(Index h) const { return table_.twin[at(h)] < 0 ? h : std::min(h, table_.twin[at(h)]); }

    void collect_markers()
    {
        const TableEdges find(table_, vertex_count(mesh_));
        for (std::size_t m = 0; m < mesh_.markers.size(); ++m)
            for (const auto& [a, b] : mesh_.markers[m].edges) {
                const Index found = find.find(a, b);
                if (found < 0 || table_.tag[at(found)] == kKeptTag)
                    continue;
                const Index h = standing(found);
                edges_[h].emplace_back(static_cast<Index>(m),
                                       table_.vertices[at(table_.from[at(h)])].origin == a);
            }
        for (auto& [h, membership] : edges_)
            std::sort(membership.begin(), membership.end());
    }

    void collect_borders()
    {
        for (Index h = 0; h < static_cast<Index>(table_.from.size()); ++h)
            if (table_.twin[at(h)] < 0 && table_.tag[at(h)] != kKeptTag)
                edges_[h];
    }

    void collect_creases()
    {
        const double cosine = std::cos(settings_.crease_angle * std::numbers::pi / 180);
        std::set<Index> creases;
        for (Index h = 0; h < static_cast<Index>(table_.from.size()); ++h) {
            const Index g = table_.twin[at(h)];
            if (g < h)
                continue;
            const Eigen::Vector3d m = triangle_normal(state_, h / 3), n = triangle_normal(state_, g / 3);
            if (m.dot(n) < cosine * m.norm() * n.norm() && edges_.try_emplace(h).second)
                creases.insert(h);
        }
        drop_noise(creases);
    }

    /// A few creases that are connected to nothing else are slivers of a scanned surface, standing upright:
    /// the smallest thing with creases is a tetrahedron.
    void drop_noise(const std::set<Index>& creases)
    {
        constexpr std::size_t kLeastCreaseEdges = 6;
        std::map<Index, std::vector<Index>> at_vertex;
        for (const auto& [h, membership] : edges_)
            for (const Index v : {table_.from[at(h)], table_.to(h)})
                at_vertex[v].push_back(h);
        std::set<Index> left = creases;
        while (!left.empty()) {
            std::vector<Index> connected{*left.begin()};
            left.erase(left.begin());
            bool only_creases = true;
            for (std::size_t i = 0; i < connected.size(); ++i)
                for (const Index v : {table_.from[at(connected[i])], table_.to(connected[i])})
                    for (const Index other : at_vertex[v]) {
                        if (left.erase(other) > 0)
                            connected.push_back(other);
                        only_creases = only_creases && creases.count(other) > 0;
                    }
            if (only_creases && connected.size() < kLeastCreaseEdges)
                for (const Index h : connected)
                    edges_.erase(h);
        }
    }

    /// Membership of an edge when it is passed from this vertex.
    Membership seen_from(Index vertex, Index h) const
    {
        Membership membership = edges_.at(h);
        if (table_.from[at(h)] != vertex)
            for (auto& [marker, along] : membership)
                along = !along;
        return membership;
    }

    bool must_stop(Index v) const
    {
        const auto& here = edges_of_[at(v)];
        if (table_.vertices[at(v)].curve == kFixedVertex || here.size() != 2)
            return true;
        Membership behind = seen_from(v, here[0]);
        for (auto& [marker, along] : behind)
            along = !along; // it is passed towards v
        return behind != seen_from(v, here[1]);
    }

    Index other_end(Index h, Index v) const
    {
        return table_.from[at(h)] == v ? table_.to(h) : table_.from[at(h)];
    }

    void trace_lines()
    {
        for (const bool closed : {false, true})
            for (const auto& [h, membership] : edges_) {
                const Index a = table_.from[at(h)], b = table_.to(h);
                if (passed_.count(h) != 0)
                    continue;
                const bool a_stops = table_.vertices[at(a)].curve == kFixedVertex;
                const bool b_stops = table_.vertices[at(b)].curve == kFixedVertex;
                if (!closed && !a_stops && !b_stops)
                    continue;
                add_line(trace(closed || a_stops ? a : b, h));
            }
    }

    Line trace(Index start, Index h)
    {
        Line line;
        line.vertices.push_back(start);
        Index v = start;
        while (true) {
            passed_[h] = true;
            line.edges.push_back(h);
            v = other_end(h, v);
            if (v == start && table_.vertices[at(v)].curve != kFixedVertex) {
                line.closed = true;
                return line;
            }
            line.vertices.push_back(v);
            if (table_.vertices[at(v)].curve == kFixedVertex)
                return line;
            const auto& two = edges_of_[at(v)];
            h = two[0] == h ? two[1] : two[0];
        }
    }

    /// Turn of the line at its vertex @p i: axis times angle.
    Eigen::Vector3d turn(const Line& line, std::size_t i) const
    {
        const std::size_t n = line.vertices.size();
        if (!line.closed && (i == 0 || i + 1 == n))
            return Eigen::Vector3d::Zero();
        const auto point = [&](std::size_t k) { return table_.point(line.vertices[k % n]); };
        const Eigen::Vector3d before = point(i) - point(i + n - 1), after = point(i + 1) - point(i);
        const Eigen::Vector3d axis = before.cross(after);
        const double angle = std::atan2(axis.norm(), before.dot(after));
        return axis.norm() > 0 ? Eigen::Vector3d(angle * axis.normalized()) : Eigen::Vector3d(0, 0, angle);
    }

    std::vector<std::size_t> corners(const Line& line) const
    {
        const std::size_t n = line.vertices.size();
        const double least = settings_.corner_angle * std::numbers::pi / 180;
        std::vector<std::size_t> found;
        for (std::size_t i = line.closed ? 0 : 1; i + (line.closed ? 0 : 1) < n; ++i) {
            const Eigen::Vector3d here = turn(line, i);
            const Eigen::Vector3d beside = (turn(line, (i + n - 1) % n) + turn(line, (i + 1) % n)) / 2;
            if (here.norm() - std::max(here.normalized().dot(beside), 0.0) > least)
                found.push_back(i);
        }
        return found;
    }

    const Curve* curve_of(const Line& line) const
    {
        for (const auto& [marker, along] : edges_.at(line.edges.front()))
            for (const MarkerCurve& given : settings_.curves)
                if (given.marker == mesh_.markers[at(marker)].name)
                    return &given.curve;
        return nullptr;
    }

    /// Cut a line at its corners into curves.
    void add_line(Line line)
    {
        const Curve* given = curve_of(line);
        std::vector<double> u;
        if (given != nullptr)
            u = parameters(*given, line);
        std::vector<std::size_t> cuts = corners(line);
        for (const std::size_t i : cuts)
            table_.vertices[at(line.vertices[i])].curve = kFixedVertex;
        if (line.closed && cuts.empty()) {
            add_curve(line, 0, line.vertices.size(), given, u);
            return;
        }
        const std::size_t n = line.vertices.size();
        if (!line.closed) {
            cuts.insert(cuts.begin(), 0);
            cuts.push_back(n - 1);
        } else
            cuts.push_back(cuts.front() + n);
        for (std::size_t i = 1; i < cuts.size(); ++i)
            add_curve(line, cuts[i - 1], cuts[i], given, u);
    }

    /// Parameters of the vertices of a line on a curve, increasing; the line is turned round if need be. A
    /// closed one has that of the first once more, a period later.
    std::vector<double> parameters(const Curve& curve, Line& line) const
    {
        Points2 nodes(static_cast<Eigen::Index>(line.vertices.size()), 2);
        for (std::size_t i = 0; i < line.vertices.size(); ++i)
            nodes.row(static_cast<Eigen::Index>(i)) = table_.point(line.vertices[i]).head<2>();
        std::vector<double> u;
        for (const CurveParameter& found : node_parameters(curve, nodes, line.closed))
            u.push_back(found.u);
        if (line.closed)
            u.push_back(u.front());
        double run = 0;
        for (std::size_t i = 1; i < u.size(); ++i) {
            double step = u[i] - u[i - 1];
            if (curve.closed())
                step -= std::round(step);
            run += step;
        }
        if (run < 0) {
            std::reverse(u.begin(), u.end());
            std::reverse(line.edges.begin(), line.edges.end());
            std::reverse(line.vertices.begin() + (line.closed ? 1 : 0), line.vertices.end());
        }
        for (std::size_t i = 1; i < u.size(); ++i)
            while (curve.closed() && u[i] <= u[i - 1])
                u[i] += 1;
        return u;
    }

    /// The part of a line from its vertex @p first to its vertex @p last, counted on around a closed one.
    void add_curve(const Line& line, std::size_t first, std::size_t last, const Curve* given,
                   const std::vector<double>& u)
    {
        const std::size_t n = line.vertices.size();
        const bool whole = line.closed && last - first == n &&
                           table_.vertices[at(line.vertices[first % n])].curve != kFixedVertex;
        std::vector<Eigen::Vector3d> nodes;
        for (std::size_t i = first; i < last + (whole ? 0 : 1); ++i)
            nodes.push_back(table_.point(line.vertices[i % n]));
        const auto parameter = [&](std::size_t i) { return i < u.size() ? u[i] : u[i - n] + 1; };
        const auto number = static_cast<Index>(state_.curves.size());
        if (given != nullptr)
            state_.curves.emplace_back(*given, parameter(first), parameter(last), whole);
        else
            state_.curves.emplace_back(
                nodes, whole, state_.planar ? FeatureCurve::Shape::smooth : FeatureCurve::Shape::straight);
        for (std::size_t i = first; i < last; ++i) {
            const Index h = line.edges[i % n], start = line.vertices[i % n];
            const bool along = table_.from[at(h)] == start;
            table_.tag[at(h)] = 2 * number + (along ? 0 : 1);
            if (table_.twin[at(h)] >= 0)
                table_.tag[at(table_.twin[at(h)])] = table_.tag[at(h)] ^ 1;
            TableVertex& vertex = table_.vertices[at(start)];
            if (vertex.curve == kFixedVertex)
                continue;
            vertex.curve = number;
            vertex.u = given != nullptr ? parameter(i) : state_.curves.back().node_parameter(i - first);
        }
    }

    RemeshState& state_;
    CornerTable& table_;
    const Mesh& mesh_;
    const FeatureSettings& settings_;
    std::map<Index, Membership> edges_; ///< by the halfedge that stands for the edge
    std::vector<std::vector<Index>> edges_of_;
    std::map<Index, bool> passed_;
};

} // namespace

TableEdges::TableEdges(const CornerTable& table, Index mesh_vertices)
    : table_(table), first_(at(mesh_vertices), -1), next_of_same_(table.vertices.size(), -1)
{
    for (std::size_t v = table.vertices.size(); v-- > 0;) {
        const Index origin = table.vertices[v].origin;
        if (table.vertices[v].out < 0 || origin < 0)
            continue;
        next_of_same_[v] = first_[at(origin)];
        first_[at(origin)] = static_cast<Index>(v);
    }
}

Index TableEdges::find_directed(Index from, Index to) const
{
    Index found = -1;
    for (Index v = first_[at(from)]; v >= 0; v = next_of_same_[at(v)])
        table_.around(v, [&](Index h) {
            if (table_.vertices[at(table_.to(h))].origin == to)
                found = h;
        });
    return found;
}

Index TableEdges::find(Index from, Index to) const
{
    const Index found = find_directed(from, to);
    return found >= 0 ? found : find_directed(to, from);
}

void find_features(RemeshState& state, const Mesh& mesh, const FeatureSettings& settings)
{
    for (const MarkerCurve& given : settings.curves)
        marker(mesh, given.marker); // names the nearest one where it is missing
    FeatureFinder(state, mesh, settings).run();
}

} // namespace morph
