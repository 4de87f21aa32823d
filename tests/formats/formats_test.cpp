#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <thread>

#include <sys/stat.h>

namespace {

using namespace morph;
using test::difference;
using test::message_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Formats, EveryFormatIsFoundByItsNameAndEachOfItsExtensions)
{
    std::set<std::string_view> names;
    std::set<std::string_view> extensions;
    for (const Format* format : all_formats()) {
        EXPECT_EQ(&find_format("anything.xyz", std::string(format->name)), format);
        EXPECT_TRUE(names.insert(format->name).second) << format->name;
        EXPECT_FALSE(format->description.empty()) << format->name;
        for (const std::string_view extension : format->extensions) {
            EXPECT_EQ(&find_format("a.b/mesh" + std::string(extension), ""), format);
            EXPECT_TRUE(extensions.insert(extension).second) << extension;
        }
    }
    EXPECT_THAT(names, testing::Contains("su2"));
}

TEST(Formats, CaseOfNameAndExtensionDoesNotMatter)
{
    EXPECT_EQ(find_format("WING.SU2", "").name, "su2");
    EXPECT_EQ(find_format("wing", "SU2").name, "su2");
}

TEST(Formats, AnOldNameIsStillUnderstood)
{
    EXPECT_EQ(find_format("nodes.txt", "tuc").name, "thesis");
    EXPECT_EQ(find_format("nodes.txt", "TUC").name, "thesis");
}

TEST(Formats, AnUnknownExtensionIsRefusedWithTheKnownOnes)
{
    for (const std::string path : {"wing.step", "wing", "wing.", ".su2", "folder.su2/wing"})
        EXPECT_THAT(
            message_of([&] { find_format(path, ""); }),
            testing::AllOf(StartsWith(path + ": the extension '"), HasSubstr(".su2"), HasSubstr("--from")));
}

TEST(Formats, AnUnknownNameIsRefusedWithTheNearestOne)
{
    const std::string message = message_of([] { find_format("wing.su2", "sv2"); });
    EXPECT_THAT(message, StartsWith("format 'sv2' is not known; known are "));
    EXPECT_THAT(message, testing::EndsWith("; did you mean 'su2'?"));
}

TEST(Formats, ANameOverridesTheExtension)
{
    const TemporaryFolder folder;
    const MeshData mesh = test::uneven_square(2);
    write_mesh_data(mesh, folder.file("mesh.dat"), "su2");
    EXPECT_EQ(difference(read_mesh_data(folder.file("mesh.dat"), "su2"), mesh), "");
    EXPECT_THROW(read_mesh_data(folder.file("mesh.dat")), InputError);
}

TEST(Formats, AFileThatCannotBeReadIsNamedWithTheReason)
{
    const TemporaryFolder folder;
    const std::string missing = folder.file("missing.su2");
    EXPECT_EQ(message_of([&] { read_mesh_data(missing); }),
              missing + ": cannot be read: No such file or directory");
    std::filesystem::create_directory(folder.file("folder.su2"));
    EXPECT_EQ(message_of([&] { read_mesh_data(folder.file("folder.su2")); }),
              folder.file("folder.su2") + ": cannot be read: Is a directory");
}

TEST(Formats, AFileThatCannotBeWrittenIsNamedWithTheReason)
{
    const TemporaryFolder folder;
    const MeshData mesh = test::uneven_square(2);
    const std::string nowhere = folder.file("no_such_folder/mesh.su2");
    EXPECT_EQ(message_of([&] { write_mesh_data(mesh, nowhere); }),
              nowhere + ": cannot be written: No such file or directory");
    EXPECT_EQ(message_of([&] { write_mesh_data(mesh, "/dev/full", "su2"); }),
              "/dev/full: cannot be written: No space left on device");
}

TEST(Formats, AFailedWriteLeavesTheOldFileAndNothingElse)
{
    const TemporaryFolder folder;
    const std::string path = folder.write("mesh.su2", "precious");
    MeshData mesh = test::uneven_square(2);
    mesh.markers.back().name = "two\nlines";
    EXPECT_THROW(write_mesh_data(mesh, path), InputError);
    EXPECT_EQ(test::read_text(path), "precious");
    EXPECT_THAT(folder.names(), ElementsAre("mesh.su2"));
}

TEST(Formats, AMeshComesThroughAPipe)
{
    const TemporaryFolder folder;
    const MeshData mesh = test::uneven_square(100); // more than a pipe buffers
    write_mesh_data(mesh, folder.file("mesh.su2"));
    const std::string text = test::read_text(folder.file("mesh.su2"));
    ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
    std::thread writer([&] { static_cast<void>(folder.write("pipe", text)); });
    const MeshData read = read_mesh_data(folder.file("pipe"), "su2");
    writer.join();
    EXPECT_EQ(difference(read, mesh), "");
}

TEST(Formats, TheMeshBuiltFromAFileGoesBackToTheSameFile)
{
    const TemporaryFolder folder;
    for (const std::string& path : test::real_meshes()) {
        const MeshData data = read_mesh_data(path);
        write_mesh(read_mesh(path), folder.file("mesh.su2"));
        write_mesh_data(data, folder.file("data.su2"));
        EXPECT_TRUE(test::read_text(folder.file("mesh.su2")) == test::read_text(folder.file("data.su2")))
            << path;
    }
}

TEST(Formats, WhatTheBuilderRefusesIsNamedWithTheFile)
{
    const TemporaryFolder folder;
    MeshData mesh = test::uneven_square(1);
    mesh.elements.push_back(mesh.elements[0]);
    write_mesh_data(mesh, folder.file("twice.su2"));
    EXPECT_THAT(message_of([&] { read_mesh(folder.file("twice.su2")); }),
                StartsWith(folder.file("twice.su2") + ": "));
}

} // namespace
