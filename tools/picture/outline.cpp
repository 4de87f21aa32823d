#include "tools/picture/outline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph::picture {

Outline outline_of(const FlatMesh& flat, const View& view, Index face)
{
    const Element& element = flat.elements[static_cast<std::size_t>(face)];
    Outline result;
    result.count = static_cast<std::size_t>(corner_count(element));
    for (std::size_t k = 0; k < result.count; ++k)
        result.corner[k] = place_of(flat, view, element[k]);
    return result;
}

double area_of(const Outline& outline)
{
    double twice = 0;
    const Pixel& origin = outline.corner[0];
    for (std::size_t k = 1; k + 1 < outline.count; ++k) {
        const Pixel& a = outline.corner[k];
        const Pixel& b = outline.corner[k + 1];
        twice += (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
    }
    return std::abs(twice) / 2;
}

double longest_side(const Outline& outline)
{
    double longest = 0;
    for (std::size_t k = 0; k < outline.count; ++k) {
        const Pixel& a = outline.corner[k];
        const Pixel& b = outline.corner[(k + 1) % outline.count];
        longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    }
    return longest;
}

std::vector<Index> far_to_near(const FlatMesh& flat, std::vector<Index> faces)
{
    std::vector<double> nearness(flat.elements.size());
    for (const Index f : faces) {
        const Element& element = flat.elements[static_cast<std::size_t>(f)];
        double sum = 0;
        for (int k = 0; k < corner_count(element); ++k)
            sum += flat.nearness[element[static_cast<std::size_t>(k)]];
        nearness[static_cast<std::size_t>(f)] = sum / corner_count(element);
    }
    std::stable_sort(faces.begin(), faces.end(), [&](Index a, Index b) {
        return nearness[static_cast<std::size_t>(a)] < nearness[static_cast<std::size_t>(b)];
    });
    return faces;
}

double light_on(const FlatMesh& flat, Index face)
{
    constexpr double kShade = 0.55; // what a face seen edge-on keeps
    const Element& element = flat.elements[static_cast<std::size_t>(face)];
    const auto corner = [&](std::size_t k) {
        const Index v = element[k];
        return Eigen::Vector3d(flat.place(v, 0), flat.place(v, 1), flat.nearness[v]);
    };
    const std::size_t last = corner_count(element) == 3 ? 0 : 3;
    const Eigen::Vector3d normal = (corner(2) - corner(0)).cross(corner(last) - corner(1)).stableNormalized();
    return kShade + (1 - kShade) * std::abs(normal.z());
}

} // namespace morph::picture
