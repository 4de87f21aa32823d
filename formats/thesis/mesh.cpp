#include "formats/text/surface_text.h"
#include "formats/text/text_scanner.h"
#include "formats/thesis/files.h"
#include "formats/thesis/nodes.h"

#include <algorithm>
#include <map>
#include <string>

namespace morph {

namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

/// Elements as the file gives them: by the coordinates of their corners.
struct Rows {
    std::vector<Corners> corners;
    std::vector<std::size_t> positions; ///< in the file
};

struct Counts {
    Index nodes = 0;
    Index triangles = 0;
    Index quads = 0;
    std::size_t position = 0; ///< in the file
};

class ThesisReader {
public:
    explicit ThesisReader(const InputBytes& file) : in_(file.path, file.bytes) {}

    MeshData read()
    {
        if (!in_.skip_white())
            in_.fail("is empty, but the counts of a mesh or a list of destinations were expected");
        counts_.position = in_.position();
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
            in_.fail_at(counts_.position, "counts " + std::to_string(counts_.nodes) + " nodes, but " +
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
            for (Eigen::Vector2d& corner : rows_.corners.emplace_back()) {
                corner.x() = in_.real("the x of a corner");
                corner.y() = in_.real("the y of a corner");
            }
            in_.end_line("four corners");
            rows_.positions.push_back(position);
        }
        const auto expected =
            static_cast<std::size_t>(counts_.triangles) + static_cast<std::size_t>(counts_.quads);
        if (rows_.corners.size() != expected)
            in_.fail_at(counts_.position, "counts " + std::to_string(counts_.triangles) + " triangles and " +
                                              std::to_string(counts_.quads) + " quads, but " +
                                              std::to_string(rows_.corners.size()) + " elements follow");
    }

    static bool ends_at_origin(const Corners& row) { return row[3].isZero(0); }

    /// Which rows are quads; see read_thesis().
    std::vector<bool> quads() const
    {
        std::vector<bool> quad(rows_.corners.size());
        std::vector<std::size_t> open; // rows that may be either
        auto missing = static_cast<std::size_t>(counts_.quads);
        for (std::size_t e = 0; e < quad.size(); ++e) {
            quad[e] = !ends_at_origin(rows_.corners[e]);
            if (!quad[e])
                open.push_back(e);
            else if (missing-- == 0)
                in_.fail_at(rows_.positions[e], "element " + std::to_string(e + 1) +
                                                    " is one quad more than the " +
                                                    std::to_string(counts_.quads) + " counted");
        }
        for (const std::size_t e : chosen(open, missing))
            quad[e] = true;
        return quad;
    }

    /// Those of the open rows that are the missing quads.
    std::vector<std::size_t> chosen(std::vector<std::size_t> open, std::size_t missing) const
    {
        if (missing == 0)
            return {};
        const std::size_t choice = open.size();
        if (missing < open.size()) {
            const std::map<Side, int> diagonals = sides_along_diagonals(open);
            std::erase_if(open, [&](std::size_t e) {
                const Corners& p = rows_.corners[e];
                return !is_convex(p) || diagonals.at(side(p[0], p[2])) > 1;
            });
        }
        if (missing != open.size())
            in_.fail_at(counts_.position, "counts " + std::to_string(counts_.quads) + " quads, " +
                                              std::to_string(missing) + " of them among the " +
                                              std::to_string(choice) +
                                              " elements whose fourth corner is 0 0, but neither the counts "
                                              "nor the elements show which");
        return open;
    }

    using Side = std::array<std::array<double, 2>, 2>;
    static Side side(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    {
        Side ends{std::array{a.x(), a.y()}, std::array{b.x(), b.y()}};
        std::sort(ends.begin(), ends.end());
        return ends;
    }

    /// How many elements have a side along the diagonal from corner 1 to 3 of some rows, the rows themselves
    /// taken for triangles and so among them.
    std::map<Side, int> sides_along_diagonals(const std::vector<std::size_t>& rows) const
    {
        std::map<Side, int> count;
        for (const std::size_t e : rows)
            count[side(rows_.corners[e][0], rows_.corners[e][2])] = 0;
        for (const Corners& p : rows_.corners) {
            const std::size_t corners = ends_at_origin(p) ? 3 : 4;
            for (std::size_t k = 0; k < corners; ++k)
                if (const auto found = count.find(side(p[k], p[(k + 1) % corners])); found != count.end())
                    ++found->second;
        }
        return count;
    }

    static bool is_convex(const Corners& p)
    {
        int left = 0;
        int right = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Eigen::Vector2d next = p[(k + 1) % 4] - p[k];
            const Eigen::Vector2d after = p[(k + 2) % 4] - p[(k + 1) % 4];
            const double turn = next.x() * after.y() - next.y() * after.x();
            left += turn > 0 ? 1 : 0;
            right += turn < 0 ? 1 : 0;
        }
        return left == 4 || right == 4;
    }

    MeshData build()
    {
        MeshData mesh;
        ThesisNodes nodes;
        const std::vector<bool> quad = quads();
        for (std::size_t e = 0; e < quad.size(); ++e) {
            Element element{-1, -1, -1, -1};
            for (std::size_t k = 0; k < (quad[e] ? 4U : 3U); ++k)
                element[k] = nodes.number_of(rows_.corners[e][k].x(), rows_.corners[e][k].y());
            mesh.elements.push_back(element);
        }
        if (nodes.size() != counts_.nodes)
            in_.fail_at(counts_.position,
                        "counts " + std::to_string(counts_.nodes) + " nodes, but the elements have " +
                            std::to_string(nodes.size()) + " corners with different coordinates");
        set_points(mesh, nodes.coordinates());
        return mesh;
    }

    TextScanner in_;
    Counts counts_;
    Rows rows_;
};

} // namespace

MeshData read_thesis(const InputBytes& file)
{
    return ThesisReader(file).read();
}

} // namespace morph
