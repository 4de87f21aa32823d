#include "formats/output_file.h"
#include "formats/text/number_text.h"
#include "libmorph/core/error.h"
#include "tests/support/errors.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>

namespace {

using namespace morph;
using test::message_of;
using test::read_text;
using test::TemporaryFolder;
using testing::ElementsAre;

TEST(OutputFile, AppearsWhenCommittedAndNotBefore)
{
    const TemporaryFolder folder;
    OutputFile out(folder.file("mesh"));
    out.append("one ");
    out.append("two");
    EXPECT_FALSE(std::filesystem::exists(folder.file("mesh")));
    out.commit();
    EXPECT_EQ(read_text(folder.file("mesh")), "one two");
    EXPECT_THAT(folder.names(), ElementsAre("mesh"));
}

TEST(OutputFile, LeavesNothingBehindAndTheOldFileUntouchedWhenItIsNotCommitted)
{
    const TemporaryFolder folder;
    folder.write("old", "precious");
    for (const char* name : {"old", "new"}) {
        OutputFile out(folder.file(name));
        out.append(std::string(3 << 20, 'x')); // more than the buffer holds
    }
    EXPECT_THAT(folder.names(), ElementsAre("old"));
    EXPECT_EQ(read_text(folder.file("old")), "precious");
}

TEST(OutputFile, KeepsThePermissionsOfTheFileItReplaces)
{
    using std::filesystem::perms;
    const TemporaryFolder folder;
    const std::string path = folder.write("mesh", "old");
    std::filesystem::permissions(path, perms::owner_read | perms::owner_write | perms::group_read);
    OutputFile out(path);
    out.append("new");
    out.commit();
    EXPECT_EQ(read_text(path), "new");
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              perms::owner_read | perms::owner_write | perms::group_read);
}

TEST(OutputFile, ReplacesTheFileBehindALinkAndKeepsTheLink)
{
    const TemporaryFolder folder;
    folder.write("target", "old");
    std::filesystem::create_symlink("target", folder.file("link"));
    OutputFile out(folder.file("link"));
    out.append("new");
    out.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(read_text(folder.file("target")), "new");
}

TEST(OutputFile, KeepsTheOrderOfPiecesOfAnySize)
{
    const TemporaryFolder folder;
    std::mt19937 random(1);
    std::string expected;
    OutputFile out(folder.file("mesh"));
    for (int i = 0; i < 300; ++i) {
        const std::size_t most = i % 50 == 0 ? 3000000 : 20000;
        const std::string piece(random() % most, static_cast<char>('a' + i % 26));
        expected += piece;
        if (i % 2 == 0) {
            out.append(piece);
        } else {
            char* const to = out.room(piece.size() + 100);
            out.advance_to(std::copy(piece.begin(), piece.end(), to));
        }
    }
    out.commit();
    EXPECT_TRUE(read_text(folder.file("mesh")) == expected); // tens of MB: not to be printed
}

TEST(OutputFile, SaysWhyItCannotBeWritten)
{
    const TemporaryFolder folder;
    EXPECT_EQ(message_of([&] { OutputFile out(folder.path()); }),
              folder.path() + ": cannot be written: Is a directory");
    const std::string nowhere = folder.file("no_such_folder/mesh");
    EXPECT_EQ(message_of([&] { OutputFile out(nowhere); }),
              nowhere + ": cannot be written: No such file or directory");
    // /proc takes no files of root either
    EXPECT_THAT(message_of([] { OutputFile out("/proc/mesh.su2"); }),
                testing::StartsWith("/proc/mesh.su2: cannot be written: "));
    const std::string file = folder.write("file", "");
    EXPECT_EQ(message_of([&] { OutputFile out(file + "/mesh"); }),
              file + "/mesh: cannot be written: Not a directory");
}

TEST(OutputFile, SaysThatTheDiskIsFull)
{
    const std::string full = "/dev/full: cannot be written: No space left on device";
    EXPECT_EQ(message_of([] {
                  OutputFile out("/dev/full");
                  out.append("x");
                  out.commit();
              }),
              full);
    EXPECT_EQ(message_of([] {
                  OutputFile out("/dev/full");
                  out.append(std::string(5 << 20, 'x'));
              }),
              full);
    EXPECT_EQ(message_of([] {
                  OutputFile out("/dev/full");
                  out.advance_to(out.room(1 << 20) + (1 << 20));
                  out.room(1);
              }),
              full);
}

TEST(NumberText, GivesTheShortestTextThatReadsBackAsTheSameBits)
{
    char text[kLongestNumber];
    const auto text_of = [&](auto value) { return std::string(text, number_text(text, value)); };
    EXPECT_EQ(text_of(0.1), "0.1");
    EXPECT_EQ(text_of(-0.0), "-0");
    EXPECT_EQ(text_of(1.0 / 3.0), "0.3333333333333333");
    EXPECT_EQ(text_of(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
    EXPECT_EQ(text_of(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value))
            continue;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text_of(value).c_str(), nullptr)),
                  std::bit_cast<std::uint64_t>(value));
    }
}

TEST(NumberText, HasRoomForTheLongestNumberAndItsSeparator)
{
    char text[kLongestNumber];
    EXPECT_LE(number_text(text, -2.2250738585072014e-308, '\n') - text,
              static_cast<std::ptrdiff_t>(kLongestNumber));
    EXPECT_EQ(std::string(text, number_text(text, 17, '\t')), "17\t");
}

} // namespace
