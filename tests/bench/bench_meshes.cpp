#include "tests/bench/bench_meshes.h"

#include "tests/support/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace morph::bench {

namespace {

MeshData ordered(MeshData mesh, Order order)
{
    if (order == Order::shuffled)
        shuffle(mesh);
    return mesh;
}

} // namespace

MeshData triangulated_square(Index vertices, Order order)
{
    const auto cells = static_cast<Index>(std::lround(std::sqrt(vertices))) - 1;
    return ordered(test::uneven_square(cells), order);
}

MeshData triangulated_annulus(Index vertices, Order order)
{
    constexpr double kOuter = 10;
    const double aspect = 2 * std::numbers::pi / std::log(kOuter); // cells around per radial cell when square
    const auto around = static_cast<Index>(std::lround(std::sqrt(vertices * aspect)));
    return ordered(test::annulus(1, kOuter, around, vertices / around - 1), order);
}

void shuffle(MeshData& mesh, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Index> number(static_cast<std::size_t>(mesh.points.rows()));
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);

    const Points points = mesh.points;
    for (Index i = 0; i < points.rows(); ++i)
        mesh.points.row(number[static_cast<std::size_t>(i)]) = points.row(i);
    const auto renumber = [&](Index& v) { v = v < 0 ? v : number[static_cast<std::size_t>(v)]; };
    for (Element& element : mesh.elements)
        std::for_each(element.begin(), element.end(), renumber);
    for (Marker& marker : mesh.markers)
        for (auto& edge : marker.edges)
            std::for_each(edge.begin(), edge.end(), renumber);
    std::shuffle(mesh.elements.begin(), mesh.elements.end(), random);
}

} // namespace morph::bench
