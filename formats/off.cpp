// Geomview's Object File Format, as text: a header, counts, a line for each vertex and for each face.
#include "formats/format.h"
#include "formats/surface.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

/// What follows the coordinates of a vertex (normal, colour, texture) is on its line and passed over.
constexpr std::array<std::string_view, 8> kHeaders{"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                   "STOFF", "STCOFF", "STNOFF", "STCNOFF"};

class OffReader {
public:
    explicit OffReader(const InputBytes& file) : in_(file.path, file.bytes, '#') {}

    MeshData read()
    {
        header();
        const std::size_t vertices = count("the number of vertices");
        const std::size_t faces = count("the number of faces");
        in_.skip_line(); // the number of edges, which nobody reads
        read_vertices(vertices);
        mesh_.elements.reserve(faces);
        for (std::size_t f = 0; f < faces; ++f)
            read_face();
        if (in_.skip_white())
            in_.fail("expected the end of the file after " + std::to_string(faces) + " faces, found " +
                     in_.found());
        return std::move(mesh_);
    }

private:
    void header()
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        const std::string_view word = in_.word("OFF");
        if (std::find(kHeaders.begin(), kHeaders.end(), word) == kHeaders.end()) {
            in_.seek(position);
            in_.fail_expected("OFF, or OFF after C, N or ST for what else vertices have");
        }
        if (in_.rest_of_line() == "BINARY")
            in_.fail_at(position, "binary OFF files are not supported; write it as text");
        in_.seek(position + word.size());
    }

    /// A count of lines that the file has room for: two bytes each at least.
    std::size_t count(std::string_view what)
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        const auto value = static_cast<std::size_t>(in_.index(what));
        if (value > in_.rest().size() / 2)
            in_.fail_at(position, std::string(what) + " is " + std::to_string(value) + ", but only " +
                                      std::to_string(in_.rest().size()) + " bytes follow");
        return value;
    }

    void read_vertices(std::size_t vertices)
    {
        std::vector<double> xyz;
        xyz.reserve(3 * vertices);
        for (std::size_t v = 0; v < vertices; ++v) {
            in_.skip_white();
            for (int k = 0; k < 3; ++k)
                if (!in_.try_real(xyz.emplace_back()))
                    in_.fail_expected("a coordinate of vertex " + std::to_string(v));
            in_.skip_line();
        }
        set_points(mesh_, xyz);
    }

    void read_face()
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        Index corners = 0;
        if (!in_.try_index(corners))
            in_.fail_expected("the number of corners of " + face());
        corners_.clear();
        for (Index i = 0; i < corners; ++i)
            corners_.push_back(corner());
        mesh_.elements.push_back(face_element(in_, position, corners_));
        in_.skip_line(); // its colour
    }

    Index corner()
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        Index vertex = 0;
        if (!in_.try_index(vertex))
            in_.fail_expected("a corner of " + face());
        if (vertex >= mesh_.points.rows())
            in_.fail_at(position, face() + " names vertex " + std::to_string(vertex) + ", but the mesh has " +
                                      std::to_string(mesh_.points.rows()));
        return vertex;
    }

    std::string face() const { return "face " + std::to_string(mesh_.elements.size()); }

    TextScanner in_;
    MeshData mesh_;
    std::vector<Index> corners_;
};

MeshData read_off(const InputBytes& file)
{
    return OffReader(file).read();
}

void write_off(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    out.append("OFF\n" + std::to_string(mesh.points.rows()) + " " + std::to_string(mesh.elements.size()) +
               " 0\n");
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        append_point(out, mesh.points, v);
    for (const Element& element : mesh.elements) {
        out.append(corner_count(element) == 3 ? "3 " : "4 ");
        append_corners(out, element, 0);
    }
}

} // namespace

extern const Format off_format;
const Format off_format{"off",    {".off"}, "Geomview Object File Format", {.surface = true},
                        read_off, write_off};

} // namespace morph
