#include "libmorph/remesh/target_size.h"

#include "libmorph/remesh/hessian_recovery.h"
#include "libmorph/remesh/remesh_state.h"

#include <Eigen/Geometry>

#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace morph {

namespace {

struct Edge {
    Index a, b;
    double length;
};

Edge edge_of(const Mesh& mesh, Index e)
{
    const HalfedgeHandle h(2 * e);
    const Index a = mesh.kernel.from_vertex_handle(h).idx(), b = mesh.kernel.to_vertex_handle(h).idx();
    return {a, b, (points(mesh).row(a) - points(mesh).row(b)).norm()};
}

Index edge_count(const Mesh& mesh)
{
    return static_cast<Index>(mesh.kernel.n_edges());
}

/// There is a triangle on the left of a halfedge.
bool is_triangle(const Mesh& mesh, Index halfedge)
{
    const HalfedgeHandle h(halfedge);
    const auto after = [&](HalfedgeHandle side) { return mesh.kernel.next_halfedge_handle(side); };
    return !mesh.kernel.is_boundary(h) && after(after(after(h))) == h;
}

bool beside_quad(const Mesh& mesh, Index e)
{
    for (const Index h : {2 * e, 2 * e + 1}) {
        const auto face = mesh.kernel.face_handle(HalfedgeHandle(h));
        if (face.is_valid() && element_corners(mesh, face.idx())[3] >= 0)
            return true;
    }
    return false;
}

/// Carries small sizes on from vertex to vertex, the smallest first, as Dijkstra's algorithm does.
class SizeSpread {
public:
    explicit SizeSpread(double gradation) : slope_(gradation - 1) {}

    void start(Index vertex, double size) { waiting_.emplace(size, vertex); }

    /// @param size_of     size_of(v): the size of a vertex, to be changed
    /// @param neighbours  neighbours(v, offer) calls offer(w, distance) for those of a vertex
    template <typename SizeOf, typename Neighbours>
    void run(const SizeOf& size_of, const Neighbours& neighbours)
    {
        while (!waiting_.empty()) {
            const auto [size, v] = waiting_.top();
            waiting_.pop();
            if (size > size_of(v))
                continue;
            neighbours(v, [&, least = size](Index w, double distance) {
                const double most = least + slope_ * distance;
                if (most >= size_of(w))
                    return;
                size_of(w) = most;
                waiting_.emplace(most, w);
            });
        }
    }

private:
    using Entry = std::pair<double, Index>;
    double slope_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

} // namespace

Eigen::VectorXd current_sizes(const Mesh& mesh)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(vertex_count(mesh)), count = sum;
    Eigen::VectorXd quad_sum = sum, quad_count = sum;
    for (Index e = 0; e < edge_count(mesh); ++e) {
        const Edge edge = edge_of(mesh, e);
        const bool of_triangle = is_triangle(mesh, 2 * e) || is_triangle(mesh, 2 * e + 1);
        for (const Index v : {edge.a, edge.b}) {
            (of_triangle ? sum : quad_sum)[v] += edge.length;
            (of_triangle ? count : quad_count)[v] += 1;
        }
    }
    return (count.array() > 0)
        .select(sum.array() / count.array().max(1), quad_sum.array() / quad_count.array().max(1));
}

Eigen::VectorXd interpolation_sizes(const Mesh& mesh, const Matrix& values)
{
    // Of the largest: sizes that differ by a factor of 100. Of range / diagonal^2: rounding of a linear
    // field.
    constexpr double kLeastBendRatio = 1e-6, kLinearBend = 1e-6;
    const auto place = points(mesh);
    const double diagonal2 = (place.colwise().maxCoeff() - place.colwise().minCoeff()).squaredNorm();
    Eigen::VectorXd bend = Eigen::VectorXd::Constant(vertex_count(mesh), kLinearBend / diagonal2);
    for (Index c = 0; c < values.cols(); ++c) {
        const double range = values.col(c).maxCoeff() - values.col(c).minCoeff();
        if (range > 0)
            bend = bend.cwiseMax(largest_second_derivative(mesh, values.col(c) / range));
    }
    bend = bend.cwiseMax(kLeastBendRatio * bend.maxCoeff());
    return bend.array().pow(-1.0 / 3);
}

void limit_gradation(const Mesh& mesh, double gradation, Eigen::VectorXd& sizes)
{
    SizeSpread spread(gradation);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        spread.start(v, sizes[v]);
    const auto place = points(mesh);
    spread.run([&](Index v) -> double& { return sizes[v]; },
               [&](Index v, const auto& offer) {
                   for (auto it = mesh.kernel.cvv_begin(VertexHandle(v)); it.is_valid(); ++it)
                       offer(it->idx(), (place.row(v) - place.row(it->idx())).norm());
               });
}

void limit_gradation(CornerTable& table, double gradation, const std::vector<Index>& from)
{
    SizeSpread spread(gradation);
    for (const Index v : from)
        spread.start(v, table.vertices[static_cast<std::size_t>(v)].size);
    std::vector<Index> near;
    spread.run([&](Index v) -> double& { return table.vertices[static_cast<std::size_t>(v)].size; },
               [&](Index v, const auto& offer) {
                   table.neighbours(v, near);
                   for (const Index w : near)
                       offer(w, (table.point(v) - table.point(w)).norm());
               });
}

void scale_to_vertices(const Mesh& mesh, Index vertices, Eigen::VectorXd& sizes)
{
    const double equilateral = std::sqrt(3.0) / 4;
    double triangles = 0;
    const auto place = points(mesh);
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        if (e[3] >= 0)
            continue;
        const Eigen::RowVector3d ab = place.row(e[1]) - place.row(e[0]),
                                 ac = place.row(e[2]) - place.row(e[0]);
        const double size = (sizes[e[0]] + sizes[e[1]] + sizes[e[2]]) / 3;
        triangles += ab.cross(ac).norm() / 2 / (equilateral * size * size);
    }
    sizes *= std::sqrt(triangles / 2 / vertices); // a triangulation has half as many vertices as triangles
}

SizeConformity edge_conformity(const Mesh& mesh, const Eigen::VectorXd& sizes)
{
    SizeConformity found;
    Index good = 0, edges = 0;
    double farthest = 0;
    for (Index e = 0; e < edge_count(mesh); ++e) {
        if (beside_quad(mesh, e))
            continue;
        ++edges;
        const Edge edge = edge_of(mesh, e);
        const double part = 2 * edge.length / (sizes[edge.a] + sizes[edge.b]);
        good += part >= kShortEdge && part <= kLongEdge ? 1 : 0;
        const double away = std::abs(std::log(part));
        if (away <= farthest)
            continue;
        farthest = away;
        found.worst = {edge.a, edge.b};
        found.relative_length = part;
    }
    if (edges > 0)
        found.share = static_cast<double>(good) / edges;
    return found;
}

double size_conformity(const Mesh& mesh, const Eigen::VectorXd& sizes)
{
    return edge_conformity(mesh, sizes).share;
}

} // namespace morph
