#include "tests/bench/remap_inputs.h"

#include "libmorph/core/space_curve.h"
#include "libmorph/mesh/builder.h"
#include "tests/bench/bench_meshes.h"

#include <cmath>
#include <random>

namespace morph::bench {

namespace {

constexpr double kRim = 0.1;
// In a unit square vtkShepardKernel would take points 0.002 apart for one: it compares r^5 with 6e-14.
constexpr double kWidth = 1000;
constexpr Index kCloud = 100'000; // known points, and unknown ones

/// A scalar and a vector that change smoothly over the square.
Matrix smooth_values(const Eigen::Ref<const Points>& at)
{
    const auto x = at.col(0).array(), y = at.col(1).array();
    Matrix values(at.rows(), 4);
    values << x * x + y, x.sin(), y.cos(), x * y;
    return values;
}

/// Points at random in the square around the unit square, in the rim.
Points points_around(Index count)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-kRim, 1 + kRim);
    const auto outside = [](double c) { return c < 0 || c > 1; };
    Points made = Points::Zero(count, 3);
    for (Index i = 0; i < count; ++i)
        do
            made.row(i) << uniform(random), uniform(random), 0;
        while (!outside(made(i, 0)) && !outside(made(i, 1)));
    return made;
}

} // namespace

Points random_points(Index count)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    Points made = Points::Zero(count, 3);
    for (Index i = 0; i < count; ++i)
        made.row(i) << uniform(random), uniform(random), 0;
    return made;
}

MeshData source_data(Index vertices)
{
    MeshData data = triangulated_square(vertices, Order::sorted);
    const Matrix values = smooth_values(data.points);
    data.fields = {{"pressure", FieldLocation::vertex, values.leftCols(1)},
                   {"velocity", FieldLocation::vertex, values.rightCols(3)}};
    return data;
}

Mesh source_mesh(Index vertices)
{
    return build_mesh(source_data(vertices));
}

Cloud cloud(Place place)
{
    // One list of random points for both: a second one would repeat the first.
    Points all = random_points(2 * kCloud);
    if (place == Place::around)
        all.bottomRows(kCloud) = points_around(kCloud);
    Cloud made;
    const std::vector<Index> order = hilbert_order(all, 2);
    made.values = smooth_values(all(order, Eigen::all));
    made.positions = kWidth * all(order, Eigen::all);
    for (Index i = 0; i < 2 * kCloud; ++i)
        (order[static_cast<std::size_t>(i)] < kCloud ? made.known : made.unknown).push_back(i);
    return made;
}

} // namespace morph::bench
