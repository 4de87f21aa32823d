#include "libmorph/quality/safe_step.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/corner_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 4096; // elements of a block

/// An element as its vertices move.
struct MovingElement {
    std::array<MovingPoint, 4> point;
    std::size_t corners = 3;

    /// A triangle has the same Jacobian at all its corners.
    std::size_t different_corners() const { return corners == 3 ? 1 : corners; }

    MovingCorner corner(std::size_t k) const
    {
        return {point[k], point[(k + 1) % corners], point[(k + corners - 1) % corners]};
    }

    bool is_valid_until(double time) const
    {
        for (std::size_t k = 0; k < different_corners(); ++k)
            if (!stays_positive_until(corner(k), time))
                return false;
        return true;
    }

    double turning_time() const
    {
        double first = 1;
        for (std::size_t k = 0; k < different_corners(); ++k)
            first = std::min(first, morph::turning_time(corner(k)));
        return first;
    }
};

struct Move {
    const Mesh& mesh;
    const PositionsView& before;
    const PositionsView& after;

    MovingElement element(Index face) const
    {
        const Element vertices = element_corners(mesh, face);
        MovingElement moving;
        moving.corners = static_cast<std::size_t>(corner_count(vertices));
        for (std::size_t k = 0; k < moving.corners; ++k) {
            const Index v = vertices[k];
            moving.point[k] = {{before(v, 0), before(v, 1)}, {after(v, 0), after(v, 1)}};
        }
        return moving;
    }
};

/// The largest double up to which an element stays valid, given a positive one up to which it does not; 0
/// when there is none.
double last_valid_time(const MovingElement& element, double invalid)
{
    // Doubles from 0 upwards are in the order of their bits. The estimate is a few of them off as a rule:
    // from it outwards until the last valid one is enclosed, then bisection.
    constexpr std::uint64_t kWiden = 8;
    const auto valid = [&](std::uint64_t bits) {
        return element.is_valid_until(std::bit_cast<double>(bits));
    };
    auto high = std::bit_cast<std::uint64_t>(invalid);
    std::uint64_t low = std::min(std::bit_cast<std::uint64_t>(element.turning_time()), high - 1);
    for (std::uint64_t reach = 1; low > 0 && !valid(low); reach *= kWiden) {
        high = low;
        low -= std::min(low, reach);
    }
    for (std::uint64_t reach = 1; high - low > reach; reach *= kWiden) {
        if (!valid(low + reach)) {
            high = low + reach;
            break;
        }
        low += reach;
    }
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (valid(middle) ? low : high) = middle;
    }
    return std::bit_cast<double>(low);
}

/// For each block of elements the largest double up to which all of them stay valid, at most 1.
std::vector<double> valid_times(const Move& move)
{
    const auto elements = static_cast<std::size_t>(element_count(move.mesh));
    std::vector<double> times((elements + kRowsPerBlock - 1) / kRowsPerBlock, 1);
    parallel_for(elements, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        double& time = times[begin / kRowsPerBlock];
        for (std::size_t f = begin; f < end && time > 0; ++f) {
            const MovingElement element = move.element(static_cast<Index>(f));
            if (!element.is_valid_until(time))
                time = last_valid_time(element, time);
        }
    });
    return times;
}

/// Lowest file number of the elements that are not valid up to the double after @p step, the least of the
/// times of the blocks.
Index limiting_element(const Move& move, const std::vector<double>& times, double step)
{
    std::vector<Index> lowest(times.size(), std::numeric_limits<Index>::max());
    const auto elements = static_cast<std::size_t>(element_count(move.mesh));
    parallel_for(elements, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        if (times[begin / kRowsPerBlock] > step)
            return;
        Index& low = lowest[begin / kRowsPerBlock];
        for (std::size_t f = begin; f < end; ++f) {
            const Index number = move.mesh.numbering.element[f];
            const bool lower = number < low;
            if (lower && !move.element(static_cast<Index>(f)).is_valid_until(std::nextafter(step, 1)))
                low = number;
        }
    });
    return *std::min_element(lowest.begin(), lowest.end());
}

void require_planar(const Mesh& mesh, const PositionsView& before, const PositionsView& after)
{
    if (mesh.dimension != 2)
        throw InputError("a safe step is known for planar meshes only, but this is a surface in space");
    for (const auto* positions : {&before, &after})
        if (positions->rows() != vertex_count(mesh))
            throw InputError("there are " + std::to_string(positions->rows()) +
                             " positions, but the mesh has " + std::to_string(vertex_count(mesh)) +
                             " vertices");
}

} // namespace

SafeStep safe_step(const Mesh& mesh, const PositionsView& before, const PositionsView& after)
{
    require_planar(mesh, before, after);
    const Move move{mesh, before, after};
    const std::vector<double> times = valid_times(move);
    const double step = times.empty() ? 1 : *std::min_element(times.begin(), times.end());
    if (step == 1)
        return {};
    return {step, limiting_element(move, times, step)};
}

} // namespace morph
