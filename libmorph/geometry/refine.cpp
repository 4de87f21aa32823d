#include "libmorph/geometry/refine.h"

#include "libmorph/core/error.h"
#include "libmorph/core/progress.h"
#include "libmorph/geometry/small_corners.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace morph {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Point = Triangulation::Point;
using Triple = std::array<Index, 3>;

// Refinement aims a little above kMinMeshAngle; Chew's algorithm ends for angles up to 28.6 degrees.
const double kSineOfAim = std::sin((kMinMeshAngle + 1) * std::numbers::pi / 180);

// Largest circumradius, as a part of that of the equilateral triangle of the target size. Refinement
// leaves triangles of all sizes below its limit; with this their edges have the target size on average.
constexpr double kRadiusAllowance = 1.4;

// A new vertex that sees a boundary edge under more than 135 degrees is too near to it.
const double kCosineTooNear = -std::sqrt(0.5);

// Vertices from one report to the next.
constexpr Index kProgressStep = 10000;

// No boundary edge is split below this part of its loop.
constexpr double kShortestPart = 1e-9;

Eigen::Vector2d vec(const Point& p)
{
    return {p.x(), p.y()};
}

Eigen::Vector2d vec(VertexHandle v)
{
    return vec(v->point());
}

bool sees_flat(const Eigen::Vector2d& x, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    const Eigen::Vector2d to_a = a - x;
    const Eigen::Vector2d to_b = b - x;
    return to_a.dot(to_b) < kCosineTooNear * to_a.norm() * to_b.norm();
}

/// Circumcentre, its radius and the shortest edge of a triangle.
struct Circle {
    Eigen::Vector2d centre;
    double radius = 0;
    double shortest = 0;
    int shortest_opposite = 0; ///< corner opposite to the shortest edge
};

Circle circumcircle(FaceHandle f)
{
    const Eigen::Vector2d a = vec(f->vertex(0));
    const Eigen::Vector2d b = vec(f->vertex(1)) - a;
    const Eigen::Vector2d c = vec(f->vertex(2)) - a;
    const double twice_area = b.x() * c.y() - b.y() * c.x();
    const double bb = b.squaredNorm();
    const double cc = c.squaredNorm();
    const Eigen::Vector2d to_centre =
        Eigen::Vector2d(c.y() * bb - b.y() * cc, b.x() * cc - c.x() * bb) / (2 * twice_area);
    const std::array<double, 3> squares = {(c - b).squaredNorm(), cc, bb};
    const auto least = std::min_element(squares.begin(), squares.end());
    return {a + to_centre, to_centre.norm(), std::sqrt(*least), static_cast<int>(least - squares.begin())};
}

class Refiner {
public:
    Refiner(const std::vector<OutlineLoop>& loops, const SizeField& size, Index max_vertices, double expected)
        : loops_(loops), size_(size), max_vertices_(max_vertices), expected_(expected), corners_(loops)
    {
        insert_loops();
    }

    void run()
    {
        // Sizes first: the long thin triangles between boundaries far apart vanish of themselves, and
        // no boundary edge is split for their sake.
        while (pass()) {
        }
        angles_too_ = true;
        while (pass()) {
        }
    }

    Refined result() const;

private:
    struct Vertex {
        VertexHandle handle; ///< null: removed again
        Index loop = -1;
        double u = 0;
        double size = 0; ///< target there
        BoundaryPlace place;
    };

    /// Where the way to a new vertex ends: in a face, or before a boundary edge of it.
    struct Walk {
        FaceHandle face;
        int blocked_by = -1;
    };

    void insert_loops();
    Index add_vertex(VertexHandle handle, Index loop, double u, BoundaryPlace place);
    bool in_domain(FaceHandle f) const;
    bool spoilt_by_corner(FaceHandle f, const Circle& circle) const;
    bool too_thin(FaceHandle f, const Circle& circle) const;
    bool too_large(FaceHandle f, const Circle& circle) const;

    bool pass();
    void enqueue(FaceHandle f);
    void enqueue_around(VertexHandle v);
    FaceHandle find_face(const Triple& corners) const;
    bool repair(FaceHandle f);
    Walk walk_to(const Point& target, FaceHandle from) const;

    bool split(FaceHandle f, int edge);
    void clear_circle(VertexHandle a, VertexHandle b);
    double split_parameter(const Vertex& from, const Vertex& to) const;
    VertexHandle replace_edge(VertexHandle a, VertexHandle b, const Eigen::Vector2d& between);

    const std::vector<OutlineLoop>& loops_;
    const SizeField& size_;
    Index max_vertices_;
    double expected_;
    SmallCorners corners_;
    Triangulation triangulation_;
    std::vector<Vertex> vertices_;
    std::deque<Triple> tasks_; ///< corners of triangles to be repaired, if they still exist
    bool angles_too_ = false;
};

Index Refiner::add_vertex(VertexHandle handle, Index loop, double u, BoundaryPlace place)
{
    if (triangulation_.number_of_vertices() > static_cast<std::size_t>(max_vertices_))
        throw InputError("the mesh would have more than " + std::to_string(max_vertices_) +
                         " vertices; use a larger size or fewer nodes");
    const auto number = static_cast<Index>(vertices_.size());
    handle->info() = number;
    vertices_.push_back({handle, loop, u, size_(vec(handle)), place});
    if (number % kProgressStep == 0)
        report_progress("meshing", std::min(0.99, number / expected_));
    return number;
}

void Refiner::insert_loops()
{
    FaceHandle hint;
    for (std::size_t l = 0; l < loops_.size(); ++l) {
        const std::vector<OutlineNode>& nodes = loops_[l].nodes;
        std::vector<VertexHandle> handles;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            handles.push_back(triangulation_.insert(Point(nodes[i].point.x(), nodes[i].point.y()), hint));
            hint = handles.back()->face();
            add_vertex(handles.back(), static_cast<Index>(l), nodes[i].u, BoundaryPlace::at_node(i));
        }
        for (std::size_t i = 0; i < nodes.size(); ++i)
            triangulation_.insert_constraint(handles[i], handles[(i + 1) % nodes.size()]);
    }
}

/// A triangle lies in a hole exactly if its corners are nodes of one curve and run round it as the curve
/// itself does: any triangle between nodes of a polygon that lies outside of it runs the other way.
bool Refiner::in_domain(FaceHandle f) const
{
    if (triangulation_.is_infinite(f))
        return false;
    std::array<const Vertex*, 3> v{};
    for (int i = 0; i < 3; ++i)
        v[i] = &vertices_[f->vertex(i)->info()];
    if (v[0]->loop < 0 || v[0]->loop != v[1]->loop || v[0]->loop != v[2]->loop)
        return true;
    const OutlineLoop& loop = loops_[v[0]->loop];
    const int descents = (v[0]->u > v[1]->u) + (v[1]->u > v[2]->u) + (v[2]->u > v[0]->u);
    return loop.is_box || loop.counter_clockwise != (descents == 1);
}

/// The angle is bounded by a small corner of the input: refining there would not end.
bool Refiner::spoilt_by_corner(FaceHandle f, const Circle& circle) const
{
    const int apex = circle.shortest_opposite;
    if (f->is_constrained(Triangulation::cw(apex)) && f->is_constrained(Triangulation::ccw(apex)))
        return true;
    const Vertex& a = vertices_[f->vertex(Triangulation::cw(apex))->info()];
    const Vertex& b = vertices_[f->vertex(Triangulation::ccw(apex))->info()];
    return a.loop >= 0 && a.loop == b.loop && corners_.between(a.loop, a.place, b.place);
}

bool Refiner::too_thin(FaceHandle f, const Circle& circle) const
{
    return circle.shortest < 2 * kSineOfAim * circle.radius && !spoilt_by_corner(f, circle);
}

bool Refiner::too_large(FaceHandle f, const Circle& circle) const
{
    double wanted = 0;
    for (int i = 0; i < 3; ++i)
        wanted += vertices_[f->vertex(i)->info()].size / 3;
    return circle.radius * std::sqrt(3.0) > kRadiusAllowance * wanted;
}

/// Repair every bad triangle, and those that a repair creates.
/// @return something was done
bool Refiner::pass()
{
    for (const FaceHandle f : triangulation_.finite_face_handles())
        enqueue(f);
    bool changed = false;
    while (!tasks_.empty()) {
        const FaceHandle f = find_face(tasks_.front());
        tasks_.pop_front();
        if (f != FaceHandle() && repair(f))
            changed = true;
    }
    return changed;
}

void Refiner::enqueue(FaceHandle f)
{
    if (!in_domain(f))
        return;
    const Circle circle = circumcircle(f);
    if (too_large(f, circle) || (angles_too_ && too_thin(f, circle)))
        tasks_.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
}

void Refiner::enqueue_around(VertexHandle v)
{
    Triangulation::Face_circulator f = triangulation_.incident_faces(v);
    const Triangulation::Face_circulator end = f;
    do {
        enqueue(f);
    } while (++f != end);
}

FaceHandle Refiner::find_face(const Triple& corners) const
{
    std::array<VertexHandle, 3> v;
    for (int i = 0; i < 3; ++i) {
        v[i] = vertices_[corners[i]].handle;
        if (v[i] == VertexHandle())
            return {};
    }
    FaceHandle f;
    return triangulation_.is_face(v[0], v[1], v[2], f) ? f : FaceHandle();
}

/// Put a vertex at the circumcentre of a flawed triangle or, where a boundary edge is in the way of a
/// good angle, split that edge.
bool Refiner::repair(FaceHandle f)
{
    const Circle circle = circumcircle(f);
    const Point centre(circle.centre.x(), circle.centre.y());
    const Walk walk = walk_to(centre, f);
    if (walk.blocked_by >= 0)
        return angles_too_ && too_thin(f, circle) && split(walk.face, walk.blocked_by);
    const std::size_t before = triangulation_.number_of_vertices();
    const VertexHandle made = triangulation_.insert(centre, walk.face);
    if (triangulation_.number_of_vertices() == before)
        return false;
    add_vertex(made, -1, 0, {});
    enqueue_around(made);
    return true;
}

/// From face to face towards a point. In a constrained Delaunay triangulation each step lowers the power
/// of the point to the circumcircle, so the walk ends.
Refiner::Walk Refiner::walk_to(const Point& target, FaceHandle from) const
{
    FaceHandle f = from;
    for (;;) {
        int leave = -1;
        for (int i = 0; i < 3; ++i) {
            const Point& a = f->vertex(Triangulation::ccw(i))->point();
            const Point& b = f->vertex(Triangulation::cw(i))->point();
            const CGAL::Orientation side = CGAL::orientation(a, b, target);
            if (f->is_constrained(i) && (side != CGAL::LEFT_TURN || sees_flat(vec(target), vec(a), vec(b))))
                return {f, i};
            if (side == CGAL::RIGHT_TURN)
                leave = i;
        }
        if (leave < 0)
            return {f, -1};
        f = f->neighbor(leave);
    }
}

/// Put a node of the loop between the ends of a boundary edge.
bool Refiner::split(FaceHandle f, int edge)
{
    const VertexHandle a = f->vertex(Triangulation::ccw(edge));
    const VertexHandle b = f->vertex(Triangulation::cw(edge));
    Vertex from = vertices_[a->info()];
    Vertex to = vertices_[b->info()];
    const OutlineLoop& loop = loops_[from.loop];
    // The nodes of an edge are neighbours on the loop, never half of it apart.
    if (std::abs(from.u - to.u) > 0.5 * loop.period)
        (from.u < to.u ? from : to).u += loop.period;
    if (from.u > to.u)
        std::swap(from, to);
    if (to.u - from.u < kShortestPart * loop.period)
        return false;

    clear_circle(a, b);
    const OutlineNode node = node_at(loop, split_parameter(from, to));
    const VertexHandle made = replace_edge(a, b, node.point);
    add_vertex(made, from.loop, node.u, BoundaryPlace::between(from.place, to.place));
    enqueue_around(made);
    return true;
}

/// Remove the vertices inside the domain that lie in the circle over a boundary edge: the new node and
/// its edges need the room. As the triangle at the edge has an empty circumcircle, one of them is its
/// apex as long as there are any.
void Refiner::clear_circle(VertexHandle a, VertexHandle b)
{
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        for (;;) {
            FaceHandle f;
            int edge = 0;
            if (!triangulation_.is_edge(from, to, f, edge))
                throw SolverError("the refinement lost a boundary edge");
            const VertexHandle apex = f->vertex(edge);
            if (triangulation_.is_infinite(apex) || vertices_[apex->info()].loop >= 0 ||
                (vec(from) - vec(apex)).dot(vec(to) - vec(apex)) >= 0)
                break;
            vertices_[apex->info()].handle = VertexHandle();
            triangulation_.remove(apex);
        }
    }
}

/// Halfway in u; at a small corner where the distance from it is a power of two, so that the edges on
/// both sides of it are split alike and do not provoke each other [Ruppert 1995, 5].
double Refiner::split_parameter(const Vertex& from, const Vertex& to) const
{
    const bool corner_first = corners_.is_small(from.loop, from.place);
    if (corner_first == corners_.is_small(to.loop, to.place))
        return 0.5 * (from.u + to.u);
    const OutlineLoop& loop = loops_[from.loop];
    const Eigen::Vector2d corner = vec(corner_first ? from.handle : to.handle);
    const double shell = std::exp2(std::round(std::log2(0.5 * (vec(from.handle) - vec(to.handle)).norm())));
    double near = corner_first ? from.u : to.u;
    double far = corner_first ? to.u : from.u;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (near + far);
        ((node_at(loop, middle).point - corner).norm() < shell ? near : far) = middle;
    }
    return 0.5 * (near + far);
}

VertexHandle Refiner::replace_edge(VertexHandle a, VertexHandle b, const Eigen::Vector2d& between)
{
    FaceHandle f;
    int edge = 0;
    triangulation_.is_edge(a, b, f, edge);
    triangulation_.remove_constrained_edge(f, edge);
    const std::size_t before = triangulation_.number_of_vertices();
    const VertexHandle made = triangulation_.insert(Point(between.x(), between.y()), a->face());
    if (triangulation_.number_of_vertices() == before)
        throw SolverError("the refinement put two nodes of a boundary at the same place");
    triangulation_.insert_constraint(a, made);
    triangulation_.insert_constraint(made, b);
    return made;
}

Refined Refiner::result() const
{
    Refined refined;
    std::vector<Index> number(vertices_.size(), -1);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Vertex& v = vertices_[i];
        if (v.handle == VertexHandle())
            continue;
        number[i] = static_cast<Index>(refined.vertices.size());
        refined.vertices.push_back({vec(v.handle), v.loop, v.u});
    }
    for (const FaceHandle f : triangulation_.finite_face_handles())
        if (in_domain(f))
            refined.triangles.push_back(
                {number[f->vertex(0)->info()], number[f->vertex(1)->info()], number[f->vertex(2)->info()]});
    return refined;
}

} // namespace

Refined refine(const std::vector<OutlineLoop>& loops, const SizeField& size, Index max_vertices,
               double expected_vertices)
{
    try {
        Refiner refiner(loops, size, max_vertices, expected_vertices);
        refiner.run();
        report_progress("meshing", 1);
        return refiner.result();
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        throw SolverError("the boundaries come too near each other to be meshed with so few nodes");
    }
}

} // namespace morph
