#include "tools/picture/view.h"

#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morph::picture {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kNothing{kInfinity, kInfinity, -kInfinity, -kInfinity};

void include(Box& box, const Points2& place, Index v)
{
    box.xmin = std::min(box.xmin, place(v, 0));
    box.ymin = std::min(box.ymin, place(v, 1));
    box.xmax = std::max(box.xmax, place(v, 0));
    box.ymax = std::max(box.ymax, place(v, 1));
}

Box box_of(const Points2& place, const std::vector<Index>& vertices)
{
    Box box = kNothing;
    for (const Index v : vertices)
        include(box, place, v);
    return box;
}

Box box_of_elements(const FlatMesh& flat)
{
    Box box = kNothing;
    for (const Element& element : flat.elements)
        for (int k = 0; k < corner_count(element); ++k)
            include(box, flat.place, element[static_cast<std::size_t>(k)]);
    return box;
}

/// Rows: to the right, upwards, towards the reader.
Eigen::Matrix3d projection()
{
    constexpr double kTurn = 35 * std::numbers::pi / 180;
    constexpr double kTilt = 25 * std::numbers::pi / 180;
    Eigen::Matrix3d axes;
    axes.row(0) << std::cos(kTurn), std::sin(kTurn), 0;
    axes.row(1) << -std::sin(kTurn) * std::sin(kTilt), std::cos(kTurn) * std::sin(kTilt), std::cos(kTilt);
    axes.row(2) = axes.row(0).cross(axes.row(1));
    return axes;
}

std::vector<std::vector<Index>> boundary_loops(const Kernel& kernel)
{
    std::vector<std::vector<Index>> loops;
    std::vector<bool> seen(kernel.n_halfedges(), false);
    for (const HalfedgeHandle start : kernel.halfedges()) {
        if (!kernel.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())])
            continue;
        auto& loop = loops.emplace_back();
        HalfedgeHandle h = start;
        do {
            seen[static_cast<std::size_t>(h.idx())] = true;
            loop.push_back(kernel.from_vertex_handle(h).idx());
            h = kernel.next_halfedge_handle(h);
        } while (h != start);
    }
    return loops;
}

void require_drawable(const FlatMesh& flat)
{
    if (flat.elements.empty())
        throw InputError("the mesh has no elements to draw");
    const double size = std::max(flat.box.width(), flat.box.height());
    const double far = std::max(
        {std::abs(flat.box.xmin), std::abs(flat.box.xmax), std::abs(flat.box.ymin), std::abs(flat.box.ymax)});
    constexpr double kLargest = 1e100; // far from overflow in everything done with it
    if (!(size > 0) || !(far < kLargest) || size < 1e-14 * far || size < 1 / kLargest)
        throw InputError("the mesh cannot be drawn: its coordinates span " + std::to_string(size) +
                         " around " + std::to_string(far));
}

} // namespace

Box joined(const Box& a, const Box& b)
{
    return {std::min(a.xmin, b.xmin), std::min(a.ymin, b.ymin), std::max(a.xmax, b.xmax),
            std::max(a.ymax, b.ymax)};
}

Box with_margin(const Box& box, double fraction)
{
    const double margin = fraction * std::max(box.width(), box.height());
    return {box.xmin - margin, box.ymin - margin, box.xmax + margin, box.ymax + margin};
}

Box with_aspect(const Box& box, double aspect)
{
    const double width = std::max(box.width(), box.height() * aspect);
    const double height = width / aspect;
    const double x = (box.xmin + box.xmax) / 2;
    const double y = (box.ymin + box.ymax) / 2;
    return {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
}

FlatMesh flattened(const Mesh& mesh)
{
    FlatMesh flat;
    flat.mesh = &mesh;
    flat.elements = element_table(mesh);
    if (mesh.dimension == 2) {
        flat.place = points(mesh).leftCols<2>();
    } else {
        const Points turned = points(mesh) * projection().transpose();
        flat.place = turned.leftCols<2>();
        flat.nearness = turned.col(2);
    }
    flat.box = box_of_elements(flat);
    flat.loops = boundary_loops(mesh.kernel);
    require_drawable(flat);
    return flat;
}

std::optional<Box> bodies_box(const FlatMesh& flat)
{
    constexpr double kWorthZooming = 0.4; // of the domain
    if (flat.mesh->dimension == 3 || flat.loops.size() < 2)
        return std::nullopt;
    std::vector<Box> boxes;
    for (const auto& loop : flat.loops)
        boxes.push_back(box_of(flat.place, loop));
    const auto outermost = std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
        return a.width() * a.height() < b.width() * b.height();
    });
    boxes.erase(outermost);
    Box bodies = kNothing;
    for (const Box& box : boxes)
        bodies = joined(bodies, box);
    const double share =
        std::max(bodies.width(), bodies.height()) / std::max(flat.box.width(), flat.box.height());
    if (!(share < kWorthZooming) || !(share > 0))
        return std::nullopt;
    return bodies;
}

} // namespace morph::picture
