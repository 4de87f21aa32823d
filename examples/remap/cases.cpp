#include "examples/remap/cases.h"

#include "libmorph/geometry/mesh_domain.h"

#include <cmath>
#include <numbers>
#include <random>

namespace morph::examples {

namespace {

using std::numbers::pi;

/// The pipe at (s, t): s in [0, 1] along it, t in [-1, 1] from the lower to the upper wall.
Eigen::RowVector3d pipe_point(double s, double t)
{
    constexpr double kLength = 2, kRise = 0.8, kHalfWidth = 0.15;
    const double y = kRise / 2 * (1 - std::cos(pi * s));
    const double slope = kRise / 2 * pi / kLength * std::sin(pi * s);
    const Eigen::Vector2d normal = Eigen::Vector2d(-slope, 1).normalized();
    return {kLength * s + kHalfWidth * t * normal.x(), y + kHalfWidth * t * normal.y(), 0};
}

/// A grid of the pipe; inner nodes are moved at random by up to @p jitter of a cell.
Points pipe_nodes(Index along, Index across, double jitter, std::mt19937& random)
{
    std::uniform_real_distribution<double> shift(-jitter, jitter);
    Points nodes(along * across, 3);
    for (Index i = 0; i < along; ++i)
        for (Index j = 0; j < across; ++j) {
            const bool inner = i > 0 && j > 0 && i + 1 < along && j + 1 < across;
            const double ds = inner ? shift(random) : 0, dt = inner ? shift(random) : 0;
            nodes.row(i * across + j) = pipe_point((i + ds) / (along - 1), 2 * (j + dt) / (across - 1) - 1);
        }
    return nodes;
}

MeshData pipe_of_quads(Index along, Index across)
{
    std::mt19937 random(1);
    MeshData mesh;
    mesh.points = pipe_nodes(along, across, 0.2, random);
    for (Index i = 0; i + 1 < along; ++i)
        for (Index j = 0; j + 1 < across; ++j) {
            const Index corner = i * across + j;
            mesh.elements.push_back({corner, corner + across, corner + across + 1, corner + 1});
        }
    mesh.markers = {{"inlet", {}}, {"outlet", {}}, {"lower", {}}, {"upper", {}}};
    const Index last = (along - 1) * across;
    for (Index j = 0; j + 1 < across; ++j) {
        mesh.markers[0].edges.push_back({j + 1, j});
        mesh.markers[1].edges.push_back({last + j, last + j + 1});
    }
    for (Index i = 0; i + 1 < along; ++i) {
        mesh.markers[2].edges.push_back({i * across, (i + 1) * across});
        mesh.markers[3].edges.push_back({(i + 2) * across - 1, (i + 1) * across - 1});
    }
    return mesh;
}

MeshData pipe_of_triangles(Index along, Index across)
{
    MeshData mesh = pipe_of_quads(along, across);
    std::mt19937 random(2);
    std::vector<Element> triangles;
    for (const Element& q : mesh.elements) {
        const bool rising = random() % 2 == 0;
        triangles.push_back(rising ? Element{q[0], q[1], q[2], -1} : Element{q[1], q[2], q[3], -1});
        triangles.push_back(rising ? Element{q[0], q[2], q[3], -1} : Element{q[1], q[3], q[0], -1});
    }
    mesh.elements = std::move(triangles);
    return mesh;
}

/// Half the thickness of a NACA 0012 of unit chord with a sharp trailing edge.
double half_thickness(double x)
{
    return 0.6 *
           (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
}

/// Nodes of the airfoil counter-clockwise from the trailing edge, closer together at both of its ends.
std::vector<Eigen::RowVector3d> airfoil_nodes(Index around)
{
    std::vector<Eigen::RowVector3d> nodes;
    for (Index i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around;
        const double x = (1 + std::cos(angle)) / 2;
        nodes.emplace_back(x, i == 0 ? 0 : std::copysign(half_thickness(x), std::sin(angle)), 0);
    }
    return nodes;
}

/// The ellipse where quads end and triangles begin, as a polygon.
Curve layer_edge(Index around)
{
    CurveDefinition polygon{.degree = 1, .closed = true};
    polygon.control_points.resize(around, 2);
    for (Index i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around;
        polygon.control_points.row(i) << 0.5 + 0.62 * std::cos(angle), 0.2 * std::sin(angle);
    }
    return Curve(polygon);
}

/// Layers of quads between the airfoil and the first vertices of a mesh, which run around the ellipse.
void add_layers(MeshData& mesh, Index around, Index layers)
{
    constexpr double kGrowth = 1.15;
    const auto airfoil = airfoil_nodes(around);
    const auto outer = static_cast<Index>(mesh.points.rows());
    mesh.points.conservativeResize(outer + around * layers, 3);
    // The polygon starts at some control point; the airfoil node of the same angle is the one across.
    const double start = std::atan2(mesh.points(0, 1) / 0.2, (mesh.points(0, 0) - 0.5) / 0.62);
    const auto turn = static_cast<Index>(std::lround(start / (2 * pi) * around)) + around;
    const auto node = [&](Index layer, Index i) {
        return layer == layers ? i % around : outer + layer * around + i % around;
    };
    for (Index layer = 0; layer < layers; ++layer) {
        const double part = (std::pow(kGrowth, layer) - 1) / (std::pow(kGrowth, layers) - 1);
        for (Index i = 0; i < around; ++i) {
            const auto& wall = airfoil[static_cast<std::size_t>((i + turn) % around)];
            mesh.points.row(node(layer, i)) = (1 - part) * wall + part * mesh.points.row(i);
            mesh.elements.push_back(
                {node(layer, i), node(layer + 1, i), node(layer + 1, i + 1), node(layer, i + 1)});
        }
    }
    Marker wall{"airfoil", {}};
    for (Index i = 0; i < around; ++i)
        wall.edges.push_back({node(0, i + 1), node(0, i)});
    mesh.markers.push_back(std::move(wall));
}

MeshData airfoil(Index around, Index layers, double size, double growth)
{
    DomainSpec spec;
    spec.box = {-4, -4, 6, 4};
    spec.size = size;
    spec.growth = growth;
    spec.curves = {{"layer edge", layer_edge(around), around}};
    MeshData mesh = mesh_domain(spec);
    std::erase_if(mesh.markers, [](const Marker& marker) { return marker.name == "layer edge"; });
    add_layers(mesh, around, layers);
    return mesh;
}

} // namespace

std::vector<RemapCase> remap_cases()
{
    return {{"pipe_triangles", pipe_of_triangles(225, 18), pipe_of_triangles(460, 35)},
            {"pipe_quads", pipe_of_quads(250, 16), pipe_of_quads(500, 32)},
            {"airfoil_hybrid", airfoil(352, 24, 0.0717, 0.2), airfoil(555, 32, 0.0416, 0.2)}};
}

std::array<double, 2> velocity(double x, double y)
{
    return {1 + 0.3 * std::sin(2 * pi * x) * std::cos(pi * y), 0.3 * std::cos(2 * pi * x) * std::sin(pi * y)};
}

MeshData with_velocity(MeshData mesh)
{
    Field field{"velocity", FieldLocation::vertex, Matrix(mesh.points.rows(), 2)};
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        const auto [u, w] = velocity(mesh.points(v, 0), mesh.points(v, 1));
        field.values.row(v) << u, w;
    }
    mesh.fields.push_back(std::move(field));
    return mesh;
}

} // namespace morph::examples
