#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"
#include "tests/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace morph;
using test::message_of;
using testing::HasSubstr;

double real_of(const std::string& text)
{
    return TextScanner("t", text).real("a number");
}

TEST(TextScanner, ReadsNumbersWholeAndStopsAtBlanksSeparatorsAndComments)
{
    const std::string text = "12\t-7, 1.5e-3;2%3\n 4";
    TextScanner in("t", text, '%');
    EXPECT_EQ(in.index("n"), 12);
    EXPECT_EQ(in.integer("n"), -7);
    EXPECT_EQ(in.rest().front(), ',');
    in.seek(in.position() + 1);
    EXPECT_EQ(in.real("x"), 1.5e-3);
    in.seek(in.position() + 1);
    EXPECT_EQ(in.index("n"), 2);
    EXPECT_TRUE(in.at_line_end());
    EXPECT_TRUE(in.skip_white());
    EXPECT_EQ(in.index("n"), 4);
    EXPECT_FALSE(in.skip_white());
}

TEST(TextScanner, RefusesWhatIsNotANumberWhole)
{
    for (const std::string text :
         {"12abc", "1e-3x", "x",   "",     "-",        "+",     "+-1",    "1.2.3", "1e",    "0x10", "1_000",
          "--1",   "e5",    "nan", "-inf", "infinity", "1e999", "-1e999", "1d5e3", "1\x80", "1..",  "."}) {
        double real = 42;
        TextScanner in("t", text);
        EXPECT_FALSE(in.try_real(real)) << text;
        EXPECT_EQ(real, 42) << text;
        EXPECT_EQ(in.position(), 0U) << text;
        std::int64_t integer = 42;
        EXPECT_FALSE(TextScanner("t", text).try_integer(integer)) << text;
        EXPECT_EQ(integer, 42) << text;
        Index index = 42;
        EXPECT_FALSE(TextScanner("t", text).try_index(index)) << text;
        EXPECT_EQ(index, 42) << text;
    }
}

TEST(TextScanner, RefusesIntegersOutOfRange)
{
    for (const std::string text :
         {"-1", "2147483648", "99999999999999999999999999", "18446744073709551617", "1.0"}) {
        Index index = 42;
        EXPECT_FALSE(TextScanner("t", text).try_index(index)) << text;
    }
    EXPECT_EQ(TextScanner("t", "+2147483647").index("n"), 2147483647);
    EXPECT_EQ(TextScanner("t", "-9223372036854775808").integer("n"),
              std::numeric_limits<std::int64_t>::min());
    std::int64_t integer = 42;
    EXPECT_FALSE(TextScanner("t", "9223372036854775808").try_integer(integer));
}

TEST(TextScanner, UnderstandsFortranExponentsALeadingPlusAndUnderflow)
{
    EXPECT_EQ(real_of("1.0D-3"), 1e-3);
    EXPECT_EQ(real_of("-2.5d+02"), -250);
    EXPECT_EQ(real_of("+.5"), 0.5);
    EXPECT_EQ(real_of("5."), 5);
    EXPECT_EQ(real_of("1e-999"), 0);
    EXPECT_EQ(real_of("+4.9e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_TRUE(std::signbit(real_of("-0.000")));
}

TEST(TextScanner, ReadsTheNearestDoubleOfSeventeenDigits)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        double value = 0;
        const std::uint64_t bits = random();
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value))
            continue;
        char text[64];
        std::snprintf(text, sizeof text, "%.17g", value);
        EXPECT_EQ(real_of(text), value) << text;
    }
}

TEST(TextScanner, NamesPathLineAndWhatWasExpected)
{
    const std::string text = "1 2\r\n% nothing\n\n 3 wing\n";
    TextScanner in("a.su2", text, '%');
    in.index("n");
    in.index("n");
    EXPECT_EQ(message_of([&] { in.index("a vertex"); }),
              "a.su2:1: expected a vertex, found the end of the line");
    EXPECT_EQ(message_of([&] { in.word("a name"); }), "a.su2:1: expected a name, found the end of the line");
    ASSERT_TRUE(in.skip_white());
    in.index("n");
    EXPECT_EQ(message_of([&] { in.real("x"); }), "a.su2:4: expected x, found 'wing'");
    EXPECT_EQ(message_of([&] { in.end_line("3"); }),
              "a.su2:4: expected the end of the line after 3, found 'wing'");
    EXPECT_EQ(in.word("a name"), "wing");
    EXPECT_FALSE(in.skip_white());
    EXPECT_EQ(message_of([&] { in.real("x"); }), "a.su2:5: expected x, found the end of the file");
}

TEST(TextScanner, QuotesBinaryAndHugeTokensOnOneShortLine)
{
    EXPECT_EQ(message_of([] { TextScanner("t", "\x01\xff{").index("n"); }), "t:1: expected n, found '??{'");
    const std::string huge(1000000, '9');
    const std::string message = message_of([&] { TextScanner("t", huge).index("n"); });
    EXPECT_THAT(message, HasSubstr("99...'"));
    EXPECT_LT(message.size(), 100U);
}

TEST(TextScanner, GivesTheRestOfALineWithoutCommentAndBlanks)
{
    TextScanner in("t", "  two words \t % comment\r\nnext", '%');
    EXPECT_EQ(in.rest_of_line(), "two words");
    EXPECT_TRUE(in.at_line_end());
    in.skip_line();
    EXPECT_EQ(in.word("a name"), "next");
    EXPECT_EQ(in.rest_of_line(), "");
}

TEST(TextScanner, ReadsPartOfATextWithTheLinesOfTheWhole)
{
    const std::string text = "<a>\n<b>\n1 2\n3</b>";
    TextScanner in("t.vtu", std::string_view(text).substr(0, text.find("</b>")));
    in.seek(text.find("<b>") + 3);
    int sum = 0;
    while (in.skip_white())
        sum += in.index("n");
    EXPECT_EQ(sum, 6);
    EXPECT_EQ(message_of([&] { in.fail("bad"); }), "t.vtu:4: bad");
}

} // namespace
