#include "formats/number_text.h"
#include "formats/text_scanner.h"
#include "formats/tuc_files.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>
#include <optional>
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
        const auto count = static_cast<std::size_t>(in_.index("the number of elements"));
        in_.end_line("the number of elements");
        if (count != elements_)
            in_.fail_at(0, "holds neighbours of " + std::to_string(count) + " elements, but the mesh has " +
                               std::to_string(elements_));
        in_.skip_line();
        in_.skip_line(); // a heading
        std::vector<Row> rows;
        while (in_.skip_white())
            rows.push_back(read_row(rows.size()));
        if (rows.size() != elements_)
            in_.fail_at(0, "holds neighbours of " + std::to_string(count) + " elements, but " +
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

std::size_t side_count(const Mesh& mesh, Index face)
{
    return static_cast<std::size_t>(corner_count(element_corners(mesh, face)));
}

/// Whether a row names the neighbours of an element, beginning with side @p first.
bool agrees(const Row& row, const Neighbors& around, std::size_t sides, std::size_t first)
{
    for (std::size_t k = 0; k < sides; ++k)
        if (row.around[k] != around[(k + first) % sides])
            return false;
    return row.sides == sides || (row.sides == 4 && sides == 3 && row.around[3] < 0);
}

std::string list(const Neighbors& around, std::size_t sides)
{
    std::string text;
    for (std::size_t k = 0; k < sides; ++k)
        text += (k == 0 ? "" : " ") + std::to_string(around[k] + 1);
    return text;
}

/// The side, as the mesh numbers them, that the first neighbour of an element is written for.
std::size_t first_side(const MeshData& data, std::size_t e)
{
    return tuc_element(data, e) == data.elements[e] ? 0 : 1;
}

/// The first of the elements with so many sides whose neighbours are others when sides are counted from
/// @p first on.
std::optional<std::size_t> first_mismatch(const std::vector<Row>& rows, const std::vector<Neighbors>& all,
                                          const MeshData& data, std::size_t sides, std::size_t first)
{
    for (std::size_t e = 0; e < rows.size(); ++e)
        if (static_cast<std::size_t>(corner_count(data.elements[e])) == sides &&
            !agrees(rows[e], all[e], sides, first_side(data, e) + first))
            return e;
    return std::nullopt;
}

} // namespace

std::vector<Neighbors> element_neighbors(const Mesh& mesh)
{
    const auto file_number = [&](FaceHandle f) {
        return f.is_valid() ? mesh.numbering.element[static_cast<std::size_t>(f.idx())] : -1;
    };
    std::vector<Neighbors> all(mesh.numbering.element.size(), Neighbors{-1, -1, -1, -1});
    for (const FaceHandle f : mesh.kernel.faces()) {
        const std::size_t sides = side_count(mesh, f.idx());
        const bool turned = mesh.numbering.turned[static_cast<std::size_t>(f.idx())];
        Neighbors& around = all[static_cast<std::size_t>(file_number(f))];
        HalfedgeHandle side = mesh.kernel.next_halfedge_handle(mesh.kernel.halfedge_handle(f));
        for (std::size_t k = 0; k < sides;
             ++k) { // from the first corner on; a turned element was listed backwards
            around[turned ? sides - 1 - k : k] =
                file_number(mesh.kernel.face_handle(mesh.kernel.opposite_halfedge_handle(side)));
            side = mesh.kernel.next_halfedge_handle(side);
        }
    }
    return all;
}

void write_tuc_neighbors(const Mesh& mesh, OutputFile& out)
{
    const std::vector<Neighbors> all = element_neighbors(mesh);
    const MeshData data = to_data(mesh);
    out.append(std::to_string(all.size()) + "\nid n1 n2 n3 n4\n");
    for (std::size_t e = 0; e < all.size(); ++e) {
        const auto sides = static_cast<std::size_t>(corner_count(data.elements[e]));
        const std::size_t first = first_side(data, e);
        append_number(out, e + 1);
        for (std::size_t k = 0; k < sides; ++k) {
            out.append(" ");
            append_number(out, all[e][(k + first) % sides] + 1);
        }
        out.append("\n");
    }
}

void check_tuc_neighbors(const InputBytes& file, const Mesh& mesh)
{
    NeighborsReader reader(file, mesh.numbering.element.size());
    const std::vector<Row> rows = reader.read();
    const std::vector<Neighbors> all = element_neighbors(mesh);
    const MeshData data = to_data(mesh);
    for (const std::size_t sides : {3U, 4U}) {
        const std::optional<std::size_t> wrong = first_mismatch(rows, all, data, sides, 0);
        bool fits = !wrong;
        for (std::size_t first = 1; first < sides && !fits; ++first)
            fits = !first_mismatch(rows, all, data, sides, first);
        if (!fits)
            reader.scanner().fail_at(rows[*wrong].position,
                                     "element " + std::to_string(*wrong + 1) + " has the neighbours " +
                                         list(rows[*wrong].around, rows[*wrong].sides) +
                                         ", but in the mesh " + list(all[*wrong], sides) + " (0: none)");
    }
}

} // namespace morph
