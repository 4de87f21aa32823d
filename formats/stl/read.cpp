#include "formats/stl/files.h"
#include "formats/stl/point_welder.h"
#include "formats/text/names_in_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <unordered_map>

namespace morph {

namespace {

constexpr std::size_t kHeaderBytes = 84;     ///< a title of 80 bytes and the number of triangles
constexpr std::size_t kFacetBytes = 50;      ///< normal, three corners, two bytes of anything
constexpr std::size_t kBatch = 256;          ///< triangles that are welded at a time
constexpr std::size_t kUsualTextBytes = 250; ///< of a triangle, for a guess how many there are

/// Collects triangles; a closed surface has about half as many vertices.
class Triangles {
public:
    explicit Triangles(std::size_t count) : welder_(count / 2 + 2) { mesh_.elements.reserve(count); }

    void add(const std::array<PointWelder::Corner, 3>& corners)
    {
        std::copy(corners.begin(), corners.end(), batch_.data() + 3 * size_);
        if (++size_ == kBatch)
            weld();
    }

    std::size_t count() const { return mesh_.elements.size() + size_; }

    MeshData mesh()
    {
        weld();
        set_points(mesh_, welder_.take_points());
        return std::move(mesh_);
    }

private:
    void weld()
    {
        std::array<Index, 3 * kBatch> numbers{};
        welder_.weld(batch_.data(), 3 * size_, numbers.data());
        for (std::size_t i = 0; i < 3 * size_; i += 3)
            mesh_.elements.push_back({numbers[i], numbers[i + 1], numbers[i + 2], -1});
        size_ = 0;
    }

    PointWelder welder_;
    MeshData mesh_;
    std::array<PointWelder::Corner, 3 * kBatch> batch_{};
    std::size_t size_ = 0;
};

/// "facet normal … outer loop vertex … vertex … vertex … endloop endfacet", in any case of letters.
class AsciiStlReader {
public:
    explicit AsciiStlReader(const InputBytes& file)
        : in_(file.path, file.bytes), triangles_(file.bytes.size() / kUsualTextBytes)
    {
    }

    MeshData read()
    {
        while (in_.skip_white())
            solid();
        MeshData mesh = triangles_.mesh();
        mesh.groups = std::move(groups_);
        return mesh;
    }

private:
    /// Take the next word if it is this one.
    bool take(std::string_view wanted)
    {
        in_.skip_white();
        const std::string_view rest = in_.rest();
        if (rest.size() < wanted.size() ||
            (rest.size() > wanted.size() &&
             std::isspace(static_cast<unsigned char>(rest[wanted.size()])) == 0))
            return false;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (std::tolower(static_cast<unsigned char>(rest[i])) != wanted[i])
                return false;
        in_.seek(in_.position() + wanted.size());
        return true;
    }

    void expect(std::string_view wanted)
    {
        if (!take(wanted))
            in_.fail_expected("'" + std::string(wanted) + "'");
    }

    void solid()
    {
        expect("solid");
        const std::string name = percent_decoded(in_.rest_of_line());
        in_.skip_line();
        const std::size_t first = triangles_.count();
        while (!take("endsolid"))
            facet();
        in_.skip_line();
        if (!name.empty())
            add_to_group(name, first);
    }

    void add_to_group(const std::string& name, std::size_t first)
    {
        const auto [entry, is_new] = group_numbers_.try_emplace(name, groups_.size());
        if (is_new)
            groups_.push_back({name, {}});
        for (std::size_t e = first; e < triangles_.count(); ++e)
            groups_[entry->second].elements.push_back(static_cast<Index>(e));
    }

    void facet()
    {
        expect("facet");
        in_.skip_line(); // the normal, which the corners imply
        expect("outer");
        expect("loop");
        std::array<PointWelder::Corner, 3> corners{};
        for (PointWelder::Corner& corner : corners) {
            expect("vertex");
            for (double& x : corner)
                x = in_.real("a coordinate");
        }
        expect("endloop");
        expect("endfacet");
        triangles_.add(corners);
    }

    TextScanner in_;
    Triangles triangles_;
    std::vector<ElementGroup> groups_;
    std::unordered_map<std::string, std::size_t> group_numbers_; ///< by name
};

template <class T>
T little_endian(std::string_view bytes, std::size_t at)
{
    std::array<char, sizeof(T)> raw{};
    std::copy_n(bytes.data() + at, raw.size(), raw.data());
    if (std::endian::native != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

MeshData read_binary(const InputBytes& file)
{
    file.set_version("binary");
    Triangles triangles((file.bytes.size() - kHeaderBytes) / kFacetBytes);
    std::size_t attributes = 0;
    for (std::size_t at = kHeaderBytes; at < file.bytes.size(); at += kFacetBytes) {
        std::array<PointWelder::Corner, 3> corners{};
        for (std::size_t i = 0; i < 9; ++i) {
            const std::size_t byte = at + 12 + 4 * i;
            const auto x = static_cast<double>(little_endian<float>(file.bytes, byte));
            if (!std::isfinite(x))
                throw InputError(file.path + ": byte " + std::to_string(byte) +
                                 ": a coordinate of triangle " + std::to_string(triangles.count()) +
                                 " is not finite");
            corners[i / 3][i % 3] = x;
        }
        triangles.add(corners);
        attributes += little_endian<std::uint16_t>(file.bytes, at + kFacetBytes - 2) != 0 ? 1 : 0;
    }
    if (attributes > 0)
        file.warn("the attribute bytes of " + std::to_string(attributes) +
                  " triangle(s), which have no common meaning, were left out");
    return triangles.mesh();
}

} // namespace

/// A binary file may start with "solid" too, so its size decides.
MeshData read_stl(const InputBytes& file)
{
    const std::string_view bytes = file.bytes;
    const std::uint64_t triangles = bytes.size() < kHeaderBytes ? 0 : little_endian<std::uint32_t>(bytes, 80);
    if (bytes.size() >= kHeaderBytes && bytes.size() == kHeaderBytes + kFacetBytes * triangles)
        return read_binary(file);
    const std::size_t text = bytes.find_first_not_of(" \t\r\n");
    if (text != std::string_view::npos && std::tolower(static_cast<unsigned char>(bytes[text])) == 's') {
        file.set_version("ASCII");
        return AsciiStlReader(file).read();
    }
    if (bytes.size() < kHeaderBytes)
        throw InputError(file.path +
                         ": this is neither text that starts with 'solid' nor long enough for a binary "
                         "STL file, which has at least 84 bytes");
    throw InputError(file.path + ": byte 80: a binary STL file of " + std::to_string(triangles) +
                     " triangles has " + std::to_string(kHeaderBytes + kFacetBytes * triangles) +
                     " bytes, but this has " + std::to_string(bytes.size()));
}

} // namespace morph
