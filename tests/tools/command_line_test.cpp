#include "tools/common/command_line.h"
#include "tools/common/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace {

using namespace morph::tools;
using testing::ElementsAre;
using testing::HasSubstr;

bool parse(CommandLine& line, std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "tool");
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    return line.parse(static_cast<int>(argv.size()), argv.data());
}

/// The message with which a line that @p describe made refuses the arguments; "accepted" if it does not.
std::string refusal(const std::function<void(CommandLine&)>& describe,
                    const std::vector<std::string>& arguments)
{
    CommandLine line("tool", "A tool", "  tool in");
    describe(line);
    try {
        parse(line, arguments);
        return "accepted";
    } catch (const UsageError& error) {
        return error.what();
    }
}

TEST(CommandLine, WritesEachValueIntoItsVariable)
{
    CommandLine line("tool", "A tool", "  tool in");
    std::string input;
    int count = 1;
    double size = 2;
    std::vector<double> moves;
    bool fresh = false;
    bool edges = true;
    line.add("input", input, "A file");
    line.add("--count", count, "A whole number");
    line.add("-s,--size", size, "A number");
    line.add("--moves", moves, "Numbers").comma_separated();
    line.add_flag("--fresh", fresh, "A flag");
    line.add_flag("--edges,!--no-edges", edges, "A flag that can be switched off");

    EXPECT_TRUE(
        parse(line, {"a.su2", "--count", "3", "-s", "0.5", "--moves", "1,2", "--fresh", "--no-edges"}));

    EXPECT_EQ(input, "a.su2");
    EXPECT_EQ(count, 3);
    EXPECT_EQ(size, 0.5);
    EXPECT_THAT(moves, ElementsAre(1, 2));
    EXPECT_TRUE(fresh);
    EXPECT_FALSE(edges);
}

TEST(CommandLine, KeepsTheValueOfAnOptionThatIsNotGiven)
{
    CommandLine line("tool", "A tool", "  tool in");
    std::string name = "own";
    int count = 7;
    line.add("--name", name, "A text");
    line.add("--count", count, "A whole number");

    EXPECT_TRUE(parse(line, {"--count", "7"}));

    EXPECT_EQ(name, "own");
    EXPECT_EQ(count, 7);
    EXPECT_FALSE(line.given("--name"));
    EXPECT_TRUE(line.given("--count"));
}

TEST(CommandLine, TakesTheOptionsOfEveryTool)
{
    CommandLine line("tool", "A tool", "  tool in");
    EXPECT_TRUE(parse(line, {"--json", "-", "--threads", "0"}));
    EXPECT_EQ(line.common().json, "-");
    EXPECT_EQ(line.common().threads, 0);
    EXPECT_FALSE(line.common().quiet);
}

TEST(CommandLine, TakesListsInTheWaysThatAreAllowed)
{
    CommandLine line("tool", "A tool", "  tool in");
    std::vector<std::string> any;
    std::vector<std::string> single;
    std::vector<std::string> commas;
    std::vector<std::string> files;
    line.add("--any", any, "Several");
    line.add("--single", single, "One each time").one_value_each_time();
    line.add("--commas", commas, "Also with commas").comma_separated();
    line.add("files", files, "Rest").count(1, 2);

    EXPECT_TRUE(
        parse(line, {"--any", "a", "b", "--single", "c", "file", "--single", "d,e", "--commas", "f,g"}));

    EXPECT_THAT(any, ElementsAre("a", "b"));
    EXPECT_THAT(single, ElementsAre("c", "d,e"));
    EXPECT_THAT(commas, ElementsAre("f", "g"));
    EXPECT_THAT(files, ElementsAre("file"));
}

TEST(CommandLine, RefusesValuesOutsideWhatIsAllowed)
{
    std::string method;
    int count = 0;
    double share = 0;
    double size = 0;
    double ratio = 0;
    const auto describe = [&](CommandLine& line) {
        line.add("--method", method, "One of two").one_of({"rbf", "idw"});
        line.add("--count", count, "From 1 to 3").range(1, 3);
        line.add("--share", share, "From 0 to 1").range(0.0, 1.0);
        line.add("--size", size, "Positive").positive();
        line.add("--ratio", ratio, "Above 1").above(1);
    };
    EXPECT_THAT(refusal(describe, {"--method", "ffd"}), HasSubstr("ffd not in {rbf,idw}"));
    EXPECT_THAT(refusal(describe, {"--count", "4"}), HasSubstr("Value 4 not in range 1 to 3"));
    EXPECT_THAT(refusal(describe, {"--count", "two"}), HasSubstr("two"));
    EXPECT_THAT(refusal(describe, {"--share", "1.5"}), HasSubstr("Value 1.5 not in range"));
    EXPECT_THAT(refusal(describe, {"--size", "0"}), HasSubstr("Value 0 not in range"));
    EXPECT_THAT(refusal(describe, {"--ratio", "1"}), HasSubstr("'1' is not a number above 1"));
    EXPECT_THAT(refusal(describe, {"--ratio", "inf"}), HasSubstr("'inf' is not a number above 1"));
    EXPECT_EQ(refusal(describe, {"--method", "idw", "--count", "3", "--share", "1", "--size", "1e-9",
                                 "--ratio", "1.2"}),
              "accepted");
}

TEST(CommandLine, RefusesArgumentsThatDoNotFitTogether)
{
    std::string input;
    int size = 0;
    int count = 0;
    const auto describe = [&](CommandLine& line) {
        line.add("input", input, "A file").required();
        const Option first = line.add("--size", size, "One of them");
        line.add("--count", count, "Or the other").excludes(first);
    };
    EXPECT_THAT(refusal(describe, {}), HasSubstr("input is required"));
    EXPECT_THAT(refusal(describe, {"a", "--size", "1", "--count", "2"}), HasSubstr("excludes"));
    EXPECT_THAT(refusal(describe, {"a", "b"}), HasSubstr("unexpected argument 'b'"));
    EXPECT_THAT(refusal(describe, {"a", "--siez", "1"}),
                HasSubstr("unknown option '--siez'; did you mean '--size'?"));
}

TEST(CommandLine, ReadsANumberOnlyIfItIsTheWholeText)
{
    EXPECT_EQ(number_in("-2.5e1"), -25);
    EXPECT_FALSE(number_in("2.5mm"));
    EXPECT_FALSE(number_in(""));
}

} // namespace
