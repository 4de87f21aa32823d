// Wavefront OBJ: vertices and faces; normals, texture, materials, lines and groups are passed over.
#include "formats/format.h"
#include "formats/surface.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

/// Statements that say nothing about the vertices and faces.
constexpr std::array<std::string_view, 25> kIgnored{
    "vt",     "vn",     "vp",        "g",      "o",     "s",        "mg",       "l",   "p",
    "usemtl", "mtllib", "usemap",    "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj",
    "deg",    "cstype", "trace_obj", "ctech",  "stech", "parm",     "end"};

class ObjReader {
public:
    explicit ObjReader(const InputBytes& file) : in_(file.path, file.bytes, '#') {}

    MeshData read()
    {
        while (in_.skip_white())
            statement();
        const auto vertices = static_cast<Index>(xyz_.size() / 3);
        if (largest_ >= vertices)
            in_.fail_at(largest_position_, "a face names vertex " +
                                               std::to_string(largest_ + std::int64_t{1}) +
                                               ", but the mesh has " + std::to_string(vertices));
        set_points(mesh_, xyz_);
        return std::move(mesh_);
    }

private:
    void statement()
    {
        const std::size_t position = in_.position();
        const std::string_view word = in_.word("a statement");
        if (word == "v")
            read_vertex();
        else if (word == "f" || word == "fo") // fo: as old files have it
            read_face(position);
        else if (std::find(kIgnored.begin(), kIgnored.end(), word) == kIgnored.end()) {
            in_.seek(position);
            in_.fail_expected("an OBJ statement such as v or f");
        }
        skip_statement();
    }

    /// A line that ends with a backslash goes on in the next one.
    bool at_end()
    {
        while (!in_.at_line_end()) {
            const std::string_view rest = in_.rest();
            if (!rest.starts_with("\\\n") && !rest.starts_with("\\\r\n"))
                return false;
            in_.skip_line();
        }
        return true;
    }

    void skip_statement()
    {
        while (in_.rest_of_line().ends_with('\\'))
            in_.skip_line();
        in_.skip_line();
    }

    void read_vertex()
    {
        for (int k = 0; k < 3; ++k) {
            at_end();
            if (!in_.try_real(xyz_.emplace_back()))
                in_.fail_expected("a coordinate of vertex " + std::to_string((xyz_.size() + 2) / 3));
        }
    }

    void read_face(std::size_t position)
    {
        corners_.clear();
        while (!at_end()) {
            corners_.push_back(corner());
            if (in_.rest().starts_with('/')) // texture and normal
                in_.word("the rest of a corner");
        }
        mesh_.elements.push_back(face_element(in_, position, corners_));
    }

    /// From 1, or counted back from the last vertex so far (-1).
    Index corner()
    {
        const std::size_t position = in_.position();
        const std::int64_t number = in_.integer("the number of a vertex");
        const auto so_far = static_cast<std::int64_t>(xyz_.size() / 3);
        const std::int64_t vertex = number > 0 ? number - 1 : so_far + number;
        if (number == 0 || vertex < 0 || vertex > INT32_MAX)
            in_.fail_at(position, "a face names vertex " + std::to_string(number) + ", but there are " +
                                      std::to_string(so_far) + " so far, numbered from 1");
        if (vertex > largest_) {
            largest_ = static_cast<Index>(vertex);
            largest_position_ = position;
        }
        return static_cast<Index>(vertex);
    }

    TextScanner in_;
    MeshData mesh_;
    std::vector<double> xyz_;
    std::vector<Index> corners_;
    Index largest_ = -1; ///< vertex that a face names, which may come later in the file
    std::size_t largest_position_ = 0;
};

MeshData read_obj(const InputBytes& file)
{
    return ObjReader(file).read();
}

void write_obj(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        out.append("v ");
        append_point(out, mesh.points, v);
    }
    for (const Element& element : mesh.elements) {
        out.append("f ");
        append_corners(out, element, 1);
    }
}

} // namespace

extern const Format obj_format;
const Format obj_format{"obj", {".obj"}, "Wavefront OBJ", {.surface = true}, read_obj, write_obj};

} // namespace morph
