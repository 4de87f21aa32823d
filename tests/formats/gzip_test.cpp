#include "formats/binary/gzip.h"

#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include <zlib.h>

namespace {

using namespace morph;
using test::message_of;
using testing::HasSubstr;
using testing::StartsWith;

std::string gzip(const std::string& text)
{
    z_stream stream{};
    if (deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("deflateInit2");
    std::string packed(deflateBound(&stream, text.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(packed.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
}

TEST(Gzip, GivesBackWhatWasPackedWhateverItsLength)
{
    for (const std::size_t length : {0U, 1U, 65535U, 65536U, 65537U, 1000000U}) {
        std::string text(length, 'a');
        for (std::size_t i = 0; i < length; i += 7)
            text[i] = static_cast<char>(i * i % 251);
        EXPECT_EQ(gunzip(gzip(text), "file"), text) << length;
    }
}

TEST(Gzip, MembersFollowOneAnotherAndPaddingIsAllowed)
{
    EXPECT_EQ(gunzip(gzip("NDIME= 2\n") + gzip("NELEM= 0\n"), "file"), "NDIME= 2\nNELEM= 0\n");
    EXPECT_EQ(gunzip(gzip("text") + std::string(512, '\0'), "file"), "text");
}

TEST(Gzip, WhatIsCutShortOrDamagedIsRefusedWithThePath)
{
    const std::string packed = gzip(test::read_text(test::real_meshes().front()));
    EXPECT_EQ(message_of([&] { gunzip(packed.substr(0, packed.size() / 2), "a.su2.gz"); }),
              "a.su2.gz: cannot be decompressed: the gzip data are cut short");
    std::string damaged = packed;
    for (std::size_t i = 1000; i < 1100; ++i)
        damaged[i] = '\xFF';
    EXPECT_EQ(message_of([&] { gunzip(damaged, "a.su2.gz"); }),
              "a.su2.gz: cannot be decompressed: the gzip data are damaged");
}

TEST(Gzip, APackedMeshIsReadAsItIs)
{
    const test::TemporaryFolder folder;
    const std::string plain = test::real_meshes().front();
    const std::string packed = folder.write("wing.SU2.GZ", gzip(test::read_text(plain)));
    EXPECT_EQ(test::difference(read_mesh_data(packed), read_mesh_data(plain)), "");
}

TEST(Gzip, IsReadButNotWritten)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(message_of([&] { write_mesh_data(test::uneven_square(1), folder.file("a.su2.gz")); }),
              folder.file("a.su2.gz") + ": gzip files are read, but not written; leave out the .gz");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Gzip, TheEndingIsTakenOffInWhateverCase)
{
    EXPECT_EQ(without_gz("a/wing.su2.gz"), "a/wing.su2");
    EXPECT_EQ(without_gz("wing.su2.GZ"), "wing.su2");
    EXPECT_EQ(without_gz("wing.su2"), "wing.su2");
    EXPECT_EQ(without_gz(".gz"), ".gz");
}

TEST(Gzip, WhatCannotBeHeldInMemoryIsRefusedWithBothSizes)
{
    constexpr std::size_t kPetabyte = std::size_t{1} << 50U;
    EXPECT_THAT(message_of([] { require_memory("huge.vtu", kPetabyte); }),
                testing::AllOf(StartsWith("huge.vtu: holds 1073741824 MiB, but only "),
                               HasSubstr(" MiB of memory are free")));
    EXPECT_EQ(message_of([] { require_memory("small.vtu", 1000); }), "nothing was thrown");
}

} // namespace
