#include "libmorph/remesh/folds.h"

#include "libmorph/core/parallel.h"
#include "libmorph/geometry/mesh_parts.h"

#include <Eigen/Geometry>

namespace morph {

namespace {

bool is_folded(const MeshParts& old, const std::array<Eigen::Vector3d, 3>& corners, std::size_t& near)
{
    constexpr double kNearCorner = 0.02; // of the way to the centre
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Eigen::Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3;
    const auto turned = [&](const Eigen::Vector3d& p) {
        near = old.nearest(p, near).part;
        return normal.dot(old.normal(near)) < 0;
    };
    bool folded = turned(centre);
    for (const Eigen::Vector3d& corner : corners)
        folded = folded && turned(corner + kNearCorner * (centre - corner));
    return folded;
}

} // namespace

std::vector<Index> folded_triangles(const Mesh& old, const Mesh& made)
{
    std::vector<Index> found;
    if (made.dimension == 2 || element_count(old) == 0)
        return found;
    const MeshParts parts(old);
    const auto place = points(made);
    const auto count = static_cast<std::size_t>(element_count(made));
    std::vector<char> folded(count, 0); // not bool: blocks write side by side
    constexpr std::size_t kRowsPerBlock = 1024;
    parallel_for(count, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::size_t near = 0;
        for (std::size_t f = begin; f < end; ++f)
            if (const Element e = element_corners(made, static_cast<Index>(f)); e[3] < 0)
                folded[f] =
                    is_folded(parts, {place.row(e[0]), place.row(e[1]), place.row(e[2])}, near) ? 1 : 0;
    });
    for (std::size_t f = 0; f < count; ++f)
        if (folded[f] != 0)
            found.push_back(static_cast<Index>(f));
    return found;
}

} // namespace morph
