#include "formats/text/number_text.h"
#include "formats/text/text_scanner.h"
#include "formats/thesis/files.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>
#include <string>

namespace morph {

namespace {

using Neighbors = std::array<Index, 4>;

struct Row {
    Neighbors around{-1, -1, -1, -1};
    std::size_t sides = 0;
    std::size_t position = 0;
};

class NeighborsReader {
public:
    NeighborsReader(const InputBytes& file, std::size_t elements)
        : in_(file.path, file.bytes), elements_(elements)
    {
    }

    std::vector<Row> read()
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        const auto count = static_cast<std::size_t>(in_.index("the number of elements"));
        in_.end_line("the number of elements");
        if (count != elements_)
            in_.fail_at(position, "holds neighbours of " + std::to_string(count) +
                                      " elements, but the mesh has " + std::to_string(elements_));
        in_.skip_line();
        in_.skip_line(); // a heading
        std::vector<Row> rows;
        while (in_.skip_white())
            rows.push_back(read_row(rows.size()));
        if (rows.size() != elements_)
            in_.fail_at(position, "holds neighbours of " + std::to_string(count) + " elements, but " +
                                      std::to_string(rows.size()) + " rows follow");
        return rows;
    }

    const TextScanner& scanner() const { return in_; }

private:
    Row read_row(std::size_t e)
    {
        Row row;
        row.position = in_.position();
        const Index id = in_.index("the number of an element");
        if (static_cast<std::size_t>(id) != e + 1)
            in_.fail_at(row.position,
                        "element " + std::to_string(e + 1) + " was expected, found " + std::to_string(id));
        while (row.sides < 4 && !in_.at_line_end()) {
            const Index neighbor = in_.index("the number of a neighbour");
            const bool none = neighbor == 0 || static_cast<std::size_t>(neighbor) > elements_;
            row.around[row.sides++] = none ? -1 : neighbor - 1;
        }
        in_.end_line("three or four neighbours");
        return row;
    }

    TextScanner in_;
    std::size_t elements_;
};

/// How a file may list the sides of its elements.
struct SideOrder {
    bool as_written = false; ///< corners in the order of thesis_element(), not as the mesh lists them
    std::size_t first = 0;   ///< the corner that the first side begins at
};

/// The neighbours of an element as a file of that order lists them.
Neighbors in_order(const Neighbors& around, const MeshData& mesh, std::size_t e, const SideOrder& order)
{
    const auto sides = static_cast<std::size_t>(corner_count(mesh.elements[e]));
    const bool from_second = order.as_written && thesis_element(mesh, e) != mesh.elements[e];
    Neighbors listed{-1, -1, -1, -1};
    for (std::size_t k = 0; k < sides; ++k)
        listed[k] = around[(k + order.first + (from_second ? 1 : 0)) % sides];
    return listed;
}

/// Elements whose row in the file has other neighbours than the mesh.
struct Mismatches {
    std::size_t count = 0;
    std::size_t first = 0;
    Neighbors expected{}; ///< of the first
};

/// Compare the rows of the elements with so many sides.
Mismatches compare(const std::vector<Row>& rows, const std::vector<Neighbors>& all, const MeshData& mesh,
                   std::size_t sides, const SideOrder& order)
{
    Mismatches found;
    for (std::size_t e = 0; e < rows.size(); ++e) {
        if (static_cast<std::size_t>(corner_count(mesh.elements[e])) != sides)
            continue;
        const Neighbors expected = in_order(all[e], mesh, e, order);
        const bool right_length = rows[e].sides == sides || (sides == 3 && rows[e].sides == 4);
        if (right_length && rows[e].around == expected)
            continue;
        if (found.count++ == 0) {
            found.first = e;
            found.expected = expected;
        }
    }
    return found;
}

/// As compare(), for the order that fits best.
Mismatches compare_in_best_order(const std::vector<Row>& rows, const std::vector<Neighbors>& all,
                                 const MeshData& mesh, std::size_t sides)
{
    Mismatches best = compare(rows, all, mesh, sides, {});
    for (const bool as_written : {false, true})
        for (std::size_t first = 0; first < sides && best.count > 0; ++first) {
            const Mismatches other = compare(rows, all, mesh, sides, {as_written, first});
            if (other.count < best.count)
                best = other;
        }
    return best;
}

std::string list(const Neighbors& around, std::size_t sides)
{
    std::string text;
    for (std::size_t k = 0; k < sides; ++k)
        text += ' ' + std::to_string(around[k] + 1);
    return text.empty() ? " none at all" : text;
}

} // namespace

std::vector<Neighbors> element_neighbors(const Mesh& mesh)
{
    const auto file_number = [&](FaceHandle f) {
        return f.is_valid() ? mesh.numbering.element[static_cast<std::size_t>(f.idx())] : -1;
    };
    std::vector<Neighbors> all(mesh.numbering.element.size(), Neighbors{-1, -1, -1, -1});
    for (const FaceHandle f : mesh.kernel.faces()) {
        const auto sides = static_cast<std::size_t>(corner_count(element_corners(mesh, f.idx())));
        const bool turned = mesh.numbering.reversed[static_cast<std::size_t>(f.idx())];
        Neighbors& around = all[static_cast<std::size_t>(file_number(f))];
        HalfedgeHandle side = mesh.kernel.next_halfedge_handle(mesh.kernel.halfedge_handle(f));
        for (std::size_t k = 0; k < sides; ++k) {
            // from the first corner on, and backwards where the file lists the element so
            around[turned ? sides - 1 - k : k] =
                file_number(mesh.kernel.face_handle(mesh.kernel.opposite_halfedge_handle(side)));
            side = mesh.kernel.next_halfedge_handle(side);
        }
    }
    return all;
}

void write_thesis_neighbors(const Mesh& mesh, OutputFile& out)
{
    const std::vector<Neighbors> all = element_neighbors(mesh);
    const MeshData data = to_mesh_data(mesh);
    out.append(std::to_string(all.size()) + "\nid n1 n2 n3 n4\n");
    for (std::size_t e = 0; e < all.size(); ++e) {
        const Neighbors around = in_order(all[e], data, e, {.as_written = true});
        char* end = number_text(out.room(5 * kLongestNumber), e + 1);
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(data.elements[e])); ++k) {
            *end++ = ' ';
            end = number_text(end, around[k] + 1);
        }
        *end++ = '\n';
        out.advance_to(end);
    }
}

void check_thesis_neighbors(const InputBytes& file, const Mesh& mesh)
{
    NeighborsReader reader(file, mesh.numbering.element.size());
    const std::vector<Row> rows = reader.read();
    const std::vector<Neighbors> all = element_neighbors(mesh);
    const MeshData data = to_mesh_data(mesh);
    for (const std::size_t sides : {3U, 4U}) {
        const Mismatches wrong = compare_in_best_order(rows, all, data, sides);
        if (wrong.count > 0)
            reader.scanner().fail_at(rows[wrong.first].position,
                                     "element " + std::to_string(wrong.first + 1) + " has the neighbours" +
                                         list(rows[wrong.first].around, rows[wrong.first].sides) +
                                         ", but in the mesh" + list(wrong.expected, sides) + " (0: none)");
    }
}

} // namespace morph
