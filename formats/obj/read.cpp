#include "formats/obj/files.h"
#include "formats/obj/names.h"
#include "formats/text/surface_text.h"

#include <algorithm>
#include <array>
#include <set>

namespace morph {

namespace {

/// Statements that say nothing about the vertices and elements, or something that a mesh has no place for.
constexpr std::array<std::string_view, 21> kIgnored{
    "vt",         "vn",     "vp",     "s",         "mg",    "p",        "mtllib",
    "usemap",     "maplib", "bevel",  "c_interp",  "end",   "d_interp", "lod",
    "shadow_obj", "deg",    "cstype", "trace_obj", "ctech", "stech",    "parm"};

class ObjReader {
public:
    explicit ObjReader(const InputBytes& file) : file_(file), in_(file.path, file.bytes, '#') {}

    MeshData read()
    {
        file_.set_version("ASCII");
        while (in_.skip_white())
            statement();
        const auto vertices = static_cast<Index>(xyz_.size() / 3);
        if (largest_ >= vertices)
            in_.fail_at(largest_position_, "a face or line names vertex " +
                                               std::to_string(largest_ + std::int64_t{1}) +
                                               ", but the mesh has " + std::to_string(vertices));
        set_points(mesh_, xyz_);
        mesh_.groups = names_.take_groups();
        mesh_.markers = names_.take_markers();
        add_colors();
        for (const std::string_view word : ignored_)
            file_.warn("statements " + std::string(word) + " were left out");
        if (has_weights_)
            file_.warn("weights of vertices were left out");
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
        else if (word == "l")
            read_line(position);
        else if (!read_names(word))
            ignore(word, position);
        skip_statement();
    }

    bool read_names(std::string_view word)
    {
        if (word == "g") {
            std::vector<std::string_view> names;
            while (!at_end())
                names.push_back(in_.word("the name of a group"));
            if (names.size() > kMostObjGroups)
                in_.fail("a statement g with " + std::to_string(names.size()) + " names, expected at most " +
                         std::to_string(kMostObjGroups));
            names_.set_groups(names);
        } else if (word == "o") {
            names_.set_object(in_.rest_of_line());
        } else if (word == "usemtl") {
            names_.set_material(in_.rest_of_line());
        } else {
            return false;
        }
        return true;
    }

    void ignore(std::string_view word, std::size_t position)
    {
        if (std::find(kIgnored.begin(), kIgnored.end(), word) == kIgnored.end()) {
            in_.seek(position);
            in_.fail_expected("an OBJ statement such as v or f");
        }
        if (word != "s" && word != "mtllib") // smoothing and colours, which no solver asks for
            ignored_.insert(word);
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

    /// Behind x, y, z may stand a weight, or a colour, or both.
    void read_vertex()
    {
        for (int k = 0; k < 3; ++k) {
            at_end();
            if (!in_.try_real(xyz_.emplace_back()))
                in_.fail_expected("a coordinate of vertex " + std::to_string((xyz_.size() + 2) / 3));
        }
        std::array<double, 4> more{};
        std::size_t count = 0;
        while (!at_end() && count < more.size() && in_.try_real(more[count]))
            ++count;
        if (count >= 3)
            colors_.insert(colors_.end(), more.begin() + static_cast<std::ptrdiff_t>(count) - 3,
                           more.begin() + static_cast<std::ptrdiff_t>(count));
        else if (count == 1 && more[0] != 1)
            has_weights_ = true;
    }

    void add_colors()
    {
        if (colors_.empty())
            return;
        if (colors_.size() != xyz_.size())
            return file_.warn("colours were left out, which only " + std::to_string(colors_.size() / 3) +
                              " of " + std::to_string(xyz_.size() / 3) + " vertices have");
        const auto rows = static_cast<Eigen::Index>(colors_.size() / 3);
        mesh_.fields.push_back({std::string(kObjColor), FieldLocation::vertex,
                                Eigen::Map<const Matrix>(colors_.data(), rows, 3)});
    }

    void read_corners()
    {
        corners_.clear();
        while (!at_end()) {
            corners_.push_back(corner());
            if (in_.rest().starts_with('/')) // texture and normal
                in_.word("the rest of a corner");
        }
    }

    void read_face(std::size_t position)
    {
        read_corners();
        names_.add_element(static_cast<Index>(mesh_.elements.size()));
        mesh_.elements.push_back(face_element(in_, position, corners_));
    }

    /// A line through two vertices or more.
    void read_line(std::size_t position)
    {
        read_corners();
        if (corners_.size() < 2)
            in_.fail_at(position,
                        "a line of " + std::to_string(corners_.size()) + " vertices, expected 2 or more");
        for (std::size_t i = 1; i < corners_.size(); ++i)
            names_.add_edge({corners_[i - 1], corners_[i]});
    }

    /// From 1, or counted back from the last vertex so far (-1).
    Index corner()
    {
        const std::size_t position = in_.position();
        const std::int64_t number = in_.integer("the number of a vertex");
        const auto so_far = static_cast<std::int64_t>(xyz_.size() / 3);
        const std::int64_t vertex = number > 0 ? number - 1 : so_far + number;
        if (number == 0 || vertex < 0 || vertex > INT32_MAX)
            in_.fail_at(position, "a face or line names vertex " + std::to_string(number) +
                                      ", but there are " + std::to_string(so_far) +
                                      " so far, numbered from 1");
        if (vertex > largest_) {
            largest_ = static_cast<Index>(vertex);
            largest_position_ = position;
        }
        return static_cast<Index>(vertex);
    }

    const InputBytes& file_;
    TextScanner in_;
    MeshData mesh_;
    ObjNames names_;
    std::vector<double> xyz_;
    std::vector<double> colors_;
    std::vector<Index> corners_;
    std::set<std::string_view> ignored_;
    bool has_weights_ = false;
    Index largest_ = -1; ///< vertex that a face names, which may come later in the file
    std::size_t largest_position_ = 0;
};

} // namespace

MeshData read_obj(const InputBytes& file)
{
    return ObjReader(file).read();
}

} // namespace morph
