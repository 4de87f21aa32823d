#include "formats/csv/table.h"
#include "libmorph/core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace morph;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string message_of(const std::string& text)
{
    try {
        parse_csv_table(text, "t.csv");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(CsvTable, ReadsQuotedNamesCommentsBlankLinesAndCrLf)
{
    const CsvTable table =
        parse_csv_table("# made by hand\r\n\"x\", y ,z\r\n1,+2.5,-3e-2\r\n\r\n4,5,6", "t.csv");
    EXPECT_THAT(table.columns, ElementsAre("x", "y", "z"));
    ASSERT_EQ(table.rows.rows(), 2);
    EXPECT_EQ(table.rows(0, 1), 2.5);
    EXPECT_EQ(table.rows(0, 2), -3e-2);
    EXPECT_EQ(table.rows(1, 2), 6);
    EXPECT_THAT(table.lines, ElementsAre(3, 5));
}

TEST(CsvTable, PicksColumnsByName)
{
    const CsvTable table = parse_csv_table("a,b,c\n1,2,3\n4,5,6\n", "t.csv");
    const Matrix picked = csv_columns(table, {"c", "a"});
    EXPECT_EQ(picked(1, 0), 6);
    EXPECT_EQ(picked(1, 1), 4);
    EXPECT_THROW(csv_columns(table, {"d"}), InputError);
    EXPECT_EQ(csv_columns(parse_csv_table("a,b\n", "t.csv"), {"b", "a"}).rows(), 0);
}

TEST(CsvTable, NamesTheLineOfWhatIsWrong)
{
    EXPECT_THAT(message_of(""), HasSubstr("t.csv: is empty"));
    EXPECT_THAT(message_of("# only a comment\n"), HasSubstr("is empty"));
    EXPECT_THAT(message_of("x,y\n1,2\n3\n"), HasSubstr("t.csv:3: has 1 values"));
    EXPECT_THAT(message_of("x,y\n1,2,3\n"), HasSubstr("t.csv:2: has 3 values"));
    EXPECT_THAT(message_of("x,y\n1,two\n"), HasSubstr("column 'y' is 'two'"));
    EXPECT_THAT(message_of("x,y\n1,\n"), HasSubstr("column 'y' is ''"));
    EXPECT_THAT(message_of("x,y\n1,nan\n"), HasSubstr("finite number"));
    EXPECT_THAT(message_of("x,y\n1,1e999\n"), HasSubstr("finite number"));
    EXPECT_THAT(message_of("x,y\n1,1e-3x\n"), HasSubstr("1e-3x"));
}

TEST(CsvTable, AnswersEveryMutationWithATableOrAnInputError)
{
    const std::string good = "x,y\n1.5,2\n3,4e1\n# end\n";
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string text = good;
        for (int k = 0; k < 3; ++k)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        text.resize(random() % (text.size() + 1));
        try {
            const CsvTable table = parse_csv_table(text, "t.csv");
            EXPECT_TRUE(table.rows.allFinite());
            EXPECT_EQ(table.rows.cols(), static_cast<Eigen::Index>(table.columns.size()));
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("t.csv"));
        }
    }
}

} // namespace
