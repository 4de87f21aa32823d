// STL: triangles, each with its own three corners, as text or in single precision. Equal corners are
// joined on reading, numbered in the order of their first appearance.
#include "formats/format.h"
#include "formats/number_text.h"
#include "formats/surface.h"
#include "formats/vtk_numbers.h"
#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace morph {

namespace {

constexpr std::size_t kHeaderBytes = 84; ///< a title of 80 bytes and the number of triangles
constexpr std::size_t kFacetBytes = 50;  ///< normal, three corners, two bytes of anything

using Corner = std::array<double, 3>;

struct CornerHash {
    std::size_t operator()(const Corner& corner) const
    {
        std::uint64_t hash = 0;
        for (const double x : corner) // 0 and -0 are equal and have to hash alike
            hash = (hash ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 0x9e3779b97f4a7c15U,
            hash ^= hash >> 29;
        return hash;
    }
};

/// Collects triangles and joins their equal corners.
class CornerJoiner {
public:
    Index vertex(const Corner& corner)
    {
        const auto [entry, is_new] = vertices_.try_emplace(corner, static_cast<Index>(xyz_.size() / 3));
        if (is_new)
            xyz_.insert(xyz_.end(), corner.begin(), corner.end());
        return entry->second;
    }

    void add(const std::array<Corner, 3>& corners)
    {
        mesh_.elements.push_back({vertex(corners[0]), vertex(corners[1]), vertex(corners[2]), -1});
    }

    MeshData mesh()
    {
        set_points(mesh_, xyz_);
        return std::move(mesh_);
    }

private:
    MeshData mesh_;
    std::vector<double> xyz_;
    std::unordered_map<Corner, Index, CornerHash> vertices_;
};

/// "facet normal … outer loop vertex … vertex … vertex … endloop endfacet", in any case of letters.
class AsciiStlReader {
public:
    explicit AsciiStlReader(const InputBytes& file) : in_(file.path, file.bytes) {}

    MeshData read()
    {
        while (in_.skip_white())
            solid();
        return joiner_.mesh();
    }

private:
    static std::string lower_case(std::string_view word)
    {
        std::string text(word);
        for (char& c : text)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
    }

    /// Take the next word if it is this one.
    bool take(std::string_view wanted)
    {
        in_.skip_white();
        const std::size_t position = in_.position();
        if (position < in_.text().size() && lower_case(in_.word(wanted)) == wanted)
            return true;
        in_.seek(position);
        return false;
    }

    void expect(std::string_view wanted)
    {
        if (!take(wanted))
            in_.fail_expected("'" + std::string(wanted) + "'");
    }

    void solid()
    {
        expect("solid");
        in_.skip_line(); // its name
        while (!take("endsolid"))
            facet();
        in_.skip_line();
    }

    void facet()
    {
        expect("facet");
        in_.skip_line(); // the normal, which the corners imply
        expect("outer");
        expect("loop");
        std::array<Corner, 3> corners{};
        for (Corner& corner : corners) {
            expect("vertex");
            for (double& x : corner)
                x = in_.real("a coordinate");
        }
        expect("endloop");
        expect("endfacet");
        joiner_.add(corners);
    }

    TextScanner in_;
    CornerJoiner joiner_;
};

template <class T>
T little_endian(std::string_view bytes, std::size_t at)
{
    std::array<char, sizeof(T)> raw{};
    bytes.copy(raw.data(), raw.size(), at);
    if (std::endian::native != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

MeshData read_binary(const InputBytes& file)
{
    CornerJoiner joiner;
    for (std::size_t at = kHeaderBytes; at < file.bytes.size(); at += kFacetBytes) {
        std::array<Corner, 3> corners{};
        for (std::size_t i = 0; i < 9; ++i) {
            const std::size_t byte = at + 12 + 4 * i;
            const auto x = static_cast<double>(little_endian<float>(file.bytes, byte));
            if (!std::isfinite(x))
                throw InputError(file.path + ": byte " + std::to_string(byte) +
                                 ": a coordinate of triangle " +
                                 std::to_string((at - kHeaderBytes) / kFacetBytes) + " is not finite");
            corners[i / 3][i % 3] = x;
        }
        joiner.add(corners);
    }
    return joiner.mesh();
}

/// A binary file may start with "solid" too, so its size decides.
MeshData read_stl(const InputBytes& file)
{
    const std::string_view bytes = file.bytes;
    const std::uint64_t triangles = bytes.size() < kHeaderBytes ? 0 : little_endian<std::uint32_t>(bytes, 80);
    if (bytes.size() >= kHeaderBytes && bytes.size() == kHeaderBytes + kFacetBytes * triangles)
        return read_binary(file);
    const std::size_t text = bytes.find_first_not_of(" \t\r\n");
    if (text != std::string_view::npos && std::tolower(static_cast<unsigned char>(bytes[text])) == 's')
        return AsciiStlReader(file).read();
    if (bytes.size() < kHeaderBytes)
        throw InputError(file.path +
                         ": this is neither text that starts with 'solid' nor long enough for a binary "
                         "STL file, which has at least 84 bytes");
    throw InputError(file.path + ": byte 80: a binary STL file of " + std::to_string(triangles) +
                     " triangles has " + std::to_string(kHeaderBytes + kFacetBytes * triangles) +
                     " bytes, but this has " + std::to_string(bytes.size()));
}

/// Triangles as they are, quads cut along the shorter diagonal.
std::vector<std::array<Index, 3>> triangles_of(const MeshData& mesh)
{
    std::vector<std::array<Index, 3>> triangles;
    triangles.reserve(mesh.elements.size());
    for (const auto& [a, b, c, d] : mesh.elements) {
        if (d < 0) {
            triangles.push_back({a, b, c});
            continue;
        }
        const auto length = [&](Index u, Index v) {
            return (mesh.points.row(u) - mesh.points.row(v)).norm();
        };
        const bool from_first = length(a, c) <= length(b, d);
        triangles.push_back(from_first ? std::array{a, b, c} : std::array{a, b, d});
        triangles.push_back(from_first ? std::array{a, c, d} : std::array{b, c, d});
    }
    return triangles;
}

Eigen::RowVector3d normal_of(const MeshData& mesh, const std::array<Index, 3>& triangle)
{
    const Eigen::RowVector3d u = mesh.points.row(triangle[1]) - mesh.points.row(triangle[0]);
    const Eigen::RowVector3d v = mesh.points.row(triangle[2]) - mesh.points.row(triangle[0]);
    const Eigen::RowVector3d normal = u.normalized().cross(v.normalized()).normalized();
    return normal.allFinite() ? normal : Eigen::RowVector3d::Zero();
}

void write_ascii(const MeshData& mesh, OutputFile& out)
{
    out.append("solid mesh\n");
    for (const auto& triangle : triangles_of(mesh)) {
        out.append("facet normal ");
        append_point(out, normal_of(mesh, triangle), 0);
        out.append("outer loop\n");
        for (const Index v : triangle) {
            out.append("vertex ");
            append_point(out, mesh.points, v);
        }
        out.append("endloop\nendfacet\n");
    }
    out.append("endsolid mesh\n");
}

void append_little_endian(std::string& bytes, auto value)
{
    auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
    if (std::endian::native != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

void write_binary(const MeshData& mesh, OutputFile& out)
{
    const auto triangles = triangles_of(mesh);
    std::string bytes(80, ' ');
    append_little_endian(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const auto& triangle : triangles) {
        const Eigen::RowVector3d normal = normal_of(mesh, triangle);
        for (int k = 0; k < 3; ++k)
            append_little_endian(bytes, static_cast<float>(normal(k)));
        for (const Index v : triangle)
            for (int k = 0; k < 3; ++k)
                append_little_endian(bytes, static_cast<float>(mesh.points(v, k)));
        bytes.append(2, '\0');
        out.append(bytes);
        bytes.clear();
    }
    out.append(bytes);
}

void require_single_precision_range(const MeshData& mesh, const OutputFile& out)
{
    constexpr double largest = std::numeric_limits<float>::max();
    if (mesh.points.size() > 0 && mesh.points.cwiseAbs().maxCoeff() > largest)
        throw InputError(out.path() + ": a coordinate is larger than binary STL can hold; write it as text");
}

void write_stl(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    if (!options.binary)
        return write_ascii(mesh, out);
    require_single_precision_range(mesh, out);
    write_binary(mesh, out);
}

/// Reading numbers the vertices in the order in which the triangles first name them.
bool is_order_kept(const MeshData& mesh)
{
    Index seen = 0;
    for (const auto& triangle : triangles_of(mesh))
        for (const Index v : triangle) {
            if (v > seen)
                return false;
            seen = std::max(seen, v + 1);
        }
    return seen == mesh.points.rows();
}

std::vector<std::string> stl_losses(const MeshData& mesh, const WriteOptions& options)
{
    std::vector<std::string> lost;
    const auto quads = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                     [](const Element& element) { return corner_count(element) == 4; });
    if (quads > 0)
        lost.push_back("quads: " + std::to_string(quads) + " are cut into triangles");
    if (!is_order_kept(mesh))
        lost.emplace_back(
            "the numbers of vertices: they are numbered anew when read, without those of no element");
    if (options.binary && mesh.points != mesh.points.cast<float>().cast<double>())
        lost.emplace_back("double precision in its binary form: coordinates are rounded; write it as text");
    return lost;
}

} // namespace

extern const Format stl_format;
const Format stl_format{"stl", {".stl"}, "STL triangles", {.surface = true}, read_stl, write_stl, stl_losses};

} // namespace morph
