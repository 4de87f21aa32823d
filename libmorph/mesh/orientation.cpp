#include "libmorph/mesh/orientation.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/predicates.h"

#include <algorithm>
#include <atomic>
#include <span>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 65536;
constexpr Index kNone = -1;

/// The elements of one part after another, and which of them are listed the other way round than the
/// first element of their part.
class PartWalker {
public:
    PartWalker(const Mesh& mesh, const EdgeTable& edges)
        : mesh_(mesh), edges_(edges), reached_(edges.sides.size())
    {
        flip_.resize(edges.sides.size());
        elements_at_.assign(static_cast<std::size_t>(edges.edge_count()), {kNone, kNone});
        for (std::size_t f = 0; f < edges.sides.size(); ++f)
            for (const Index side : edges.sides[f])
                if (side != kNone) {
                    auto& pair = elements_at_[static_cast<std::size_t>(side / 2)];
                    (pair[0] == kNone ? pair[0] : pair[1]) = static_cast<Index>(f);
                }
    }

    bool reached(std::size_t element) const { return reached_[element]; }
    bool flip(Index element) const { return flip_[static_cast<std::size_t>(element)]; }
    void set_flip(Index element, bool flip) { flip_[static_cast<std::size_t>(element)] = flip; }
    std::vector<bool> flips() && { return std::move(flip_); }

    /// The elements of the part of an element not reached yet; valid until the next call.
    std::span<const Index> walk(std::size_t first)
    {
        part_.assign(1, static_cast<Index>(first));
        reached_[first] = true;
        for (std::size_t next = 0; next < part_.size(); ++next)
            for (const Index side : edges_.sides[static_cast<std::size_t>(part_[next])])
                if (side != kNone)
                    cross(part_[next], side);
        return part_;
    }

private:
    void cross(Index element, Index side)
    {
        const auto& pair = elements_at_[static_cast<std::size_t>(side / 2)];
        const Index neighbour = pair[0] == element ? pair[1] : pair[0];
        if (neighbour == kNone)
            return;
        const auto& sides = edges_.sides[static_cast<std::size_t>(neighbour)];
        const bool same_direction = std::find(sides.begin(), sides.end(), side) != sides.end();
        const bool wanted = flip(element) != same_direction;
        if (!reached(static_cast<std::size_t>(neighbour))) {
            reached_[static_cast<std::size_t>(neighbour)] = true;
            set_flip(neighbour, wanted);
            part_.push_back(neighbour);
        } else if (flip(neighbour) != wanted) {
            throw_one_sided(element, neighbour);
        }
    }

    [[noreturn]] void throw_one_sided(Index a, Index b) const
    {
        const auto& file = mesh_.numbering.element;
        throw InputError(
            "the surface cannot be oriented: elements " + std::to_string(file[static_cast<std::size_t>(a)]) +
            " and " + std::to_string(file[static_cast<std::size_t>(b)]) +
            " share an edge, but a walk over their neighbours comes back the other way round, as on a "
            "Moebius strip");
    }

    const Mesh& mesh_;
    const EdgeTable& edges_;
    std::vector<std::array<Index, 2>> elements_at_;
    std::vector<bool> reached_;
    std::vector<bool> flip_;
    std::vector<Index> part_;
};

/// Number of counter-clockwise elements less that of clockwise ones, once those with a flip are reversed.
std::ptrdiff_t area_majority(const Mesh& mesh, const std::vector<Element>& elements,
                             std::span<const Index> part, const PartWalker& walker)
{
    std::ptrdiff_t sum = 0;
    for (const Index f : part) {
        const int sign = area_sign(elements[static_cast<std::size_t>(f)], points(mesh));
        sum += walker.flip(f) ? -sign : sign;
    }
    return sum;
}

/// Whether the flips of a part are to be taken the other way.
bool reverse_part(const Mesh& mesh, const std::vector<Element>& elements, std::span<const Index> part,
                  const PartWalker& walker)
{
    if (mesh.dimension == 2) {
        const std::ptrdiff_t majority = area_majority(mesh, elements, part, walker);
        if (majority != 0)
            return majority < 0;
    }
    const auto flips = static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), [&](Index f) { return walker.flip(f); }));
    if (2 * flips != part.size())
        return 2 * flips > part.size();
    const auto file_number = [&](Index f) { return mesh.numbering.element[static_cast<std::size_t>(f)]; };
    return walker.flip(*std::min_element(part.begin(), part.end(),
                                         [&](Index a, Index b) { return file_number(a) < file_number(b); }));
}

std::vector<bool> elements_to_reverse(const Mesh& mesh, const std::vector<Element>& elements,
                                      const EdgeTable& edges)
{
    PartWalker walker(mesh, edges);
    for (std::size_t f = 0; f < elements.size(); ++f) {
        if (walker.reached(f))
            continue;
        const std::span<const Index> part = walker.walk(f);
        if (reverse_part(mesh, elements, part, walker))
            for (const Index member : part)
                walker.set_flip(member, !walker.flip(member));
    }
    return std::move(walker).flips();
}

bool any_clockwise(const Mesh& mesh, const std::vector<Element>& elements)
{
    std::atomic<bool> found{false};
    parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end && !found; ++f)
            if (area_sign(elements[f], points(mesh)) < 0)
                found = true;
    });
    return found;
}

/// The sides that go with reversed(element): from the same corner, the other way round.
std::array<Index, 4> reversed_sides(const std::array<Index, 4>& sides, int corners)
{
    std::array<Index, 4> result = sides;
    std::reverse(result.begin(), result.begin() + corners);
    std::for_each(result.begin(), result.begin() + corners, [](Index& side) { side ^= 1; });
    return result;
}

} // namespace

Element reversed(const Element& element)
{
    Element result = element;
    std::reverse(result.begin() + 1, result.begin() + corner_count(element));
    return result;
}

int area_sign(const Element& element, Eigen::Map<const Points> points)
{
    const auto corner = [&](std::size_t k) {
        return PlanePoint{points(element[k], 0), points(element[k], 1)};
    };
    return cross_sign(corner(0), corner(2), corner(1), corner(corner_count(element) == 4 ? 3 : 0));
}

std::vector<bool> orient_elements(const Mesh& mesh, std::vector<Element>& elements, EdgeTable& edges)
{
    if (edges.consistent && (mesh.dimension == 3 || !any_clockwise(mesh, elements)))
        return std::vector<bool>(elements.size());
    std::vector<bool> reverse = elements_to_reverse(mesh, elements, edges);
    for (std::size_t f = 0; f < elements.size(); ++f)
        if (reverse[f]) {
            edges.sides[f] = reversed_sides(edges.sides[f], corner_count(elements[f]));
            elements[f] = reversed(elements[f]);
        }
    edges.consistent = true;
    return reverse;
}

} // namespace morph
