#include "libmorph/quality/safe_step.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/moving_corner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kGrain = 4096; // elements of a block

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
            if (!turns_left_until(corner(k), time))
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

/// An element that the whole move would invert, and about when.
struct Candidate {
    Index face = 0;
    double time = 0;
};

std::vector<Candidate> inverted_on_the_way(const Move& move)
{
    const auto elements = static_cast<std::size_t>(element_count(move.mesh));
    std::vector<std::vector<Candidate>> found((elements + kGrain - 1) / kGrain);
    parallel_for(elements, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const MovingElement element = move.element(static_cast<Index>(f));
            if (!element.is_valid_until(1))
                found[begin / kGrain].push_back({static_cast<Index>(f), element.turning_time()});
        }
    });
    std::vector<Candidate> all;
    for (const std::vector<Candidate>& part : found)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// The largest double up to which an element stays valid, given one up to which it does not: bisection over
/// the doubles, which from 0 upwards are in the order of their bits. 0 when there is none.
double last_valid_time(const MovingElement& element, double invalid)
{
    std::uint64_t low = 0;
    auto high = std::bit_cast<std::uint64_t>(invalid);
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (element.is_valid_until(std::bit_cast<double>(middle)) ? low : high) = middle;
    }
    return std::bit_cast<double>(low);
}

/// The least over some elements of the time up to which they stay valid, or @p least when none allows less.
double least_valid_time(const Move& move, const Candidate* begin, const Candidate* end, double least)
{
    for (const Candidate* c = begin; c != end; ++c) {
        const MovingElement element = move.element(c->face);
        if (!element.is_valid_until(least))
            least = last_valid_time(element, least);
    }
    return least;
}

double least_valid_time(const Move& move, const std::vector<Candidate>& candidates)
{
    // The element that seems to be the first rules out nearly all others with one look at each.
    const auto first =
        std::min_element(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.time < b.time; });
    const double bound = least_valid_time(move, &*first, &*first + 1, 1);
    std::vector<double> least((candidates.size() + kGrain - 1) / kGrain);
    parallel_for(candidates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        least[begin / kGrain] =
            least_valid_time(move, candidates.data() + begin, candidates.data() + end, bound);
    });
    return *std::min_element(least.begin(), least.end());
}

/// Lowest file number of the elements that are not valid up to a time.
Index first_invalid(const Move& move, const std::vector<Candidate>& candidates, double time)
{
    constexpr Index kNone = std::numeric_limits<Index>::max();
    std::vector<Index> lowest((candidates.size() + kGrain - 1) / kGrain, kNone);
    parallel_for(candidates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        Index& low = lowest[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
            const Index face = candidates[i].face;
            const Index number = move.mesh.numbering.element[static_cast<std::size_t>(face)];
            if (number < low && !move.element(face).is_valid_until(time))
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
    const std::vector<Candidate> candidates = inverted_on_the_way(move);
    if (candidates.empty())
        return {};
    const double step = least_valid_time(move, candidates);
    return {step, first_invalid(move, candidates, std::nextafter(step, 1))};
}

} // namespace morph
