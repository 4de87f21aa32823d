#include "libmorph/remap/convex_parts.h"

#include "libmorph/core/parallel.h"
#include "libmorph/geometry/plane_element.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192;

/// Turn a piece round; a side then starts where it ended.
void reverse(ConvexPart& piece)
{
    ConvexPolygon& outline = piece.outline;
    std::reverse(outline.corner.begin(), outline.corner.begin() + outline.corners);
    std::reverse(outline.side.begin(), outline.side.begin() + outline.corners - 1);
    std::reverse(piece.vertices.begin(), piece.vertices.begin() + outline.corners);
}

/// An element and its vertices, from one walk around it.
struct Corners {
    PlaneElement element{{}, 0};
    Element vertices{-1, -1, -1, -1};
};

Corners corners_of(const Mesh& mesh, Index face)
{
    Corners found;
    const HalfedgeHandle first = mesh.kernel.halfedge_handle(FaceHandle(face));
    HalfedgeHandle side = first;
    do {
        const VertexHandle v = mesh.kernel.to_vertex_handle(side);
        const auto k = static_cast<std::size_t>(found.element.corners++);
        found.vertices[k] = v.idx();
        found.element.corner[k] = {mesh.kernel.point(v)[0], mesh.kernel.point(v)[1]};
        side = mesh.kernel.next_halfedge_handle(side);
    } while (side != first);
    return found;
}

/// Set a piece to these corners of an element, numbered from 0.
void set_piece(const Corners& corners, std::span<const int> numbers, ConvexPart& piece)
{
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto k = static_cast<std::size_t>(numbers[i]);
        const int next = numbers[i + 1 < numbers.size() ? i + 1 : 0];
        const bool is_side = next == (numbers[i] + 1 < corners.element.corners ? numbers[i] + 1 : 0);
        piece.vertices[i] = corners.vertices[k];
        piece.outline.add(corners.element.corner[k], is_side ? numbers[i] : kNoSide);
    }
    piece.area = area(piece.outline);
    if (piece.area < 0) {
        reverse(piece);
        piece.area = -piece.area;
    }
}

bool stays_whole(const PlaneElement& element, Cut cut)
{
    return element.corners == 3 || (cut == Cut::where_dented && is_convex(element));
}

} // namespace

ConvexParts split_convex(const Mesh& mesh, Index face, Cut cut)
{
    constexpr std::array<int, 4> kAll{0, 1, 2, 3};
    const Corners corners = corners_of(mesh, face);
    ConvexParts pieces;
    if (stays_whole(corners.element, cut)) {
        const auto count = static_cast<std::size_t>(corners.element.corners);
        set_piece(corners, {kAll.data(), count}, pieces.piece[0]);
        pieces.count = 1;
        return pieces;
    }
    for (const std::array<int, 3>& half : halves(inner_diagonal(corners.element)))
        set_piece(corners, half, pieces.piece[static_cast<std::size_t>(pieces.count++)]);
    return pieces;
}

int convex_part_count(const Mesh& mesh, Index face, Cut cut)
{
    return stays_whole(plane_element(mesh, face), cut) ? 1 : 2;
}

double total_area(const Mesh& mesh)
{
    const auto faces = static_cast<std::size_t>(element_count(mesh));
    std::vector<double> sums((faces + kRowsPerBlock - 1) / kRowsPerBlock, 0);
    parallel_for(faces, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            for (const ConvexParts pieces = split_convex(mesh, static_cast<Index>(f), Cut::where_dented);
                 const ConvexPart& piece : pieces.all())
                sums[begin / kRowsPerBlock] += piece.area;
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace morph
