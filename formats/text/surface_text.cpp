#include "formats/text/surface_text.h"

#include "formats/text/number_text.h"

namespace morph {

void set_points(MeshData& mesh, const std::vector<double>& xyz)
{
    mesh.points = Eigen::Map<const Points>(xyz.data(), static_cast<Eigen::Index>(xyz.size() / 3), 3);
    mesh.dimension = dimension_of(mesh.points);
}

Element face_element(const TextScanner& scanner, std::size_t position, const std::vector<Index>& corners)
{
    if (corners.size() != 3 && corners.size() != 4)
        scanner.fail_at(position, "a face of " + std::to_string(corners.size()) +
                                      " corners, but only triangles and quads are supported");
    return {corners[0], corners[1], corners[2], corners.size() == 4 ? corners[3] : -1};
}

void append_corners(OutputFile& out, const Element& element, Index base)
{
    const int corners = corner_count(element);
    char* to = out.room(4 * kLongestNumber);
    for (int i = 0; i < corners; ++i)
        to = number_text(to, element[static_cast<std::size_t>(i)] + base, i + 1 < corners ? ' ' : '\n');
    out.advance_to(to);
}

void append_point(OutputFile& out, const Points& points, Eigen::Index vertex)
{
    char* to = out.room(3 * kLongestNumber);
    for (int k = 0; k < 3; ++k)
        to = number_text(to, points(vertex, k), k < 2 ? ' ' : '\n');
    out.advance_to(to);
}

} // namespace morph
