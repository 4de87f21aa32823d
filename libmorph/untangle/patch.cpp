#include "libmorph/untangle/patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morph {

namespace {

constexpr double kFlat = 1e-12; // sine of an angle that rounding may have made

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Elements around a vertex.
struct Star {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
};

Star star(const VertexStars& stars, Index v)
{
    return {stars.around.data() + stars.start[at(v)], stars.around.data() + stars.start[at(v) + 1]};
}

/// Vertices within some rings of elements, as flags.
std::vector<char> dilate(const VertexStars& stars, const std::vector<Index>& elements, int rings)
{
    std::vector<char> inside(stars.vertex_of.size(), static_cast<char>(rings < 0));
    std::vector<Index> front, next;
    const auto reach = [&](const Element& element) {
        for (const Index v : element)
            if (v >= 0 && !inside[at(v)]) {
                inside[at(v)] = 1;
                next.push_back(v);
            }
    };
    for (const Index f : elements)
        reach(stars.elements[at(f)]);
    for (int ring = 0; ring < rings; ++ring) {
        front.swap(next);
        next.clear();
        for (const Index v : front)
            for (const Index f : star(stars, v))
                reach(stars.elements[at(f)]);
    }
    return inside;
}

/// Collects the free vertices connected with one of them, and their elements.
class Collector {
public:
    Collector(const VertexStars& stars, std::vector<char> free)
        : stars_(stars), free_(std::move(free)), seen_(stars.elements.size()), rim_of_(free_.size(), -1)
    {
    }

    bool is_free(Index v) const { return free_[at(v)] == 1; }

    Patch collect(Index seed, Index number)
    {
        Patch patch;
        std::vector<Index> rim;
        patch.vertices.push_back(seed);
        free_[at(seed)] = 2;
        for (std::size_t i = 0; i < patch.vertices.size(); ++i)
            for (const Index f : star(stars_, patch.vertices[i]))
                if (!seen_[at(f)]) {
                    seen_[at(f)] = 1;
                    patch.elements.push_back(f);
                    take(stars_.elements[at(f)], number, patch.vertices, rim);
                }
        patch.free = static_cast<Index>(patch.vertices.size());
        std::sort(patch.vertices.begin(), patch.vertices.end());
        std::sort(patch.elements.begin(), patch.elements.end());
        std::sort(rim.begin(), rim.end());
        patch.vertices.insert(patch.vertices.end(), rim.begin(), rim.end());
        return patch;
    }

private:
    void take(const Element& element, Index number, std::vector<Index>& vertices, std::vector<Index>& rim)
    {
        for (const Index v : element) {
            if (v < 0)
                continue;
            if (free_[at(v)] == 1) {
                free_[at(v)] = 2;
                vertices.push_back(v);
            } else if (free_[at(v)] == 0 && rim_of_[at(v)] != number) {
                rim_of_[at(v)] = number;
                rim.push_back(v);
            }
        }
    }

    const VertexStars& stars_;
    std::vector<char> free_; // 0: not free, 1: free, 2: free and in a patch
    std::vector<char> seen_; // by element
    std::vector<Index> rim_of_;
};

std::complex<double> point(const PositionsView& x, Index v)
{
    return {x(v, 0), x(v, 1)};
}

/// Number in the patch of a vertex of the mesh.
Index local(const Patch& patch, Index v)
{
    const auto rim = patch.vertices.begin() + patch.free;
    const auto found = std::lower_bound(patch.vertices.begin(), rim, v);
    return static_cast<Index>(
        (found != rim && *found == v ? found : std::lower_bound(rim, patch.vertices.end(), v)) -
        patch.vertices.begin());
}

double cross(std::complex<double> p, std::complex<double> q)
{
    return std::imag(std::conj(p) * q);
}

/// Derivatives d/dz of the linear functions that are 1 at one corner of the triangle 0, p, q and 0 at the
/// others.
std::array<std::complex<double>, 3> slopes(std::complex<double> p, std::complex<double> q)
{
    const std::complex<double> half(0, 0.5 / cross(p, q));
    const std::complex<double> next = half * std::conj(q), previous = -half * std::conj(p);
    return {-next - previous, next, previous};
}

/// Edges from a corner to the next and to the previous one where it should look like.
struct TargetEdges {
    std::complex<double> next, previous;

    double area() const { return cross(next, previous); }
    /// A corner that is flat to rounding has no shape to aim for.
    bool usable() const { return area() > kFlat * std::abs(next) * std::abs(previous); }
};

TargetEdges edges_of(const Element& element, std::size_t k, const PositionsView& x)
{
    const auto n = static_cast<std::size_t>(corner_count(element));
    const std::complex<double> corner = point(x, element[k]);
    return {point(x, element[(k + 1) % n]) - corner, point(x, element[(k + n - 1) % n]) - corner};
}

/// Corners that stand for an element: all corners of a triangle are the same map.
std::size_t mapped_corners(const Element& element)
{
    return element[3] < 0 ? 1 : 4;
}

/// Mean of the areas that corners of the patch span, over those that span one.
double mean_area(const Patch& patch, const VertexStars& stars, const PositionsView& reference)
{
    double sum = 0, count = 0;
    for (const Index f : patch.elements)
        for (std::size_t k = 0; k < mapped_corners(stars.elements[at(f)]); ++k)
            if (const TargetEdges target = edges_of(stars.elements[at(f)], k, reference); target.usable()) {
                sum += target.area();
                ++count;
            }
    return count > 0 ? sum / count : 1;
}

TargetEdges ideal_edges(const Element& element, double area)
{
    const double angle = std::numbers::pi / (element[3] < 0 ? 3 : 2);
    const double side = std::sqrt(area / std::sin(angle));
    return {side, std::polar(side, angle)};
}

} // namespace

CornerMap TargetCorner::map(const PlanePositions& x) const
{
    const std::complex<double> p = x[at(vertex[1])] - x[at(vertex[0])];
    const std::complex<double> q = x[at(vertex[2])] - x[at(vertex[0])];
    return {slope[1] * p + slope[2] * q, std::conj(slope[1]) * p + std::conj(slope[2]) * q};
}

std::vector<Patch> find_patches(const VertexStars& stars, const std::vector<char>& held,
                                const std::vector<Index>& elements, int rings)
{
    std::vector<char> free = dilate(stars, elements, rings);
    for (std::size_t v = 0; v < free.size(); ++v)
        if (held[v] || stars.vertex_of[v] != static_cast<Index>(v) || stars.start[v] == stars.start[v + 1])
            free[v] = 0;
    const auto n = static_cast<Index>(free.size());
    Collector collector(stars, std::move(free));
    std::vector<Patch> patches;
    for (Index v = 0; v < n; ++v)
        if (collector.is_free(v))
            patches.push_back(collector.collect(v, static_cast<Index>(patches.size())));
    return patches;
}

void set_targets(Patch& patch, const VertexStars& stars, const PositionsView& reference,
                 const std::vector<char>& ignored)
{
    const double mean = mean_area(patch, stars, reference);
    patch.corners.clear();
    for (const Index f : patch.elements) {
        if (ignored[at(f)])
            continue;
        const Element& element = stars.elements[at(f)];
        const auto n = static_cast<std::size_t>(corner_count(element));
        std::array<Index, 4> vertex{};
        for (std::size_t k = 0; k < n; ++k)
            vertex[k] = local(patch, element[k]);
        for (std::size_t k = 0; k < mapped_corners(element); ++k) {
            const std::array<Index, 3> corner{vertex[k], vertex[(k + 1) % n], vertex[(k + n - 1) % n]};
            if (*std::min_element(corner.begin(), corner.end()) >= patch.free)
                continue;
            TargetEdges target = edges_of(element, k, reference);
            if (!target.usable())
                target = ideal_edges(element, mean);
            patch.corners.push_back({corner, slopes(target.next, target.previous),
                                     1.0 / static_cast<double>(mapped_corners(element))});
        }
    }
}

} // namespace morph
