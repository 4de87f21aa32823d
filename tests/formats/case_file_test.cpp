#include "formats/case/case_file.h"
#include "libmorph/core/error.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace morph;
using ::testing::HasSubstr;

const std::string kCase = R"([mesh]
file = "wing.su2"

[[boundary]]
name = "airfoil"
degree = 2
closed = true
control_points = [[0, 0], [1, 0], [1, 1], [0, 1]]
displacements = [[1, -0.5], [1, -0.5], [1, -0.5], [1, -0.5]]

[deform]
diffusivity = "inverse-distance"
guard = "none"
fixed = ["farfield"]

[output]
mesh = "out/moved.su2"
)";

std::string with(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(CaseFile, IsReadWholeWithPathsRelativeToIt)
{
    const test::TemporaryFolder folder;
    const CaseFile file = read_case_file(folder.write("case.toml", kCase));
    EXPECT_EQ(file.mesh_file, folder.file("wing.su2"));
    EXPECT_EQ(file.output_mesh, folder.file("out/moved.su2"));
    ASSERT_EQ(file.motion.curves.size(), 1U);
    EXPECT_EQ(file.motion.curves[0].marker, "airfoil");
    EXPECT_EQ(file.motion.curves[0].curve.degree, 2);
    EXPECT_TRUE(file.motion.curves[0].curve.closed);
    EXPECT_EQ(file.motion.curves[0].curve.control_points(2, 1), 1);
    EXPECT_EQ(file.motion.curves[0].displacements(3, 1), -0.5);
    EXPECT_EQ(file.motion.deform.diffusivity, Diffusivity::inverse_distance);
    EXPECT_EQ(file.motion.deform.guard, Guard::none);
    EXPECT_THAT(*file.motion.deform.fixed, ::testing::ElementsAre("farfield"));
}

TEST(CaseFile, GivesEveryEntryItsPlaceForMessages)
{
    const test::TemporaryFolder folder;
    const std::string more = R"(
[lattice]
points = [4, 3]
box = [0, 0, 1, 1]
[[pull]]
vertices = [3]
displacements = [[0, 1]]
[constraints]
area = ["airfoil"]
[[constraints.thickness]]
boundary = "airfoil"
at = [0.5]
keep = 1
)";
    const std::string path = folder.write("case.toml", kCase + more);
    const MotionSettings motion = read_case_file(path).motion;
    EXPECT_EQ(motion.where, path + ": ");
    EXPECT_EQ(motion.curves[0].where, path + ":4: ");
    EXPECT_EQ(motion.deform.where, path + ":11: ");
    EXPECT_EQ(motion.lattice->where, path + ":19: ");
    EXPECT_EQ(motion.pulls[0].where, path + ":22: ");
    EXPECT_EQ(motion.constraints->where, path + ":25: ");
    EXPECT_EQ(motion.constraints->thicknesses[0].where, path + ":27: ");
}

TEST(CaseFile, TakesMovedPointsAndFilesOfPoints)
{
    const test::TemporaryFolder folder;
    folder.write("points.csv", "# corners\nid,px,py\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n");
    std::string text = with(kCase, "[[0, 0], [1, 0], [1, 1], [0, 1]]",
                            "{ file = \"points.csv\", columns = [\"px\", \"py\"] }");
    text = with(text, "displacements = [[1, -0.5], [1, -0.5], [1, -0.5], [1, -0.5]]",
                "moved = [[0, 0.25], [1, 0], [1, 1], [0.5, 1]]");
    const CaseFile file = read_case_file(folder.write("case.toml", text));
    EXPECT_EQ(file.motion.curves[0].curve.control_points(3, 1), 1);
    EXPECT_EQ(file.motion.curves[0].displacements(0, 1), 0.25);
    EXPECT_EQ(file.motion.curves[0].displacements(3, 0), 0.5);
}

TEST(CaseFile, GeneratesInsteadOfReading)
{
    const test::TemporaryFolder folder;
    const CaseFile file =
        read_case_file(folder.write("case.toml", with(kCase, "file = \"wing.su2\"",
                                                      "generate = { box = [-15, -5, 25, 25], size = 1.5 }")));
    ASSERT_TRUE(file.generate);
    EXPECT_EQ(file.generate->box[3], 25);
    EXPECT_EQ(file.generate->size, 1.5);
}

struct BrokenCase {
    std::string what; ///< for the test's name in a failure
    std::string from; ///< text of kCase to replace
    std::string to;
    int line; ///< where the message must point
    std::string message;
};

class BrokenCaseFile : public ::testing::TestWithParam<BrokenCase> {};

TEST_P(BrokenCaseFile, IsRefusedWithLineAndReason)
{
    const test::TemporaryFolder folder;
    folder.write("short.csv", "x,y\n0,0\n1\n");
    folder.write("words.csv", "x,y\n0,zero\n");
    folder.write("columns.csv", "a,b\n0,0\n");
    const std::string path = folder.write("case.toml", with(kCase, GetParam().from, GetParam().to));
    try {
        read_case_file(path);
        FAIL() << GetParam().what << " was accepted";
    } catch (const InputError& error) {
        const std::string place =
            GetParam().line > 0 ? path + ":" + std::to_string(GetParam().line) + ": " : folder.path();
        EXPECT_THAT(error.what(), HasSubstr(place)) << GetParam().what;
        EXPECT_THAT(error.what(), HasSubstr(GetParam().message)) << GetParam().what;
        EXPECT_THAT(std::string(error.what()), ::testing::Not(HasSubstr("\n"))) << GetParam().what;
    }
}

const std::string kPoints = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

INSTANTIATE_TEST_SUITE_P(
    All, BrokenCaseFile,
    ::testing::Values(
        BrokenCase{"key with a near name", "degree = 2", "degre = 2", 6, "did you mean 'degree'?"},
        BrokenCase{"key in another table", "[output]", "[output]\nguard = \"none\"", 17,
                   "unknown key 'guard'"},
        BrokenCase{"unknown table", "[output]", "[outptu]", 16, "did you mean 'output'?"},
        BrokenCase{"syntax", "degree = 2", "degree = = 2", 6, ""},
        BrokenCase{"cut off", "control_points = [[0, 0], [1, 0], [1, 1], [0, 1]]\n",
                   "control_points = [[0, 0], [1,", 0, ""},
        BrokenCase{"degree as text", "degree = 2", "degree = \"two\"", 6, "whole number from 1 to 7"},
        BrokenCase{"degree zero", "degree = 2", "degree = 0", 6, "whole number from 1 to 7"},
        BrokenCase{"degree too high", "degree = 2", "degree = 8", 6, "whole number from 1 to 7"},
        BrokenCase{"degree huge", "degree = 2", "degree = 99999999999999", 6, "whole number"},
        BrokenCase{"closed as number", "closed = true", "closed = 1", 7, "must be true or false"},
        BrokenCase{"name as number", "name = \"airfoil\"", "name = 7", 5, "must be a text in quotes"},
        BrokenCase{"no name", "name = \"airfoil\"\n", "", 4, "needs name"},
        BrokenCase{"no points", "control_points = " + kPoints + "\n", "", 4, "needs control_points"},
        BrokenCase{"points as text", kPoints, "\"many\"", 8, "list of pairs"},
        BrokenCase{"a point of three numbers", "[1, 0],", "[1, 0, 0],", 8, "entry 2"},
        BrokenCase{"a point of text", "[1, 0],", "[1, \"0\"],", 8, "must be a number"},
        BrokenCase{"a point that is not finite", "[1, 0],", "[1, nan],", 8, "finite"},
        BrokenCase{"an infinite point", "[1, 0],", "[inf, 0],", 8, "finite"},
        BrokenCase{"too few points", kPoints, "[[0, 0]]", 9, "4"},
        BrokenCase{"displacements of another number", "[1, -0.5], [1, -0.5]]", "[1, -0.5]]", 9, "3 rows"},
        BrokenCase{"displacements and moved", "[deform]", "moved = [[0, 0]]\n[deform]", 11, "not both"},
        BrokenCase{"knots that decrease", "closed = true", "closed = true\nknots = [0, 0.5, 0.25, 0.75, 1]",
                   4, "boundary 'airfoil'"},
        BrokenCase{"knots of another number", "closed = true", "closed = true\nknots = [0, 1]", 4,
                   "boundary 'airfoil'"},
        BrokenCase{"a weight of zero", "closed = true", "closed = true\nweights = [1, 0, 1, 1]", 4,
                   "boundary 'airfoil'"},
        BrokenCase{"a missing file of points", kPoints, "{ file = \"none.csv\" }", 0,
                   "none.csv: cannot be read"},
        BrokenCase{"a file of points with a short row", kPoints, "{ file = \"short.csv\" }", 0,
                   "short.csv:3: has 1 values"},
        BrokenCase{"a file of points with words", kPoints, "{ file = \"words.csv\" }", 0,
                   "words.csv:2: column 'y'"},
        BrokenCase{"a file of points without the column", kPoints, "{ file = \"columns.csv\" }", 0,
                   "has no column 'x', but a, b"},
        BrokenCase{"a folder as file of points", kPoints, "{ file = \".\" }", 0, "cannot be read"},
        BrokenCase{"a key in the file of points", kPoints, "{ fil = \"a.csv\" }", 8, "did you mean 'file'?"},
        BrokenCase{"file and generate", "file = \"wing.su2\"",
                   "file = \"wing.su2\"\ngenerate = { box = [0, 0, 1, 1], size = 1 }", 1, "not both"},
        BrokenCase{"neither", "file = \"wing.su2\"\n", "", 1, "either file or generate"},
        BrokenCase{"a box of no area", "file = \"wing.su2\"", "generate = { box = [1, 0, 1, 1], size = 1 }",
                   2, "box has no area"},
        BrokenCase{"a box of three", "file = \"wing.su2\"", "generate = { box = [1, 0, 1], size = 1 }", 2,
                   "four numbers"},
        BrokenCase{"a size of zero", "file = \"wing.su2\"", "generate = { box = [0, 0, 1, 1], size = 0 }", 2,
                   "above 0"},
        BrokenCase{"no size", "file = \"wing.su2\"", "generate = { box = [0, 0, 1, 1] }", 2, "needs size"},
        BrokenCase{"a diffusivity with a near name", "\"inverse-distance\"", "\"inverse-distanc\"", 12,
                   "did you mean 'inverse-distance'?"},
        BrokenCase{"an unknown method", "guard = \"none\"", "method = \"magic\"", 13,
                   "must be one of harmonic"},
        BrokenCase{"fixed as text", "[\"farfield\"]", "\"farfield\"", 14, "list of names"},
        BrokenCase{"a boundary as plain table", "[[boundary]]", "[boundary]", 4, "[[boundary]]"},
        BrokenCase{
            "a second boundary of that name", "[deform]",
            "[[boundary]]\nname = \"airfoil\"\ncontrol_points = [[0, 0], [1, 0], [1, 1], [0, 1]]\n[deform]",
            11, "given twice"},
        BrokenCase{"no boundary",
                   kCase.substr(kCase.find("[[boundary]]"), kCase.find("[deform]") - kCase.find("[[b")), "",
                   1, "no [[boundary]]"}));

TEST(CaseFile, RefusesWhatIsNoTextAtAll)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(read_case_file(folder.path()), InputError);
    EXPECT_THROW(read_case_file(folder.file("none.toml")), InputError);
    EXPECT_THROW(read_case_file(folder.write("empty.toml", "")), InputError);
    EXPECT_THROW(read_case_file(folder.write("noise.toml", std::string("\x7f"
                                                                       "ELF\0\1\2\xff\xfe",
                                                                       9))),
                 InputError);
    EXPECT_THROW(read_case_file(folder.write("deep.toml", "a = " + std::string(100000, '['))), InputError);
}

} // namespace
