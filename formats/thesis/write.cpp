#include "formats/text/number_text.h"
#include "formats/thesis/files.h"
#include "formats/thesis/nodes.h"

#include <algorithm>
#include <string>

namespace morph {

namespace {

void append_coordinates(const MeshData& mesh, Index vertex, char separator, OutputFile& out)
{
    char* const y = number_text(out.room(2 * kLongestNumber), mesh.points(vertex, 0), ' ');
    out.advance_to(number_text(y, mesh.points(vertex, 1), separator));
}

/// How a reader numbers the vertices.
struct ReadNumbers {
    ThesisNodes nodes;
    std::vector<Index> vertex; ///< n: the number it gets; -1: a corner of no element
};

ReadNumbers numbers_when_read(const MeshData& mesh)
{
    ReadNumbers numbers;
    numbers.vertex.assign(static_cast<std::size_t>(mesh.points.rows()), -1);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (const Index v : thesis_element(mesh, e))
            if (v >= 0 && numbers.vertex[static_cast<std::size_t>(v)] < 0)
                numbers.vertex[static_cast<std::size_t>(v)] =
                    numbers.nodes.number_of(mesh.points(v, 0), mesh.points(v, 1));
    return numbers;
}

void append_elements(const MeshData& mesh, OutputFile& out)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        out.advance_to(number_text(out.room(kLongestNumber), e + 1, ' '));
        const Element element = thesis_element(mesh, e);
        for (std::size_t k = 0; k < 4; ++k)
            if (element[k] < 0)
                out.append("0 0\n");
            else
                append_coordinates(mesh, element[k], k < 3 ? ' ' : '\n', out);
    }
}

} // namespace

Element thesis_element(const MeshData& mesh, std::size_t number)
{
    Element element = mesh.elements[number];
    if (corner_count(element) == 4 && mesh.points.row(element[3]).isZero(0))
        std::rotate(element.begin(), element.begin() + 1, element.end());
    return element;
}

void write_thesis(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    if (mesh.elements.empty()) {
        out.append(std::to_string(mesh.points.rows()) + "\n");
        for (Index v = 0; v < mesh.points.rows(); ++v)
            append_coordinates(mesh, v, '\n', out);
        return;
    }
    const auto quads = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                     [](const Element& element) { return corner_count(element) == 4; });
    out.append(std::to_string(numbers_when_read(mesh).nodes.size()) + " " +
               std::to_string(static_cast<std::ptrdiff_t>(mesh.elements.size()) - quads) + " " +
               std::to_string(quads) + "\nid x1 y1 x2 y2 x3 y3 x4 y4\n");
    append_elements(mesh, out);
}

std::vector<std::string> thesis_losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost;
    if (mesh.elements.empty()) {
        for (const Field& field : mesh.fields)
            if (field.location == FieldLocation::vertex)
                lost.push_back("nodal field " + field.name + " of points without elements");
        return lost;
    }
    const ReadNumbers numbers = numbers_when_read(mesh);
    const auto loose = std::count(numbers.vertex.begin(), numbers.vertex.end(), -1);
    const auto joined = mesh.points.rows() - loose - numbers.nodes.size();
    bool in_order = true;
    for (std::size_t v = 0; v < numbers.vertex.size(); ++v)
        in_order = in_order && (numbers.vertex[v] < 0 || numbers.vertex[v] == static_cast<Index>(v));
    if (loose > 0)
        lost.push_back(std::to_string(loose) + " vertices of no element");
    if (joined > 0)
        lost.push_back(std::to_string(joined) +
                       " vertices at the place of others: they are joined when read");
    if (!in_order)
        lost.emplace_back("the numbers of vertices: they are renumbered when read");
    return lost;
}

} // namespace morph
