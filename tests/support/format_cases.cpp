#include "tests/support/format_cases.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace morph::test {

namespace {

/// Values of every size and sign, those that text loses most easily first.
Matrix extreme_values(Index rows, Index columns)
{
    constexpr std::array<double, 8> special{0.1,  -1.0 / 3.0, 1e-308 / 7,          1.7976931348623157e308,
                                            -0.0, 5e-324,     123456789.123456789, 1e22};
    Matrix values(rows, columns);
    for (Index i = 0; i < values.size(); ++i)
        values.data()[i] = static_cast<std::size_t>(i) < special.size()
                               ? special[static_cast<std::size_t>(i)]
                               : std::sin(0.1 + i) * std::pow(10.0, i % 30 - 15);
    return values;
}

void add_fields(MeshData& mesh)
{
    const auto vertices = static_cast<Index>(mesh.points.rows());
    const auto elements = static_cast<Index>(mesh.elements.size());
    for (Index columns = 1; columns <= 9; ++columns)
        mesh.fields.push_back(
            {"v" + std::to_string(columns), FieldLocation::vertex, extreme_values(vertices, columns)});
    mesh.fields.push_back({"h_body_1 <&\"'> 100 %", FieldLocation::vertex, extreme_values(vertices, 1)});
    mesh.fields.push_back({"marker", FieldLocation::element, extreme_values(elements, 1)});
    mesh.fields.push_back({"stress", FieldLocation::element, extreme_values(elements, 6)});
}

MeshData with_fields(MeshData mesh)
{
    add_fields(mesh);
    return mesh;
}

MeshData hybrid()
{
    MeshData mesh = quad_square(3);
    const Element cut = mesh.elements[4];
    mesh.elements[4] = {cut[0], cut[1], cut[2], -1};
    mesh.elements.push_back({cut[0], cut[2], cut[3], -1});
    return mesh;
}

MeshData surface()
{
    MeshData mesh = hybrid();
    mesh.dimension = 3;
    for (Index v = 0; v < mesh.points.rows(); ++v)
        mesh.points(v, 2) = std::sqrt(2.0) * mesh.points(v, 0) - mesh.points(v, 1) / 3;
    return mesh;
}

MeshData odd_markers()
{
    MeshData mesh = hybrid();
    std::string every_byte;
    for (int code = 0; code < 256; ++code)
        every_byte += static_cast<char>(code);
    mesh.markers[0].name = "wing upper, <\"slat\"> & 50% %00 %25 %2525";
    mesh.markers[1].name = every_byte;
    mesh.markers[2].name = "";
    mesh.markers[3].name = "Flügel\n\ttab";
    mesh.markers.push_back({"no edges", {}});
    mesh.markers.push_back({"inside", {{5, 6}, {6, 10}}});
    mesh.markers.push_back(mesh.markers[0]);
    return mesh;
}

MeshData loose_vertices()
{
    MeshData mesh = uneven_square(2);
    mesh.points.conservativeResize(mesh.points.rows() + 2, Eigen::NoChange);
    mesh.points.bottomRows(2) << 7.25, -1e-300, 0, 1e300, 0.1, 0;
    return mesh;
}

/// A sound mesh: what every later stage relies on without looking.
void expect_sound(const MeshData& mesh)
{
    const auto in_range = [&](Index v) { return v >= 0 && v < mesh.points.rows(); };
    for (const Element& element : mesh.elements)
        for (int i = 0; i < corner_count(element); ++i)
            EXPECT_TRUE(in_range(element[static_cast<std::size_t>(i)]));
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            EXPECT_TRUE(in_range(edge[0]) && in_range(edge[1]));
    for (const Field& field : mesh.fields)
        EXPECT_EQ(field.values.rows(), field.location == FieldLocation::vertex
                                           ? mesh.points.rows()
                                           : static_cast<Eigen::Index>(mesh.elements.size()));
    EXPECT_TRUE(mesh.points.allFinite());
}

std::string mutated(std::string bytes, std::mt19937& random)
{
    const auto at_most = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (std::size_t change = 0; change <= at_most(4); ++change) {
        const std::size_t at = at_most(bytes.size());
        const std::size_t length = 1 + at_most(16);
        switch (random() % 5) {
        case 0:
            if (!bytes.empty())
                bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes.resize(at);
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at_most(bytes.size()), length));
            break;
        default: // most harm is done in numbers
            if (const std::size_t digit = bytes.find_first_of("0123456789", at); digit != std::string::npos)
                bytes.replace(digit, 1, random() % 2 ? "99999999999" : "-1");
        }
    }
    return bytes;
}

} // namespace

std::vector<std::pair<std::string, MeshData>> rich_meshes()
{
    return {{"triangles", with_fields(uneven_square(3))},
            {"quads", with_fields(quad_square(3))},
            {"hybrid", with_fields(hybrid())},
            {"surface", with_fields(surface())},
            {"odd markers", with_fields(odd_markers())},
            {"loose vertices", with_fields(loose_vertices())},
            {"annulus without fields", annulus(1, 3, 12, 2)},
            {"nothing", {}}};
}

std::vector<std::pair<std::string, MeshData>> planar_meshes()
{
    auto meshes = rich_meshes();
    std::erase_if(meshes, [](const auto& named) {
        return named.second.dimension == 3 || named.second.elements.empty();
    });
    return meshes;
}

MeshData square_and_triangle(std::size_t first)
{
    MeshData mesh;
    mesh.points.resize(5, 3);
    mesh.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0;
    Element quad{0, 1, 2, 3};
    std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(first), quad.end());
    mesh.elements = {quad, {1, 4, 2, -1}};
    return mesh;
}

std::string written(const MeshData& mesh, const std::string& format, const WriteOptions& options)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("written");
    write_mesh_data(mesh, path, format, options);
    return read_text(path);
}

MeshData read_bytes(const std::string& bytes, const std::string& format)
{
    return find_format("file", format).read({"file", bytes});
}

std::string refusal(const std::string& bytes, const std::string& format)
{
    try {
        read_bytes(bytes, format);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
        throw std::logic_error("the text to be replaced is not there: " + from);
    return text.replace(at, from.size(), to);
}

void survive_mutations(const std::string& format, const std::vector<std::string>& seeds, int count)
{
    survive_mutations(find_format("file", format).read, seeds, count);
}

void survive_mutations(const std::function<MeshData(const InputBytes&)>& read,
                       const std::vector<std::string>& seeds, int count)
{
    std::mt19937 random(2024);
    for (int i = 0; i < count; ++i) {
        const std::string bytes = mutated(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
        try {
            expect_sound(read({"file", bytes}));
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.rfind("file:", 0), 0U) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
}

} // namespace morph::test
