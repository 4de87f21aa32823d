#include "formats/off/binary.h"

#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace morph {

namespace {

/// One of the ways in which programs write the format.
struct Variant {
    std::endian order;
    bool colored_faces; ///< a number of colour components behind each face
};

class BinaryOffReader {
public:
    BinaryOffReader(const InputBytes& file, const OffHeader& header, std::size_t begin, Variant variant)
        : file_(file), header_(header), at_(begin), variant_(variant)
    {
    }

    MeshData read()
    {
        const std::size_t width =
            (header_.normal ? 3U : 0U) + (header_.color ? 4U : 0U) + (header_.texture ? 2U : 0U);
        const std::size_t vertices = count("vertices", 4 * (3 + width));
        const std::size_t faces = count("faces", variant_.colored_faces ? 8 : 4);
        take<std::int32_t>(); // the number of edges
        read_vertices(vertices, width);
        mesh_.elements.reserve(faces);
        for (std::size_t f = 0; f < faces; ++f)
            read_face();
        if (at_ != file_.bytes.size())
            fail(at_, "expected the end of the file after " + std::to_string(faces) + " faces");
        return std::move(mesh_);
    }

    std::size_t face_colors() const { return face_colors_; }

private:
    [[noreturn]] void fail(std::size_t position, const std::string& what) const
    {
        throw InputError(file_.path + ": byte " + std::to_string(position) + ": " + what);
    }

    template <class T>
    T take()
    {
        std::array<char, sizeof(T)> raw{};
        if (file_.bytes.size() - at_ < raw.size())
            fail(at_, "the file ends within its numbers; it is cut off");
        std::copy_n(file_.bytes.data() + at_, raw.size(), raw.data());
        at_ += raw.size();
        if (variant_.order != std::endian::native)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }

    std::size_t count(const std::string& what, std::size_t least_bytes)
    {
        const std::size_t position = at_;
        const auto value = take<std::int32_t>();
        const std::size_t rest = file_.bytes.size() - at_;
        if (value < 0 || static_cast<std::size_t>(value) > rest / least_bytes)
            fail(position, "there should be " + std::to_string(value) + " " + what + ", but only " +
                               std::to_string(rest) + " bytes follow");
        return static_cast<std::size_t>(value);
    }

    void read_vertices(std::size_t vertices, std::size_t width)
    {
        std::vector<double> xyz;
        std::vector<double> numbers;
        xyz.reserve(3 * vertices);
        numbers.reserve(width * vertices);
        for (std::size_t v = 0; v < vertices; ++v) {
            for (int k = 0; k < 3; ++k) {
                const std::size_t position = at_;
                xyz.push_back(static_cast<double>(take<float>()));
                if (!std::isfinite(xyz.back()))
                    fail(position, "a coordinate of vertex " + std::to_string(v) + " is not finite");
            }
            for (std::size_t k = 0; k < width; ++k)
                numbers.push_back(static_cast<double>(take<float>()));
        }
        set_points(mesh_, xyz);
        add_off_fields(header_, numbers, width, mesh_);
    }

    void read_face()
    {
        const std::size_t position = at_;
        const auto corners = take<std::int32_t>();
        const std::string face = "face " + std::to_string(mesh_.elements.size());
        if (corners != 3 && corners != 4)
            fail(position, face + " has " + std::to_string(corners) +
                               " corners, but only triangles and quads are supported");
        Element element{-1, -1, -1, -1};
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k) {
            element[k] = take<std::int32_t>();
            if (element[k] < 0 || element[k] >= mesh_.points.rows())
                fail(at_ - 4, face + " names vertex " + std::to_string(element[k]) + ", but the mesh has " +
                                  std::to_string(mesh_.points.rows()));
        }
        mesh_.elements.push_back(element);
        if (variant_.colored_faces)
            skip_color();
    }

    void skip_color()
    {
        const std::size_t position = at_;
        const auto components = take<std::int32_t>();
        if (components < 0 || static_cast<std::size_t>(components) > (file_.bytes.size() - at_) / 4)
            fail(position, "a face has " + std::to_string(components) + " colour components");
        at_ += 4 * static_cast<std::size_t>(components);
        face_colors_ += components > 0 ? 1 : 0;
    }

    const InputBytes& file_;
    OffHeader header_;
    std::size_t at_;
    Variant variant_;
    MeshData mesh_;
    std::size_t face_colors_ = 0;
};

} // namespace

MeshData read_off_binary(const InputBytes& file, const OffHeader& header, std::size_t begin)
{
    constexpr std::array<Variant, 4> variants{{{std::endian::big, true},
                                               {std::endian::big, false},
                                               {std::endian::little, true},
                                               {std::endian::little, false}}};
    std::optional<InputError> first_error;
    for (const Variant& variant : variants) {
        try {
            BinaryOffReader reader(file, header, begin, variant);
            MeshData mesh = reader.read();
            if (reader.face_colors() > 0)
                file.warn("the colours of " + std::to_string(reader.face_colors()) +
                          " face(s) were left out");
            return mesh;
        } catch (const InputError& error) {
            if (!first_error)
                first_error = error;
        }
    }
    throw InputError(*first_error);
}

} // namespace morph
