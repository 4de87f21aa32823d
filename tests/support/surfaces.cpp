#include "tests/support/surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <vector>

namespace morph::test {

namespace {

/// Collects triangles; points whose numbers are equal in all three are one vertex.
class SurfaceMaker {
public:
    using Key = std::array<Index, 3>;

    Index vertex(const Key& key, const Eigen::Vector3d& point)
    {
        const auto [found, is_new] = numbers_.emplace(key, static_cast<Index>(points_.size()));
        if (is_new)
            points_.push_back(point);
        return found->second;
    }

    void triangle(Index a, Index b, Index c) { data_.elements.push_back({a, b, c, -1}); }

    void quad(Index a, Index b, Index c, Index d)
    {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    MeshData finish()
    {
        data_.dimension = 3;
        data_.points.resize(static_cast<Index>(points_.size()), 3);
        for (std::size_t i = 0; i < points_.size(); ++i)
            data_.points.row(static_cast<Index>(i)) = points_[i];
        return data_;
    }

private:
    MeshData data_;
    std::map<Key, Index> numbers_;
    std::vector<Eigen::Vector3d> points_;
};

MeshData octants(Index cuts, bool upper_only)
{
    SurfaceMaker maker;
    for (const Index sx : {1, -1})
        for (const Index sy : {1, -1})
            for (const Index sz : {1, -1}) {
                if (upper_only && sz < 0)
                    continue;
                const auto at = [&](Index i, Index j) {
                    const SurfaceMaker::Key key{sx * (cuts - i - j), sy * i, sz * j};
                    const Eigen::Vector3d p(key[0], key[1], key[2]);
                    return maker.vertex(key, p.normalized());
                };
                const auto add = [&](Index a, Index b, Index c) {
                    sx* sy* sz > 0 ? maker.triangle(a, b, c) : maker.triangle(a, c, b);
                };
                for (Index i = 0; i < cuts; ++i)
                    for (Index j = 0; i + j < cuts; ++j) {
                        add(at(i, j), at(i + 1, j), at(i, j + 1));
                        if (i + j + 1 < cuts)
                            add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                    }
            }
    return maker.finish();
}

/// Smooth bumps and dents of a sphere.
double bumpy_radius(const Eigen::Vector3d& p)
{
    return 1 + 0.06 * std::sin(5 * p.x() + 1) * std::cos(4 * p.y()) +
           0.05 * std::sin(6 * p.z()) * std::cos(3 * p.x());
}

} // namespace

MeshData sphere(Index cuts)
{
    return octants(cuts, false);
}

MeshData hemisphere(Index cuts)
{
    return octants(cuts, true);
}

MeshData torus(Index around, Index across)
{
    constexpr double kTube = 0.4;
    SurfaceMaker maker;
    const auto at = [&](Index i, Index j) {
        const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
        const double r = 1 + kTube * std::cos(v);
        return maker.vertex({i % around, j % across, 0},
                            {r * std::cos(u), r * std::sin(u), kTube * std::sin(v)});
    };
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j)
            maker.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return maker.finish();
}

MeshData cube(Index cuts)
{
    SurfaceMaker maker;
    for (int axis = 0; axis < 3; ++axis)
        for (const Index side : {0, cuts}) {
            const auto at = [&](Index i, Index j) {
                SurfaceMaker::Key key{};
                key[static_cast<std::size_t>(axis)] = side;
                key[static_cast<std::size_t>((axis + 1) % 3)] = i;
                key[static_cast<std::size_t>((axis + 2) % 3)] = j;
                return maker.vertex(key, Eigen::Vector3d(key[0], key[1], key[2]) / cuts);
            };
            for (Index i = 0; i < cuts; ++i)
                for (Index j = 0; j < cuts; ++j)
                    side > 0 ? maker.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
                             : maker.quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        }
    return maker.finish();
}

MeshData bent_plate(Index cuts)
{
    SurfaceMaker maker;
    const auto at = [&](Index i, Index j) {
        const double angle = std::numbers::pi / 2 * j / cuts;
        return maker.vertex({i, j, 0}, {std::cos(angle), std::sin(angle), static_cast<double>(i) / cuts});
    };
    for (Index i = 0; i < 2 * cuts; ++i)
        for (Index j = 0; j < cuts; ++j)
            maker.quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    return maker.finish();
}

MeshData scan(Index count)
{
    constexpr double kNoise = 0.002;
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::mt19937 random(5);
    const auto uniform = [&] { return 2.0 * random() / double(std::mt19937::max()) - 1; };
    std::vector<Point> directions;
    while (directions.size() < static_cast<std::size_t>(count)) {
        const Eigen::Vector3d p(uniform(), uniform(), uniform());
        if (p.norm() > 1 || p.norm() < 0.1)
            continue;
        const Eigen::Vector3d d = p.normalized();
        directions.emplace_back(d.x(), d.y(), d.z());
    }
    CGAL::Surface_mesh<Point> hull; // of points on a sphere: their Delaunay triangulation
    CGAL::convex_hull_3(directions.begin(), directions.end(), hull);
    // The hull lists the same triangles in another order each time, and from another corner.
    std::map<Point, Index> number_of;
    SurfaceMaker maker;
    for (const Point& p : directions) {
        const Eigen::Vector3d d(p.x(), p.y(), p.z());
        const auto number = static_cast<Index>(number_of.size());
        number_of.emplace(p, maker.vertex({number, 0, 0}, (bumpy_radius(d) + kNoise * uniform()) * d));
    }
    std::set<std::array<Index, 3>> triangles;
    for (const auto face : hull.faces()) {
        std::array<Index, 3> corners{};
        std::size_t k = 0;
        for (const auto vertex : hull.vertices_around_face(hull.halfedge(face)))
            corners[k++] = number_of.at(hull.point(vertex));
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.insert(corners);
    }
    for (const auto& [a, b, c] : triangles)
        maker.triangle(a, b, c);
    return maker.finish();
}

double volume(const MeshData& surface)
{
    double sum = 0;
    for (const Element& e : surface.elements) {
        const Eigen::Vector3d a = surface.points.row(e[0]), b = surface.points.row(e[1]),
                              c = surface.points.row(e[2]);
        sum += a.dot(b.cross(c)) / 6;
    }
    return sum;
}

double surface_area(const MeshData& surface)
{
    double sum = 0;
    for (const Element& e : surface.elements) {
        const Eigen::Vector3d a = surface.points.row(e[0]), b = surface.points.row(e[1]),
                              c = surface.points.row(e[2]);
        sum += (b - a).cross(c - a).norm() / 2;
    }
    return sum;
}

Index euler_characteristic(const MeshData& surface)
{
    std::set<std::array<Index, 2>> edges;
    for (const Element& e : surface.elements)
        for (std::size_t k = 0; k < 3; ++k)
            edges.insert({std::min(e[k], e[(k + 1) % 3]), std::max(e[k], e[(k + 1) % 3])});
    return static_cast<Index>(surface.points.rows()) - static_cast<Index>(edges.size()) +
           static_cast<Index>(surface.elements.size());
}

} // namespace morph::test
