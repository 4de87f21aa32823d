#include "libmorph/quality/smoothness.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace morph {

namespace {

/// Half the integral of |grad d|^2 over a triangle: the cotangent formula, as the sum over its sides of
/// cot(angle opposite) |difference of d|^2 / 4.
double triangle_energy(const PositionsView& before, const PositionsView& after,
                       const std::array<Index, 3>& corner)
{
    const auto side = [&](std::size_t k) {
        return Eigen::Vector2d((before.row(corner[(k + 2) % 3]) - before.row(corner[(k + 1) % 3])).head<2>());
    };
    const auto move = [&](std::size_t k) -> Eigen::RowVector3d {
        return after.row(corner[k]) - before.row(corner[k]);
    };
    const Eigen::Vector2d a = side(0), b = side(1);
    const double twice_area = std::abs(a.x() * b.y() - a.y() * b.x());
    if (twice_area == 0)
        return 0;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double cotangent = -side((k + 1) % 3).dot(side((k + 2) % 3)) / twice_area;
        sum += cotangent / 4 * (move((k + 2) % 3) - move((k + 1) % 3)).squaredNorm();
    }
    return sum;
}

double element_energy(const PositionsView& before, const PositionsView& after, const Element& e)
{
    if (corner_count(e) == 3)
        return triangle_energy(before, after, {e[0], e[1], e[2]});
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += triangle_energy(before, after, {e[k], e[(k + 1) % 4], e[(k + 2) % 4]});
    return sum / 2;
}

} // namespace

double dirichlet_energy(const Mesh& mesh, const PositionsView& before, const PositionsView& after)
{
    constexpr std::size_t kRowsPerBlock = 8192;
    for (const auto* positions : {&before, &after})
        if (positions->rows() != vertex_count(mesh))
            throw InputError("there are " + std::to_string(positions->rows()) +
                             " positions, but the mesh has " + std::to_string(vertex_count(mesh)) +
                             " vertices");
    const auto faces = static_cast<std::size_t>(element_count(mesh));
    std::vector<double> sums((faces + kRowsPerBlock - 1) / kRowsPerBlock);
    parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            sums[begin / kRowsPerBlock] +=
                element_energy(before, after, element_corners(mesh, static_cast<Index>(f)));
    });
    double total = 0;
    for (const double sum : sums)
        total += sum;
    return total;
}

} // namespace morph
