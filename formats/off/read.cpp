#include "formats/off/binary.h"
#include "formats/off/files.h"
#include "formats/off/header.h"
#include "formats/text/surface_text.h"

#include <array>

namespace morph {

namespace {

constexpr std::size_t kMostNumbers = 9; ///< behind the coordinates: normal, colour and texture

class OffReader {
public:
    OffReader(const InputBytes& file, TextScanner& in, const OffHeader& header)
        : file_(file), in_(in), header_(header)
    {
    }

    MeshData read()
    {
        const std::size_t vertices = count("the number of vertices");
        const std::size_t faces = count("the number of faces");
        in_.skip_line(); // the number of edges, which is not needed
        read_vertices(vertices);
        mesh_.elements.reserve(faces);
        for (std::size_t f = 0; f < faces; ++f)
            read_face();
        if (in_.skip_white())
            in_.fail("expected the end of the file after " + std::to_string(faces) + " faces, found " +
                     in_.found());
        if (colored_faces_ > 0)
            file_.warn("the colours of " + std::to_string(colored_faces_) + " face(s) were left out");
        return std::move(mesh_);
    }

private:
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
            if (!in_.at_line_end())
                read_numbers(v);
            in_.skip_line();
        }
        set_points(mesh_, xyz);
        const bool asked = header_.normal || header_.color || header_.texture;
        const bool all_alike = numbers_.size() == width_ * vertices;
        if ((asked || !numbers_.empty()) &&
            !(asked && all_alike && add_off_fields(header_, numbers_, width_, mesh_)))
            file_.warn(
                "the numbers behind the coordinates of vertices were left out: they are not those that "
                "the first line announces");
    }

    /// What stands behind the coordinates of a vertex; the first one says how many numbers that are.
    void read_numbers(std::size_t vertex)
    {
        std::array<double, kMostNumbers> row{};
        std::size_t size = 0;
        while (size < row.size() && !in_.at_line_end() && in_.try_real(row[size]))
            ++size;
        if (vertex == 0)
            width_ = size;
        if (size == width_ && numbers_.size() == width_ * vertex)
            numbers_.insert(numbers_.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
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
        colored_faces_ += in_.at_line_end() ? 0 : 1;
        in_.skip_line();
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

    const InputBytes& file_;
    TextScanner& in_;
    OffHeader header_;
    MeshData mesh_;
    std::vector<double> numbers_; ///< behind the coordinates, as long as every vertex has equally many
    std::size_t width_ = 0;       ///< how many
    std::size_t colored_faces_ = 0;
    std::vector<Index> corners_;
};

} // namespace

MeshData read_off(const InputBytes& file)
{
    TextScanner in(file.path, file.bytes, '#');
    const OffHeader header = read_off_header(in);
    if (header.binary) {
        in.skip_line();
        file.set_version("binary");
        return read_off_binary(file, header, in.position());
    }
    file.set_version("ASCII");
    return OffReader(file, in, header).read();
}

} // namespace morph
