// Gmsh's .msh files: the bytes that are written, and every meshes' way there and back.
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::written;

/// A hybrid mesh with elements of no group, of one and of two, and groups of names that need a comment.
MeshData grouped()
{
    MeshData mesh = test::rich_meshes()[2].second;
    mesh.groups = {{"inner \"core\"", {1, 2, 5}}, {"no group", {0}}, {"empty", {}}, {"outer", {2, 4, 5, 7}}};
    return mesh;
}

TEST(Gmsh, HoldsEveryMeshBitForBit)
{
    std::vector<std::pair<std::string, MeshData>> meshes = test::rich_meshes();
    meshes.emplace_back("groups", grouped());
    for (const auto& [name, mesh] : meshes)
        for (const char* format : {"gmsh", "gmsh22"})
            for (const bool binary : {false, true})
                EXPECT_EQ(difference(mesh, read_bytes(written(mesh, format, {.binary = binary}), format)), "")
                    << name << " as " << format << (binary ? " binary" : " text");
}

TEST(Gmsh, SurvivesMutatedFiles)
{
    for (const char* format : {"gmsh", "gmsh22"})
        test::survive_mutations(
            format,
            {written(grouped(), format, {.binary = false}), written(grouped(), format, {.binary = true})},
            2000);
}

/// A quad and a triangle, one of them in a group, with two lines and fields.
MeshData small()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"low", {{0, 1}, {1, 4}}}};
    mesh.groups = {{"right", {1}}};
    Matrix t(5, 1);
    t << 0.5, 1, 1.5, 2, -1e-7;
    Matrix q(2, 2);
    q << 1, 2, 3, 4;
    mesh.fields = {{"T", FieldLocation::vertex, t}, {"q", FieldLocation::element, q}};
    return mesh;
}

const std::string kNames =
    "$Comments\nlibmorph: what does not fit elsewhere\nfield 2 2 q\n$EndComments\n"
    "$PhysicalNames\n3\n1 1 \"low\"\n2 2 \"right\"\n2 3 \"no group\"\n$EndPhysicalNames\n";

// The lines have the values of an element that has their first vertex; two components are padded to three.
const std::string kData =
    "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n5\n1 0.5\n2 1\n3 1.5\n4 2\n5 -1e-07\n$EndNodeData\n"
    "$ElementData\n1\n\"q\"\n1\n0\n3\n0\n3\n4\n"
    "1 1 2 0\n2 3 4 0\n3 1 2 0\n4 3 4 0\n$EndElementData\n";

TEST(Gmsh, Text41IsWrittenByTheSpecification)
{
    EXPECT_EQ(written(small(), "gmsh", {.binary = false}),
              "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
                  "$Entities\n0 1 2 0\n"
                  "1 0 0 0 2 0.5 0 1 1 0\n"
                  "1 0 0 0 1 1 0 1 3 0\n"
                  "2 1 0 0 2 1 0 1 2 0\n$EndEntities\n"
                  "$Nodes\n1 5 1 5\n2 1 0 5\n1\n2\n3\n4\n5\n"
                  "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0.5 0\n$EndNodes\n"
                  "$Elements\n3 4 1 4\n"
                  "1 1 1 2\n1 1 2\n2 2 5\n"
                  "2 1 3 1\n3 1 2 3 4\n"
                  "2 2 2 1\n4 2 5 3\n$EndElements\n" +
                  kData);
}

TEST(Gmsh, Text22IsWrittenByTheSpecification)
{
    EXPECT_EQ(written(small(), "gmsh22", {.binary = false}),
              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + kNames +
                  "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0.5 0\n$EndNodes\n"
                  "$Elements\n4\n1 1 2 1 1 1 2\n2 1 2 1 1 2 5\n3 3 2 3 1 1 2 3 4\n4 2 2 2 2 2 5 3\n"
                  "$EndElements\n" +
                  kData);
}

/// Collects the bytes of a binary file, in either byte order.
class Bytes {
public:
    Bytes(bool swapped, bool narrow) : swapped_(swapped), narrow_(narrow) {}

    Bytes& text(const std::string& text)
    {
        bytes_ += text;
        return *this;
    }
    Bytes& ints(std::initializer_list<std::int32_t> values)
    {
        for (const std::int32_t value : values)
            put(value);
        return *this;
    }
    Bytes& sizes(std::initializer_list<std::uint64_t> values)
    {
        for (const std::uint64_t value : values)
            if (narrow_)
                put(static_cast<std::uint32_t>(value));
            else
                put(value);
        return *this;
    }
    Bytes& reals(std::initializer_list<double> values)
    {
        for (const double value : values)
            put(value);
        return *this;
    }
    const std::string& all() const { return bytes_; }

private:
    void put(auto value)
    {
        auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
        if (swapped_)
            std::reverse(raw.begin(), raw.end());
        bytes_.append(raw.data(), raw.size());
    }

    bool swapped_;
    bool narrow_; ///< size_t has 4 bytes
    std::string bytes_;
};

void put_data(Bytes& file)
{
    file.text("$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n5\n");
    const std::array<double, 5> t{0.5, 1, 1.5, 2, -1e-7};
    for (std::int32_t v = 0; v < 5; ++v)
        file.ints({v + 1}).reals({t.at(static_cast<std::size_t>(v))});
    file.text("\n$EndNodeData\n$ElementData\n1\n\"q\"\n1\n0\n3\n0\n3\n4\n");
    for (std::int32_t e = 0; e < 4; ++e) {
        const double first = e % 2 == 0 ? 1 : 3;
        file.ints({e + 1}).reals({first, first + 1, 0});
    }
    file.text("\n$EndElementData\n");
}

/// small() as binary file of version 4.1.
std::string binary_41(bool swapped, bool narrow)
{
    Bytes file(swapped, narrow);
    file.text(narrow ? "$MeshFormat\n4.1 1 4\n" : "$MeshFormat\n4.1 1 8\n");
    file.ints({1}).text("\n$EndMeshFormat\n" + kNames + "$Entities\n");
    file.sizes({0, 1, 2, 0});
    file.ints({1}).reals({0, 0, 0, 2, 0.5, 0}).sizes({1}).ints({1}).sizes({0});
    file.ints({1}).reals({0, 0, 0, 1, 1, 0}).sizes({1}).ints({3}).sizes({0});
    file.ints({2}).reals({1, 0, 0, 2, 1, 0}).sizes({1}).ints({2}).sizes({0});
    file.text("\n$EndEntities\n$Nodes\n").sizes({1, 5, 1, 5}).ints({2, 1, 0}).sizes({5, 1, 2, 3, 4, 5});
    file.reals({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0});
    file.text("\n$EndNodes\n$Elements\n").sizes({3, 4, 1, 4});
    file.ints({1, 1, 1}).sizes({2, 1, 1, 2, 2, 2, 5});
    file.ints({2, 1, 3}).sizes({1, 3, 1, 2, 3, 4});
    file.ints({2, 2, 2}).sizes({1, 4, 2, 5, 3});
    file.text("\n$EndElements\n");
    put_data(file);
    return file.all();
}

/// small() as binary file of version 2.2.
std::string binary_22(bool swapped)
{
    Bytes file(swapped, false);
    file.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n" + kNames + "$Nodes\n5\n");
    file.ints({1}).reals({0, 0, 0}).ints({2}).reals({1, 0, 0}).ints({3}).reals({1, 1, 0});
    file.ints({4}).reals({0, 1, 0}).ints({5}).reals({2, 0.5, 0});
    file.text("\n$EndNodes\n$Elements\n4\n");
    file.ints({1, 2, 2, 1, 1, 1, 1, 2, 2, 1, 1, 2, 5});
    file.ints({3, 1, 2, 3, 3, 1, 1, 2, 3, 4});
    file.ints({2, 1, 2, 4, 2, 2, 2, 5, 3});
    file.text("\n$EndElements\n");
    put_data(file);
    return file.all();
}

TEST(Gmsh, BinaryFilesAreWrittenByTheSpecification)
{
    EXPECT_EQ(written(small(), "gmsh"), binary_41(false, false));
    EXPECT_EQ(written(small(), "gmsh22"), binary_22(false));
}

TEST(Gmsh, BinaryFilesOfEveryByteOrderAndSizeAreRead)
{
    for (const bool swapped : {false, true}) {
        EXPECT_EQ(difference(read_bytes(binary_41(swapped, false), "gmsh"), small()), "") << swapped;
        EXPECT_EQ(difference(read_bytes(binary_41(swapped, true), "gmsh"), small()), "") << swapped;
        EXPECT_EQ(difference(read_bytes(binary_22(swapped), "gmsh"), small()), "") << swapped;
    }
}

TEST(Gmsh, AMeshWithoutMarkersAndGroupsHasNoPhysicalGroup)
{
    const std::string text = written(test::square_and_triangle(0), "gmsh", {.binary = false});
    EXPECT_EQ(text.find("$PhysicalNames"), std::string::npos);
    EXPECT_EQ(difference(read_bytes(text, "gmsh"), test::square_and_triangle(0)), "");
}

} // namespace

} // namespace morph
