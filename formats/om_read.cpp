#include "formats/message_text.h"
#include "formats/om_files.h"
#include "formats/om_properties.h"
#include "formats/surface.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace morph {

namespace {

constexpr std::size_t kHeaderBytes = 16;
constexpr unsigned kNewestMajor = 2;

class OmReader {
public:
    explicit OmReader(const InputBytes& file) : file_(file), properties_(file) {}

    MeshData read()
    {
        read_header();
        while (at_ < file_.bytes.size() && read_chunk()) {
        }
        if (vertices_ > 0 && mesh_.points.rows() == 0)
            fail(at_, "the file has no positions of its " + std::to_string(vertices_) + " vertices");
        add_faces();
        require_corners();
        properties_.add_to(mesh_);
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(std::size_t position, const std::string& what) const
    {
        throw InputError(file_.path + ": byte " + std::to_string(position) + ": " + what);
    }

    /// Go behind @p bytes bytes, which the file must have.
    std::string_view take(std::size_t count, std::size_t bytes_each)
    {
        const std::size_t left = file_.bytes.size() - at_;
        if (bytes_each > 0 && count > left / bytes_each)
            fail(at_, "expected " + std::to_string(count) + " times " + std::to_string(bytes_each) +
                          " bytes, but only " + std::to_string(left) + " follow; the file is cut off");
        at_ += count * bytes_each;
        return file_.bytes.substr(at_ - count * bytes_each, count * bytes_each);
    }

    unsigned integer(std::size_t bytes)
    {
        const std::string_view raw = take(1, bytes);
        unsigned value = 0;
        for (std::size_t i = bytes; i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(raw[i]);
        return value;
    }

    /// A whole number of which all bits set is -1.
    Index signed_integer(std::size_t bytes)
    {
        const unsigned value = integer(bytes);
        const unsigned unused = 32 - 8 * static_cast<unsigned>(bytes);
        return static_cast<Index>(value << unused) >> unused;
    }

    void read_header()
    {
        if (file_.bytes.size() < kHeaderBytes || !file_.bytes.starts_with("OM"))
            fail(0, "expected 'OM' and a header of 16 bytes");
        type_ = file_.bytes[2];
        if (type_ != 'T' && type_ != 'Q' && type_ != 'P')
            fail(2, "the mesh is of type " + quoted_text(file_.bytes.substr(2, 1)) + ", expected T, Q or P");
        version_ = static_cast<unsigned char>(file_.bytes[3]);
        if (version_ >> 5 > kNewestMajor)
            fail(3, "version " + version_text() + " is newer than 2, which is supported");
        file_.set_version(version_text() + ", binary");
        at_ = 4;
        vertices_ = integer(4);
        faces_ = integer(4);
        edges_ = integer(4);
        const std::size_t left = file_.bytes.size() - kHeaderBytes;
        if (vertices_ > left / 12 || faces_ > left || edges_ > left)
            fail(4, "there should be " + std::to_string(vertices_) + " vertices, " + std::to_string(faces_) +
                        " faces and " + std::to_string(edges_) + " edges, but only " + std::to_string(left) +
                        " bytes follow");
    }

    std::string version_text() const
    {
        return std::to_string(version_ >> 5) + "." + std::to_string(version_ & 31U);
    }

    static OmChunk chunk_of(unsigned value)
    {
        return {static_cast<OmEntity>(value >> 2 & 7U),
                static_cast<OmType>(value >> 5 & 15U),
                (value >> 1 & 1U) != 0,
                (value >> 10 & 1U) != 0,
                (value >> 11 & 7U) + 1,
                value >> 14 & 3U};
    }

    std::string_view text() { return take(1, integer(1)); }

    std::size_t count_of(OmEntity entity, std::size_t position) const
    {
        switch (entity) {
        case OmEntity::vertex:
            return vertices_;
        case OmEntity::mesh:
            return 1;
        case OmEntity::face:
            return faces_;
        case OmEntity::edge:
            return edges_;
        case OmEntity::halfedge:
            return 2 * edges_;
        default:
            fail(position, "a chunk of an unknown kind");
        }
    }

    /// False at the end of the chunks.
    bool read_chunk()
    {
        const std::size_t position = at_;
        const OmChunk chunk = chunk_of(integer(2));
        if (chunk.entity == OmEntity::end)
            return false;
        const std::size_t count = count_of(chunk.entity, position);
        if (chunk.type == OmType::custom)
            read_custom(chunk, count);
        else if (chunk.type == OmType::topology)
            read_topology(chunk, count, position);
        else if (chunk.type == OmType::position && chunk.entity == OmEntity::vertex)
            read_points(chunk, position);
        else
            properties_.add_attribute(chunk, count, take(count, number_bytes(chunk) * chunk.dimension));
        return true;
    }

    static std::size_t number_bytes(const OmChunk& chunk)
    {
        return (chunk.real ? std::size_t{4} : std::size_t{1}) << chunk.bits;
    }

    void read_custom(const OmChunk& chunk, std::size_t count)
    {
        const std::string_view name = chunk.named ? text() : "";
        const std::string_view type = version_ >= (2U << 5 | 1U) ? text() : "";
        const std::size_t size = integer(4);
        properties_.add_custom(chunk.entity, name, type, count, take(1, size));
    }

    void read_points(const OmChunk& chunk, std::size_t position)
    {
        if (!chunk.real || chunk.dimension != 3 || chunk.bits > 1 || mesh_.points.rows() > 0)
            fail(position, "positions are not three numbers in single or double precision, given once");
        const std::size_t begin = at_;
        const std::string_view raw = take(vertices_, 3 * number_bytes(chunk));
        std::vector<double> xyz(3 * vertices_);
        const bool swapped = std::endian::native != std::endian::little;
        copy_numbers({chunk.bits == 0 ? NumberType::float32 : NumberType::float64, raw, swapped}, xyz.data());
        const auto odd = std::find_if(xyz.begin(), xyz.end(), [](double x) { return !std::isfinite(x); });
        if (odd != xyz.end()) {
            const auto number = static_cast<std::size_t>(odd - xyz.begin());
            fail(begin + number * number_bytes(chunk),
                 "a coordinate of vertex " + std::to_string(number / 3) + " is not finite");
        }
        set_points(mesh_, xyz);
    }

    void read_topology(const OmChunk& chunk, std::size_t count, std::size_t position)
    {
        const std::size_t bytes = std::size_t{1} << chunk.bits;
        if (bytes > 4)
            fail(position, "numbers of vertices or halfedges with more than 32 bits");
        if (chunk.entity == OmEntity::face && version_ >> 5 < 2)
            read_faces(bytes);
        else if (chunk.entity == OmEntity::face)
            read_numbers(face_halfedges_, take(count, bytes), bytes);
        else if (chunk.entity == OmEntity::halfedge)
            read_numbers(halfedges_, take(count, 3 * bytes), bytes);
        else
            take(count, bytes); // a halfedge of each vertex, which the faces imply
    }

    void read_numbers(std::vector<Index>& numbers, std::string_view raw, std::size_t bytes)
    {
        const std::size_t end = at_;
        at_ -= raw.size();
        numbers.clear();
        numbers.reserve(raw.size() / bytes);
        while (at_ < end)
            numbers.push_back(signed_integer(bytes));
    }

    /// Of version 1: the corners of each face.
    void read_faces(std::size_t bytes)
    {
        mesh_.elements.reserve(faces_);
        for (std::size_t f = 0; f < faces_; ++f) {
            const std::size_t position = at_;
            const unsigned corners = type_ == 'T' ? 3 : type_ == 'Q' ? 4 : integer(2);
            require_corner_count(corners, position);
            Element element{-1, -1, -1, -1};
            for (std::size_t k = 0; k < corners; ++k) {
                const unsigned vertex = integer(bytes);
                if (vertex >= vertices_)
                    fail(at_ - bytes, "face " + std::to_string(f) + " names vertex " +
                                          std::to_string(vertex) + ", but the mesh has " +
                                          std::to_string(vertices_));
                element[k] = static_cast<Index>(vertex);
            }
            mesh_.elements.push_back(element);
        }
    }

    void require_corner_count(std::size_t corners, std::size_t position) const
    {
        if (corners != 3 && corners != 4)
            fail(position, "face " + std::to_string(mesh_.elements.size()) + " has " +
                               std::to_string(corners) +
                               " corners, but only triangles and quads are supported");
    }

    /// Of version 2: each face from its halfedge on, over the next ones.
    void add_faces()
    {
        if (version_ >> 5 < 2)
            return;
        for (const Index first : face_halfedges_) {
            Element element{-1, -1, -1, -1};
            std::size_t corners = 0;
            Index halfedge = first;
            do {
                const auto place = 3 * static_cast<std::size_t>(halfedge);
                if (halfedge < 0 || place >= halfedges_.size())
                    fail(at_, "face " + std::to_string(mesh_.elements.size()) + " names halfedge " +
                                  std::to_string(halfedge) + ", but the mesh has " +
                                  std::to_string(halfedges_.size() / 3));
                if (corners < 4)
                    element[corners] = halfedges_[place + 1];
                halfedge = halfedges_[place];
            } while (++corners <= 4 && halfedge != first);
            require_corner_count(corners, at_);
            mesh_.elements.push_back(element);
        }
    }

    void require_corners() const
    {
        if (mesh_.elements.size() != faces_)
            fail(at_, "there should be " + std::to_string(faces_) + " faces, but the file has " +
                          std::to_string(mesh_.elements.size()));
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            for (int k = 0; k < corner_count(mesh_.elements[e]); ++k) {
                const Index v = mesh_.elements[e][static_cast<std::size_t>(k)];
                if (v < 0 || v >= mesh_.points.rows())
                    fail(at_, "face " + std::to_string(e) + " names vertex " + std::to_string(v) +
                                  ", but the mesh has " + std::to_string(mesh_.points.rows()));
            }
    }

    const InputBytes& file_;
    OmProperties properties_;
    MeshData mesh_;
    std::size_t at_ = 0;
    char type_ = 'P';
    unsigned version_ = 0;
    std::size_t vertices_ = 0;
    std::size_t faces_ = 0;
    std::size_t edges_ = 0;
    std::vector<Index> halfedges_; ///< of each: the next one, the vertex it leads to, its face
    std::vector<Index> face_halfedges_;
};

} // namespace

MeshData read_om(const InputBytes& file)
{
    return OmReader(file).read();
}

} // namespace morph
