#include "formats/binary/mesh_bytes.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::rich_meshes;

TEST(MeshBytes, CarryEverything)
{
    for (const auto& [name, mesh] : rich_meshes()) {
        VolumeFile volume{mesh, {{VolumeShape::prism, {0, 1, 2, 3, 4, 5}}}};
        if (!mesh.elements.empty())
            volume.mesh.groups = {{"first", {0}}, {"", {}}};
        MemoryFile file;
        append_mesh(file, volume, {"1.0", {"a warning"}});
        ReadNotes notes{"", {"an earlier one"}};
        const VolumeFile back = mesh_from_bytes(file.bytes(), "file", notes);
        EXPECT_EQ(test::difference(volume.mesh, back.mesh), "") << name;
        ASSERT_EQ(back.cells.size(), 1U);
        EXPECT_EQ(back.cells[0].shape, VolumeShape::prism);
        EXPECT_EQ(back.cells[0].corners, volume.cells[0].corners);
        EXPECT_EQ(notes.version, "1.0");
        EXPECT_EQ(notes.warnings, (std::vector<std::string>{"an earlier one", "a warning"}));
    }
}

std::string small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"wall", {{0, 1}}}};
    mesh.groups = {{"right", {1}}};
    mesh.fields = {{"v", FieldLocation::vertex, Matrix::Constant(5, 2, 7)}};
    MemoryFile file;
    append_mesh(file, {mesh, {{VolumeShape::prism, {0, 1, 2, 3, 4, 5}}}}, {"1.0", {"a warning"}});
    return std::string(file.bytes());
}

TEST(MeshBytes, AreRefusedWhenCutShort)
{
    const std::string whole = small_mesh();
    ReadNotes notes;
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THROW(mesh_from_bytes(whole.substr(0, size), "file", notes), InputError) << size;
}

TEST(MeshBytes, MakeASoundMeshOrNone)
{
    const auto read = [](const InputBytes& input) {
        ReadNotes notes;
        return mesh_from_bytes(input.bytes, input.path, notes).mesh;
    };
    test::survive_mutations(
        [&](const InputBytes& input) {
            MeshData mesh = read(input);
            mesh.points.setZero(); // which may be any bits
            return mesh;
        },
        {small_mesh()}, 5000);
}

} // namespace
