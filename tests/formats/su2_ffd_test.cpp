#include "formats/su2/ffd.h"

#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::message_of;

std::vector<Su2FfdBox> boxes_in(const std::string& text)
{
    return su2_ffd_boxes({{"su2", "FFD boxes", text}}, "wing.su2");
}

const std::string kBox = "FFD_TAG= BOX\nFFD_DEGREE_I= 2\nFFD_DEGREE_J= 1\nFFD_BLENDING= BEZIER\n"
                         "FFD_CORNER_POINTS= 4\n0 0\n2 0\n2 1\n0 1\n";

TEST(Su2Ffd, ReadsTheBoxesOfARealMesh)
{
    const std::string path = test::data_path("meshes/naca0012_multiffd.su2");
    const auto boxes = su2_ffd_boxes(read_mesh_data(path).sections, path);
    ASSERT_EQ(boxes.size(), 2U);
    EXPECT_EQ(boxes[0].tag, "UPPER");
    EXPECT_EQ(boxes[1].tag, "LOWER");
    EXPECT_EQ(boxes[0].dimension, 2);
    EXPECT_FALSE(boxes[0].bspline);
    EXPECT_THAT(boxes[0].points, ::testing::ElementsAre(5, 2, 1));
    EXPECT_THAT(boxes[0].degree, ::testing::ElementsAre(4, 1, 0));
    ASSERT_EQ(boxes[0].control_points.rows(), 10);
    EXPECT_EQ(boxes[0].control_points.row(0), Eigen::RowVector3d(0.075, 0.02, 0));
    EXPECT_EQ(boxes[0].control_points.row(5), Eigen::RowVector3d(0.075, 0.075, 0));
    EXPECT_EQ(boxes[0].control_points.row(9), Eigen::RowVector3d(0.625, 0.075, 0));
}

TEST(Su2Ffd, SpreadsControlPointsBetweenTheCornersWhereTheFileHasNone)
{
    const auto boxes = boxes_in(kBox);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_EQ(boxes[0].control_points.row(1), Eigen::RowVector3d(1, 0, 0));
    EXPECT_EQ(boxes[0].control_points.row(4), Eigen::RowVector3d(1, 1, 0));
}

TEST(Su2Ffd, ReadsABoxInSpaceOfUniformBSplines)
{
    const auto boxes =
        boxes_in("FFD_TAG= WING\nFFD_DEGREE_I= 4\nFFD_DEGREE_J= 3\nFFD_DEGREE_K= 1\n"
                 "FFD_BLENDING= BSPLINE_UNIFORM\nFFD_BSPLINE_ORDER_I= 3\nFFD_BSPLINE_ORDER_J= "
                 "3\nFFD_BSPLINE_ORDER_K= 2\n"
                 "FFD_CORNER_POINTS= 8\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n0 0 1\n4 0 1\n4 3 1\n0 3 1\n"
                 "FFD_CONTROL_POINTS= 1\n4 3 1 4 3 7\n");
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_TRUE(boxes[0].bspline);
    EXPECT_EQ(boxes[0].dimension, 3);
    EXPECT_THAT(boxes[0].points, ::testing::ElementsAre(5, 4, 2));
    EXPECT_THAT(boxes[0].degree, ::testing::ElementsAre(2, 2, 1));
    EXPECT_EQ(boxes[0].control_points.row(1 + 5 * (2 + 4 * 1)), Eigen::RowVector3d(1, 2, 1));
    EXPECT_EQ(boxes[0].control_points.row(39), Eigen::RowVector3d(4, 3, 7));
}

TEST(Su2Ffd, NamesTheBoxOfWhatIsWrong)
{
    const auto refusal = [](const std::string& from, const std::string& to) {
        std::string text = kBox;
        text.replace(text.find(from), from.size(), to);
        return message_of([&] { boxes_in(text); });
    };
    EXPECT_EQ(refusal("FFD_DEGREE_J= 1\n", ""), "wing.su2: FFD box 'BOX': has no FFD_DEGREE_J");
    EXPECT_EQ(refusal("= 2\n", "= 20000\n"),
              "wing.su2: FFD box 'BOX': FFD_DEGREE_I must be a number up to 1000");
    EXPECT_EQ(refusal("I= 2\nFFD_DEGREE_J= 1", "I= 900\nFFD_DEGREE_J= 900"),
              "wing.su2: FFD box 'BOX': has more than 100000 control points");
    EXPECT_EQ(refusal("POINTS= 4", "POINTS= 3"),
              "wing.su2: FFD box 'BOX': has 3 corner points, but 4 or 8 were expected");
    EXPECT_EQ(refusal("POINTS= 4", "POINTS= 9"),
              "wing.su2: FFD box 'BOX': FFD_CORNER_POINTS counts 9 points, but 4 follow");
    EXPECT_EQ(message_of([] { boxes_in(kBox + "FFD_CONTROL_POINTS= 1\n7 0 0 1 1 1\n"); }),
              "wing.su2: FFD box 'BOX': a control point has a number beyond the degrees of the box");
}

TEST(Su2Ffd, FindsNothingInWhatOtherFormatsCarry)
{
    EXPECT_TRUE(su2_ffd_boxes({{"gmsh", "notes", kBox}}, "x").empty());
}

} // namespace
