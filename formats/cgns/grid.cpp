#include "formats/cgns/grid.h"

#include <algorithm>

namespace morph {

namespace {

std::array<Index, 3> strides_of(const CgnsZone& zone)
{
    return {1, zone.size[0], zone.size[0] * zone.size[1]};
}

} // namespace

std::vector<int> long_axes(const CgnsBox& box)
{
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis)
        if (box.high[static_cast<std::size_t>(axis)] > box.low[static_cast<std::size_t>(axis)])
            axes.push_back(axis);
    return axes;
}

Index grid_vertex(const CgnsZone& zone, const std::array<Index, 3>& at)
{
    const std::array<Index, 3> strides = strides_of(zone);
    return at[0] * strides[0] + at[1] * strides[1] + at[2] * strides[2];
}

Index grid_stride(const CgnsZone& zone, int axis)
{
    return strides_of(zone)[static_cast<std::size_t>(axis)];
}

CgnsBox whole_grid(const CgnsZone& zone)
{
    return {{0, 0, 0}, {zone.size[0] - 1, zone.size[1] - 1, zone.size[2] - 1}};
}

void for_each_point(const CgnsBox& box, const std::function<void(const std::array<Index, 3>&)>& visit)
{
    for (Index k = box.low[2]; k <= box.high[2]; ++k)
        for (Index j = box.low[1]; j <= box.high[1]; ++j)
            for (Index i = box.low[0]; i <= box.high[0]; ++i)
                visit({i, j, k});
}

void for_each_cell_of(const CgnsBox& box, const std::function<void(const std::array<Index, 3>&)>& visit)
{
    CgnsBox corners = box; // of least indices
    for (const int axis : long_axes(box))
        --corners.high[static_cast<std::size_t>(axis)];
    for_each_point(corners, visit);
}

Element grid_quad(const CgnsZone& zone, const std::array<Index, 3>& at, int first_axis, int second_axis)
{
    const Index v = grid_vertex(zone, at);
    const Index a = grid_stride(zone, first_axis);
    const Index b = grid_stride(zone, second_axis);
    return {v, v + a, v + a + b, v + b};
}

void make_cgns_grid(CgnsZone& zone)
{
    const CgnsBox grid = whole_grid(zone);
    const std::vector<int> axes = long_axes(grid);
    if (axes.size() == 2)
        for_each_cell_of(grid, [&](const std::array<Index, 3>& at) {
            zone.mesh.elements.push_back(grid_quad(zone, at, axes[0], axes[1]));
        });
    if (axes.size() == 3)
        for_each_cell_of(grid, [&](const std::array<Index, 3>& at) {
            VolumeCell cell{VolumeShape::hexahedron, {}};
            const Element base = grid_quad(zone, at, 0, 1);
            for (std::size_t k = 0; k < 4; ++k) {
                cell.corners[k] = base[k];
                cell.corners[k + 4] = base[k] + grid_stride(zone, 2);
            }
            zone.cells.push_back(cell);
        });
}

} // namespace morph
