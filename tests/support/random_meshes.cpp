#include "tests/support/random_meshes.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace morph::test {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, K>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<bool, K>; // whether it is used up
using Delaunay =
    CGAL::Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

double uniform(std::mt19937& random)
{
    return static_cast<double>(random()) / 4294967296.0;
}

K::Point_2 random_point(const RandomMesh& settings, std::mt19937& random)
{
    double x = uniform(random), y = uniform(random);
    const double shrink = std::pow(settings.size_ratio, -uniform(random));
    x *= shrink;
    y *= shrink;
    if (settings.grid > 0) {
        x = std::round(x * settings.grid) / settings.grid;
        y = std::round(y * settings.grid) / settings.grid;
    }
    return {x, y * settings.thinness};
}

/// The quad of two triangles with a common side, if it is convex.
bool join(Delaunay::Face_handle face, int side, Element& quad)
{
    const Delaunay::Face_handle other = face->neighbor(side);
    const auto opposite = other->vertex(other->index(face));
    const auto a = face->vertex(side), b = face->vertex(Delaunay::ccw(side)),
               d = face->vertex(Delaunay::cw(side));
    if (CGAL::orientation(a->point(), b->point(), opposite->point()) != CGAL::LEFT_TURN ||
        CGAL::orientation(opposite->point(), d->point(), a->point()) != CGAL::LEFT_TURN)
        return false;
    quad = {a->info(), b->info(), opposite->info(), d->info()};
    return true;
}

Element next_element(const Delaunay& triangulation, Delaunay::Face_handle face, double quads,
                     std::mt19937& random)
{
    face->info() = true;
    Element element{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info(), -1};
    if (uniform(random) >= quads)
        return element;
    for (int side = 0; side < 3; ++side) {
        const auto other = face->neighbor(side);
        if (!triangulation.is_infinite(other) && !other->info() && join(face, side, element)) {
            other->info() = true;
            break;
        }
    }
    return element;
}

} // namespace

MeshData random_mesh(const RandomMesh& settings)
{
    std::mt19937 random(settings.seed);
    Delaunay triangulation;
    MeshData mesh;
    std::vector<double> coordinates;
    while (triangulation.number_of_vertices() < static_cast<std::size_t>(settings.vertices) ||
           triangulation.dimension() < 2) {
        const K::Point_2 p = random_point(settings, random);
        const auto before = triangulation.number_of_vertices();
        const auto v = triangulation.insert(p);
        if (triangulation.number_of_vertices() == before)
            continue;
        v->info() = static_cast<Index>(before);
        coordinates.insert(coordinates.end(), {p.x(), p.y(), 0});
    }
    mesh.points = Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size() / 3), 3);
    std::vector<Delaunay::Face_handle> faces;
    for (const auto face : triangulation.finite_face_handles()) {
        face->info() = false;
        faces.push_back(face);
    }
    std::shuffle(faces.begin(), faces.end(), random);
    for (const auto face : faces)
        if (!face->info())
            mesh.elements.push_back(next_element(triangulation, face, settings.quads, random));
    const auto dropped = static_cast<std::size_t>(settings.holes * static_cast<double>(mesh.elements.size()));
    mesh.elements.resize(std::max<std::size_t>(1, mesh.elements.size() - dropped));
    return mesh;
}

Points random_targets(const MeshData& mesh, Index count, std::mt19937& random)
{
    const Eigen::RowVector3d low = mesh.points.colwise().minCoeff();
    const Eigen::RowVector3d size = mesh.points.colwise().maxCoeff() - low;
    const auto any_corner = [&](const Element& e) {
        return e[random() % static_cast<unsigned>(corner_count(e))];
    };
    Points targets(count, 3);
    for (Index i = 0; i < count; ++i) {
        const Element& element = mesh.elements[random() % mesh.elements.size()];
        const auto k = random() % static_cast<unsigned>(corner_count(element));
        const Index from = element[k], to = element[(k + 1) % static_cast<unsigned>(corner_count(element))];
        switch (random() % 5) {
        case 0:
            targets.row(i) = mesh.points.row(any_corner(element));
            break;
        case 1:
            targets.row(i) = (mesh.points.row(from) + mesh.points.row(to)) / 2;
            break;
        case 2:
            targets.row(i) = i > 0
                                 ? targets.row(static_cast<Index>(random() % static_cast<unsigned>(i))).eval()
                                 : mesh.points.row(from).eval();
            break;
        default:
            targets.row(i) = low + size.cwiseProduct(Eigen::RowVector3d(1.2 * uniform(random) - 0.1,
                                                                        1.2 * uniform(random) - 0.1, 0));
        }
    }
    return targets;
}

RandomMesh some_settings(std::uint32_t seed)
{
    RandomMesh settings;
    settings.seed = seed;
    settings.vertices = static_cast<Index>(3 + seed % 41);
    settings.quads = seed % 3 == 0 ? 0 : 0.5 * (seed % 3);
    settings.holes = 0.2 * ((seed / 3) % 4);
    settings.thinness = (seed / 12) % 5 == 1 ? 1e-12 : 1;
    settings.size_ratio = (seed / 12) % 5 == 2 ? 1000 : 1;
    settings.grid = (seed / 12) % 5 == 3 ? 8 : 0;
    return settings;
}

} // namespace morph::test
