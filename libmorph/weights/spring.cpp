#include "libmorph/weights/spring.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/dirichlet_laplacian.h"
#include "libmorph/weights/energy_extension.h"

#include <cmath>
#include <string>

namespace morph {

namespace {

/// length^-p
double stiffness_of(double length, SpringStiffness stiffness)
{
    return stiffness == SpringStiffness::inverse_length ? 1 / length : 1 / (length * length);
}

std::string name_of(const Mesh& mesh, Index vertex)
{
    return std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(vertex)]);
}

std::vector<WeightedEdge> springs(const Mesh& mesh, const std::vector<Index>& representatives,
                                  SpringStiffness stiffness)
{
    std::vector<WeightedEdge> edges;
    edges.reserve(mesh.kernel.n_edges());
    for (const auto edge : mesh.kernel.edges()) {
        const Index from = edge.v0().idx(), to = edge.v1().idx();
        const double length = (points(mesh).row(from) - points(mesh).row(to)).norm();
        if (!(length > 0))
            throw InputError("the edge between vertices " + name_of(mesh, from) + " and " +
                             name_of(mesh, to) + " has no length: no spring can stand for it");
        edges.push_back({representatives[static_cast<std::size_t>(from)],
                         representatives[static_cast<std::size_t>(to)], stiffness_of(length, stiffness)});
    }
    return edges;
}

class SpringExtension final : public BoundaryExtension {
public:
    SpringExtension(const Mesh& mesh, const DirichletBoundary& boundary, SpringStiffness stiffness)
        : BoundaryExtension(mesh, boundary),
          problem_(points(mesh).leftCols<2>(), springs(mesh, held().representatives(), stiffness),
                   held().vertices())
    {
    }

private:
    Matrix solve(const Matrix& joined) const override { return problem_.solve(joined); }

    DirichletLaplacian problem_;
};

/// One corner of an element: a vertex between its two neighbours.
struct Corner {
    Eigen::Vector2d forth, back; // to the next and the previous vertex
    double twice_area;
};

Corner corner_of(const ElementPoints& element, int i)
{
    const Eigen::Vector2d& here = element.at[static_cast<std::size_t>(i)];
    Corner c{element.next(i) - here, element.previous(i) - here, 0};
    c.twice_area = c.forth.x() * c.back.y() - c.forth.y() * c.back.x();
    return c;
}

/// How some length or angle at a corner changes, to first order, with each of the three displacements.
struct Change {
    Eigen::Vector2d previous, here, next;
};

/// Of the angle: each edge turns by (edge x its displacement) / length^2.
Change angle_change(const Corner& c)
{
    const Eigen::Vector2d next = Eigen::Vector2d(-c.forth.y(), c.forth.x()) / c.forth.squaredNorm();
    const Eigen::Vector2d previous = -Eigen::Vector2d(-c.back.y(), c.back.x()) / c.back.squaredNorm();
    return {previous, -previous - next, next};
}

/// Of the height over the line through the neighbours, whose displacement is interpolated at its foot.
Change height_change(const Corner& c)
{
    const Eigen::Vector2d base = c.back - c.forth;
    const Eigen::Vector2d normal = Eigen::Vector2d(-base.y(), base.x()).normalized();
    const double foot = -c.forth.dot(base) / base.squaredNorm(); // 0: at the next vertex, 1: at the previous
    return {-foot * normal, normal, (foot - 1) * normal};
}

/// Add @p spring (change)^2 / 2 to the energy of the element.
void add_corner(const ElementPoints& element, int i, const Change& change, double spring, ElementMatrix& Q)
{
    const int n = element.corners;
    Eigen::Matrix2Xd gradient = Eigen::Matrix2Xd::Zero(2, n);
    gradient.col((i + n - 1) % n) += change.previous;
    gradient.col(i) += change.here;
    gradient.col((i + 1) % n) += change.next;
    gradient *= std::sqrt(spring);
    Q += gradient.reshaped() * gradient.reshaped().transpose();
}

double torsion_stiffness(const Corner& c, SpringStiffness stiffness)
{
    const double lengths = c.forth.norm() * c.back.norm(), sine = c.twice_area / lengths;
    return (stiffness == SpringStiffness::inverse_length ? std::sqrt(lengths) : 1) / (sine * sine);
}

double ball_stiffness(const Corner& c, SpringStiffness stiffness)
{
    return stiffness_of(std::abs(c.twice_area) / (c.forth - c.back).norm(), stiffness);
}

/// The edge from corner i to the next; the element next to it has the other half.
void add_edge(const ElementPoints& element, int i, SpringStiffness stiffness, ElementMatrix& Q)
{
    const Eigen::Vector2d edge = element.next(i) - element.at[static_cast<std::size_t>(i)];
    const Eigen::Vector2d along = edge.normalized();
    add_corner(element, i, {Eigen::Vector2d::Zero(), -along, along},
               0.5 * stiffness_of(edge.norm(), stiffness), Q);
}

} // namespace

std::unique_ptr<BoundaryExtension> spring_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                    SpringStiffness stiffness)
{
    return std::make_unique<SpringExtension>(mesh, boundary, stiffness);
}

std::unique_ptr<BoundaryExtension> braced_spring_extension(const Mesh& mesh,
                                                           const DirichletBoundary& boundary,
                                                           SpringStiffness stiffness, SpringBracing bracing)
{
    if (bracing == SpringBracing::none)
        throw InputError("braced springs need a bracing, torsion or ball-vertex");
    const auto energy = [&](const ElementPoints& element, ElementMatrix& Q) {
        for (int i = 0; i < element.corners; ++i) {
            const Corner corner = corner_of(element, i);
            if (!(corner.twice_area != 0))
                throw InputError(
                    "element " +
                    std::to_string(mesh.numbering.element[static_cast<std::size_t>(element.element)]) +
                    " has three corners on a line: no spring can brace that");
            add_edge(element, i, stiffness, Q);
            if (bracing == SpringBracing::torsion)
                add_corner(element, i, angle_change(corner), torsion_stiffness(corner, stiffness), Q);
            else
                add_corner(element, i, height_change(corner), ball_stiffness(corner, stiffness), Q);
        }
    };
    return std::make_unique<EnergyExtension>(mesh, boundary, energy);
}

} // namespace morph
