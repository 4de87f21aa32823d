#include "tests/support/meshes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace morph::test {

namespace {

/// Vertices (i, j) of a cells x cells grid, row by row, the inner ones shifted by up to a fifth of a cell.
Points shifted_grid(Index cells)
{
    Points grid((cells + 1) * (cells + 1), 3);
    const double h = 1.0 / cells;
    for (Index j = 0; j <= cells; ++j)
        for (Index i = 0; i <= cells; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            const double dx = inner ? 0.2 * h * std::sin(12.9898 * i + 78.233 * j) : 0;
            const double dy = inner ? 0.2 * h * std::sin(39.3468 * i + 11.135 * j) : 0;
            grid.row(j * (cells + 1) + i) << i * h + dx, j * h + dy, 0;
        }
    return grid;
}

std::vector<Marker> square_markers(Index cells)
{
    const auto at = [cells](Index i, Index j) { return j * (cells + 1) + i; };
    std::vector<Marker> markers{{"bottom", {}}, {"right", {}}, {"top", {}}, {"left", {}}};
    for (Index k = 0; k < cells; ++k) {
        markers[0].edges.push_back({at(k, 0), at(k + 1, 0)});
        markers[1].edges.push_back({at(cells, k), at(cells, k + 1)});
        markers[2].edges.push_back({at(cells - k, cells), at(cells - k - 1, cells)});
        markers[3].edges.push_back({at(0, cells - k), at(0, cells - k - 1)});
    }
    return markers;
}

} // namespace

MeshData uneven_square(Index cells)
{
    MeshData mesh = quad_square(cells);
    std::vector<Element> triangles;
    for (const Element& q : mesh.elements) {
        triangles.push_back({q[0], q[1], q[2], -1});
        triangles.push_back({q[0], q[2], q[3], -1});
    }
    mesh.elements = std::move(triangles);
    return mesh;
}

MeshData quad_square(Index cells)
{
    MeshData mesh;
    mesh.points = shifted_grid(cells);
    for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i) {
            const Index corner = j * (cells + 1) + i;
            mesh.elements.push_back({corner, corner + 1, corner + cells + 2, corner + cells + 1});
        }
    mesh.markers = square_markers(cells);
    return mesh;
}

MeshData annulus(double inner, double outer, Index around, Index radial)
{
    MeshData mesh;
    mesh.points.resize(around * (radial + 1), 3);
    for (Index j = 0; j <= radial; ++j) {
        const double r = inner * std::pow(outer / inner, static_cast<double>(j) / radial);
        for (Index i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            mesh.points.row(j * around + i) << r * std::cos(angle), r * std::sin(angle), 0;
        }
    }
    mesh.markers = {{"inner", {}}, {"outer", {}}};
    for (Index i = 0; i < around; ++i) {
        const Index next = (i + 1) % around;
        mesh.markers[0].edges.push_back({next, i});
        mesh.markers[1].edges.push_back({radial * around + i, radial * around + next});
        for (Index j = 0; j < radial; ++j) {
            const Element q{j * around + i, (j + 1) * around + i, (j + 1) * around + next, j * around + next};
            mesh.elements.push_back({q[0], q[1], q[2], -1});
            mesh.elements.push_back({q[0], q[2], q[3], -1});
        }
    }
    return mesh;
}

MeshData uneven_annulus(double inner, double outer, Index around)
{
    MeshData data = annulus(inner, outer, around, around / 4);
    for (Index v = 0; v < data.points.rows(); ++v) {
        const double angle = std::atan2(data.points(v, 1), data.points(v, 0));
        const double part = std::log(data.points.row(v).norm() / inner) / std::log(outer / inner);
        const double bump = std::sin(std::numbers::pi * part);
        const double radius = inner * std::pow(outer / inner, part + 0.1 * bump * std::cos(3 * angle));
        const double turned = angle + 0.3 + 0.2 * bump * std::sin(2 * angle + 1);
        data.points.row(v) << radius * std::cos(turned), radius * std::sin(turned), 0;
    }
    return data;
}

MeshData touching_squares(Index cells)
{
    MeshData data = uneven_square(cells);
    const MeshData other = data;
    const Index n = static_cast<Index>(data.points.rows());
    const auto renamed = [n](Index v) {
        return v < 0 ? v : n - 1 + v;
    }; // the last vertex is the other's first
    data.points.conservativeResize(2 * n - 1, 3);
    for (Index v = 1; v < n; ++v)
        data.points.row(renamed(v)) = other.points.row(v) + Eigen::RowVector3d(1, 1, 0);
    for (Element e : other.elements) {
        std::transform(e.begin(), e.end(), e.begin(), renamed);
        data.elements.push_back(e);
    }
    for (const Marker& m : other.markers) {
        Marker& second = data.markers.emplace_back(Marker{m.name + " 2", {}});
        for (const auto& edge : m.edges)
            second.edges.push_back({renamed(edge[0]), renamed(edge[1])});
    }
    return data;
}

std::vector<std::string> real_meshes()
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(data_path("meshes")))
        if (entry.path().extension() == ".su2")
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

} // namespace morph::test
