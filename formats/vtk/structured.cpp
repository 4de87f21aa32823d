#include "formats/vtk/structured.h"

#include "formats/binary/gzip.h"
#include "formats/mesh/cell_types.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <limits>

namespace morph {

namespace {

constexpr std::uint8_t kHexahedron = 12;

/// Adds the cells of one grid, each from its corner of lowest index.
class CellMaker {
public:
    CellMaker(VtkGrid& grid, const GridSize& size)
        : grid_(grid),
          size_(size), step_{1, static_cast<Index>(size[0]), static_cast<Index>(size[0] * size[1])}
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (size[axis] > 1)
                axes_.push_back(axis);
    }

    void add_all()
    {
        if (axes_.empty() || point_total() == 0)
            return;
        if (axes_.size() == 2 && axes_[1] - axes_[0] == 2)
            std::swap(axes_[0], axes_[1]); // z before x keeps the sense of the axes
        const auto cells = [this](std::size_t axis) { return size_[axis] > 1 ? size_[axis] - 1 : 1; };
        for (std::size_t k = 0; k < cells(2); ++k)
            for (std::size_t j = 0; j < cells(1); ++j)
                for (std::size_t i = 0; i < cells(0); ++i)
                    add(static_cast<Index>(i + size_[0] * (j + size_[1] * k)));
    }

private:
    std::size_t point_total() const { return size_[0] * size_[1] * size_[2]; }

    void add(Index corner)
    {
        const Index a = step_[axes_[0]];
        if (axes_.size() == 1)
            return add_cell(kEdgeCell, {corner, corner + a});
        const Index b = step_[axes_[1]];
        std::vector<Index> corners{corner, corner + a, corner + a + b, corner + b};
        if (axes_.size() == 2)
            return add_cell(kQuadCell, corners);
        for (std::size_t base = 0; base < 4; ++base)
            corners.push_back(corners[base] + step_[axes_[2]]);
        add_cell(kHexahedron, corners);
    }

    void add_cell(int type, const std::vector<Index>& corners)
    {
        grid_.types.push_back(static_cast<std::uint8_t>(type));
        grid_.corners.insert(grid_.corners.end(), corners.begin(), corners.end());
        grid_.ends.push_back(static_cast<std::int64_t>(grid_.corners.size()));
    }

    VtkGrid& grid_;
    GridSize size_;
    std::array<Index, 3> step_;
    std::vector<std::size_t> axes_; ///< those with more than one point
};

} // namespace

std::size_t point_count(const GridSize& size, const std::string& path)
{
    std::size_t points = 1;
    for (const std::size_t along_axis : size) {
        points *= along_axis;
        if (points > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
            throw InputError(path + ": a grid of " + std::to_string(size[0]) + " x " +
                             std::to_string(size[1]) + " x " + std::to_string(size[2]) +
                             " points is larger than the " +
                             std::to_string(std::numeric_limits<Index>::max()) + " points supported");
    }
    require_memory(path, points * 3 * sizeof(double));
    return points;
}

void add_structured_cells(VtkGrid& grid, const GridSize& size)
{
    CellMaker(grid, size).add_all();
}

Points rectilinear_points(const std::array<std::vector<double>, 3>& axes)
{
    Points points(static_cast<Index>(axes[0].size() * axes[1].size() * axes[2].size()), 3);
    Index row = 0;
    for (const double z : axes[2])
        for (const double y : axes[1])
            for (const double x : axes[0])
                points.row(row++) << x, y, z;
    return points;
}

} // namespace morph
