#include "formats/number_text.h"
#include "formats/surface.h"
#include "formats/text_scanner.h"
#include "formats/tuc_files.h"

#include <algorithm>
#include <map>
#include <string>

namespace morph {

namespace {

/// Elements as the file gives them: by the coordinates of their corners.
struct Rows {
    std::vector<std::array<Eigen::Vector2d, 4>> corners;
    std::vector<std::size_t> positions; ///< in the file
};

struct Counts {
    Index nodes = 0;
    Index triangles = 0;
    Index quads = 0;
};

/// Numbers nodes as their coordinates first appear.
class NodeTable {
public:
    Index number_of(const Eigen::Vector2d& p)
    {
        const auto [found, is_new] =
            numbers_.try_emplace({p.x(), p.y()}, static_cast<Index>(numbers_.size()));
        if (is_new)
            xyz_.insert(xyz_.end(), {p.x(), p.y(), 0});
        return found->second;
    }
    const std::vector<double>& coordinates() const { return xyz_; }
    Index size() const { return static_cast<Index>(numbers_.size()); }

private:
    std::map<std::array<double, 2>, Index> numbers_;
    std::vector<double> xyz_;
};

class MeshReader {
public:
    explicit MeshReader(const InputBytes& file) : in_(file.path, file.bytes) {}

    MeshData read()
    {
        if (!in_.skip_white())
            in_.fail("is empty, but the counts of a mesh or a list of destinations were expected");
        counts_.nodes = in_.index("the number of nodes");
        if (in_.at_line_end())
            return read_points();
        counts_.triangles = in_.index("the number of triangles");
        counts_.quads = in_.index("the number of quads");
        in_.end_line("the three counts");
        in_.skip_line();
        in_.skip_line(); // a heading
        read_rows();
        return build();
    }

private:
    MeshData read_points()
    {
        in_.skip_line();
        std::vector<double> xyz;
        while (in_.skip_white()) {
            const double x = in_.real("the x of a destination");
            xyz.insert(xyz.end(), {x, in_.real("the y of a destination"), 0});
            in_.end_line(
                "x and y (a mesh has three counts in its first line; function values and neighbours are "
                "no mesh)");
        }
        const std::size_t found = xyz.size() / 3;
        if (found != static_cast<std::size_t>(counts_.nodes))
            in_.fail_at(0, "counts " + std::to_string(counts_.nodes) + " nodes, but " +
                               std::to_string(found) + " follow");
        MeshData mesh;
        set_points(mesh, xyz);
        return mesh;
    }

    void read_rows()
    {
        while (in_.skip_white()) {
            const std::size_t position = in_.position();
            const Index id = in_.index("the number of an element");
            if (static_cast<std::size_t>(id) != rows_.corners.size() + 1)
                in_.fail_at(position, "element " + std::to_string(rows_.corners.size() + 1) +
                                          " was expected, found " + std::to_string(id));
            auto& corners = rows_.corners.emplace_back();
            for (Eigen::Vector2d& corner : corners) {
                corner.x() = in_.real("the x of a corner") + 0.0; // -0 is 0
                corner.y() = in_.real("the y of a corner") + 0.0;
            }
            in_.end_line("four corners");
            rows_.positions.push_back(position);
        }
        const auto expected =
            static_cast<std::size_t>(counts_.triangles) + static_cast<std::size_t>(counts_.quads);
        if (rows_.corners.size() != expected)
            in_.fail_at(0, "counts " + std::to_string(counts_.triangles) + " triangles and " +
                               std::to_string(counts_.quads) + " quads, but " +
                               std::to_string(rows_.corners.size()) + " elements follow");
    }

    static bool ends_at_origin(const std::array<Eigen::Vector2d, 4>& row) { return row[3].isZero(0); }

    /// Which rows are quads; see read_tuc().
    std::vector<bool> quads() const
    {
        std::vector<bool> quad(rows_.corners.size());
        std::vector<std::size_t> open;
        std::size_t missing = static_cast<std::size_t>(counts_.quads);
        for (std::size_t e = 0; e < quad.size(); ++e) {
            quad[e] = !ends_at_origin(rows_.corners[e]);
            if (!quad[e])
                open.push_back(e);
            else if (missing-- == 0)
                in_.fail_at(rows_.positions[e],
                            "counts " + std::to_string(counts_.quads) + " quads, but this is one more");
        }
        if (missing > 0 && missing < open.size()) {
            const std::map<Side, int> sides = count_sides();
            std::erase_if(open, [&](std::size_t e) { return !could_be_quad(rows_.corners[e], sides); });
        }
        if (missing > 0 && missing != open.size())
            in_.fail_at(0, "counts " + std::to_string(missing) +
                               " quads with a corner at 0 0, but which of the " +
                               std::to_string(open.size()) + " elements that could be they are is not told");
        for (std::size_t i = 0; i < open.size() && missing > 0; ++i)
            quad[open[i]] = true;
        return quad;
    }

    using Side = std::array<std::array<double, 2>, 2>;
    static Side side(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    {
        Side ends{std::array{a.x(), a.y()}, std::array{b.x(), b.y()}};
        std::sort(ends.begin(), ends.end());
        return ends;
    }

    /// How many elements have each side, rows that end at the origin taken for triangles.
    std::map<Side, int> count_sides() const
    {
        std::map<Side, int> count;
        for (const auto& p : rows_.corners) {
            const std::size_t corners = ends_at_origin(p) ? 3 : 4;
            for (std::size_t k = 0; k < corners; ++k)
                ++count[side(p[k], p[(k + 1) % corners])];
        }
        return count;
    }

    /// Convex with its corner at the origin, and what would be its diagonal is no other element's side.
    static bool could_be_quad(const std::array<Eigen::Vector2d, 4>& p, const std::map<Side, int>& sides)
    {
        int left = 0, right = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Eigen::Vector2d next = p[(k + 1) % 4] - p[k], after = p[(k + 2) % 4] - p[(k + 1) % 4];
            const double turn = next.x() * after.y() - next.y() * after.x();
            left += turn > 0 ? 1 : 0;
            right += turn < 0 ? 1 : 0;
        }
        return (left == 4 || right == 4) && sides.at(side(p[0], p[2])) == 1;
    }

    MeshData build()
    {
        MeshData mesh;
        NodeTable nodes;
        const std::vector<bool> quad = quads();
        for (std::size_t e = 0; e < quad.size(); ++e) {
            Element element{-1, -1, -1, -1};
            for (std::size_t k = 0; k < (quad[e] ? 4U : 3U); ++k)
                element[k] = nodes.number_of(rows_.corners[e][k]);
            mesh.elements.push_back(element);
        }
        if (nodes.size() != counts_.nodes)
            in_.fail_at(0, "counts " + std::to_string(counts_.nodes) + " nodes, but the elements have " +
                               std::to_string(nodes.size()) + " corners with different coordinates");
        set_points(mesh, nodes.coordinates());
        return mesh;
    }

    TextScanner in_;
    Counts counts_;
    Rows rows_;
};

} // namespace

Element tuc_element(const MeshData& mesh, std::size_t number)
{
    Element element = mesh.elements[number];
    if (corner_count(element) == 4 && mesh.points.row(element[3]).isZero(0))
        std::rotate(element.begin(), element.begin() + 1, element.end());
    return element;
}

MeshData read_tuc(const InputBytes& file)
{
    return MeshReader(file).read();
}

void write_tuc(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    const auto coordinates = [&](Index v) {
        char* end = number_text(out.room(2 * kLongestNumber), mesh.points(v, 0), ' ');
        out.advance_to(number_text(end, mesh.points(v, 1)));
    };
    if (mesh.elements.empty()) {
        out.append(std::to_string(mesh.points.rows()) + "\n");
        for (Index v = 0; v < mesh.points.rows(); ++v) {
            coordinates(v);
            out.append("\n");
        }
        return;
    }
    const auto triangles = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                         [](const Element& e) { return corner_count(e) == 3; });
    NodeTable nodes;
    for (const Element& element : mesh.elements)
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(element)); ++k)
            nodes.number_of({mesh.points(element[k], 0) + 0.0, mesh.points(element[k], 1) + 0.0});
    out.append(std::to_string(nodes.size()) + " " + std::to_string(triangles) + " " +
               std::to_string(static_cast<std::ptrdiff_t>(mesh.elements.size()) - triangles) +
               "\nid x1 y1 x2 y2 x3 y3 x4 y4\n");
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        append_number(out, e + 1);
        for (const Index v : tuc_element(mesh, e)) {
            out.append(" ");
            if (v < 0)
                out.append("0 0");
            else
                coordinates(v);
        }
        out.append("\n");
    }
}

} // namespace morph
