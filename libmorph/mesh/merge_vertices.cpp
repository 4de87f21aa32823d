#include "libmorph/mesh/merge_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace morph {

namespace {

/// Kept vertices by the cell of a grid of the tolerance's size, as chains through next.
class VertexGrid {
public:
    VertexGrid(const Points& points, double tolerance) : points_(points), tolerance_(tolerance)
    {
        if (points.rows() > 0)
            origin_ = points.colwise().minCoeff();
        next_.assign(static_cast<std::size_t>(points.rows()), -1);
    }

    /// The first kept vertex within the tolerance of @p v, or -1.
    Index near(Index v) const
    {
        Index best = -1;
        const std::array<double, 3> home = cell(v);
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k) {
                    const Index found = first_in({home[0] + i, home[1] + j, home[2] + k}, v);
                    if (found >= 0 && (best < 0 || found < best))
                        best = found;
                }
        return best;
    }

    void keep(Index v)
    {
        const auto [entry, is_new] = heads_.try_emplace(key(cell(v)), v);
        if (!is_new)
            next_[static_cast<std::size_t>(v)] = std::exchange(entry->second, v);
    }

private:
    std::array<double, 3> cell(Index v) const
    {
        std::array<double, 3> place{};
        for (int axis = 0; axis < 3; ++axis)
            place[static_cast<std::size_t>(axis)] =
                std::floor((points_(v, axis) - origin_(axis)) / tolerance_);
        return place;
    }

    /// Cells with the same key only cost a look: the distance decides.
    static std::uint64_t key(const std::array<double, 3>& place)
    {
        constexpr std::uint64_t kMixer = 0x9E3779B97F4A7C15ULL; // 2^64 over the golden ratio
        std::uint64_t key = 0;
        for (const double p : place) {
            constexpr double kRange = 4294967296.0;
            const double wrapped = p - kRange * std::floor(p / kRange);
            key = (key ^ static_cast<std::uint64_t>(wrapped)) * kMixer;
            key ^= key >> 29U;
        }
        return key;
    }

    Index first_in(const std::array<double, 3>& place, Index v) const
    {
        Index best = -1;
        const auto head = heads_.find(key(place));
        for (Index w = head == heads_.end() ? -1 : head->second; w >= 0;
             w = next_[static_cast<std::size_t>(w)])
            if ((points_.row(w) - points_.row(v)).norm() <= tolerance_)
                best = w; // chains run from the last kept to the first
        return best;
    }

    const Points& points_;
    double tolerance_;
    Eigen::RowVector3d origin_ = Eigen::RowVector3d::Zero();
    std::unordered_map<std::uint64_t, Index> heads_;
    std::vector<Index> next_;
};

/// The element without corners that repeat another; three corners or fewer leave -1 at the end.
Element without_repeats(const Element& element)
{
    Element kept{-1, -1, -1, -1};
    std::size_t count = 0;
    for (const Index v : element)
        if (v >= 0 && std::find(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(count), v) ==
                          kept.begin() + static_cast<std::ptrdiff_t>(count))
            kept[count++] = v;
    return kept;
}

/// Takes away the elements with fewer than three corners, with their rows and group members.
Index drop_collapsed(MeshData& mesh)
{
    std::vector<Index> kept;
    std::vector<Index> place(mesh.elements.size(), -1);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (mesh.elements[e][2] >= 0) {
            place[e] = static_cast<Index>(kept.size());
            kept.push_back(static_cast<Index>(e));
        }
    const Index dropped = static_cast<Index>(mesh.elements.size() - kept.size());
    if (dropped == 0)
        return 0;
    for (std::size_t e = 0; e < kept.size(); ++e)
        mesh.elements[e] = mesh.elements[static_cast<std::size_t>(kept[e])];
    mesh.elements.resize(kept.size());
    for (Field& field : mesh.fields)
        if (field.location == FieldLocation::element)
            field.values = Matrix(field.values(kept, Eigen::all));
    for (ElementGroup& group : mesh.groups) {
        for (Index& element : group.elements)
            element = place[static_cast<std::size_t>(element)];
        std::erase(group.elements, -1);
    }
    return dropped;
}

} // namespace

Merged merge_vertices(MeshData& mesh, double tolerance)
{
    const auto n = static_cast<Index>(mesh.points.rows());
    VertexGrid grid(mesh.points, tolerance);
    std::vector<Index> kept;
    std::vector<Index> target(static_cast<std::size_t>(n));
    for (Index v = 0; v < n; ++v) {
        const Index near = grid.near(v);
        target[static_cast<std::size_t>(v)] =
            near < 0 ? static_cast<Index>(kept.size()) : target[static_cast<std::size_t>(near)];
        if (near < 0) {
            grid.keep(v);
            kept.push_back(v);
        }
    }
    Merged merged;
    merged.vertices = n - static_cast<Index>(kept.size());
    if (merged.vertices == 0)
        return merged;
    mesh.points = Points(mesh.points(kept, Eigen::all));
    for (Element& element : mesh.elements) {
        for (Index& v : element)
            v = v < 0 ? v : target[static_cast<std::size_t>(v)];
        element = without_repeats(element);
    }
    merged.elements = drop_collapsed(mesh);
    for (Marker& marker : mesh.markers) {
        for (auto& edge : marker.edges)
            for (Index& v : edge)
                v = target[static_cast<std::size_t>(v)];
        merged.edges += static_cast<Index>(
            std::erase_if(marker.edges, [](const auto& edge) { return edge[0] == edge[1]; }));
    }
    for (Field& field : mesh.fields)
        if (field.location == FieldLocation::vertex)
            field.values = Matrix(field.values(kept, Eigen::all));
    return merged;
}

} // namespace morph
