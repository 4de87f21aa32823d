#include "libmorph/core/error.h"
#include "libmorph/geometry/mesh_domain.h"
#include "tests/support/domains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace morph {
namespace {

using namespace test;
using testing::HasSubstr;

struct Refusal {
    std::string name;
    DomainSpec spec;
    std::string message;
};

class RefusedDomain : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedDomain, SaysWhatIsWrong)
{
    try {
        mesh_domain(GetParam().spec);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
        EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
    }
}

std::vector<Refusal> refusals()
{
    constexpr std::array<double, 4> box = {-5, -5, 5, 5};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Curve round = round_curve(0, 0, 1);
    const Curve eight = closed_curve(1, {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}});
    const Curve loop = closed_curve(3, {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}});
    const Curve flat = closed_curve(2, {{-1, 0}, {0, 0}, {1, 0}, {0, 0}});
    const Curve point = closed_curve(2, {{0, 0}, {0, 0}, {0, 0}});
    CurveDefinition open = round.definition();
    open.closed = false;
    DomainSpec few = thesis_case(1);
    few.max_vertices = 1500;
    return {
        {"flat_box", {{-5, 1, 5, 1}, 1, {}}, "the box [-5, 1, 5, 1] has no area"},
        {"box_turned_round", {{5, -5, -5, 5}, 1, {}}, "has no area; it is [xmin, ymin, xmax, ymax]"},
        {"box_not_a_number", {{nan, -5, 5, 5}, 1, {}}, "not finite"},
        {"box_infinite", {{-5, -5, infinity, 5}, 1, {}}, "not finite"},
        {"size_zero", {box, 0, {}}, "size is 0"},
        {"size_negative", {box, -1, {}}, "size is -1"},
        {"size_not_a_number", {box, nan, {}}, "size is nan"},
        {"size_infinite", {box, infinity, {}}, "size is inf"},
        {"size_tiny", {box, 1e-4, {}}, "would give about 1.15473e+10 vertices; at most 20000000"},
        {"size_denormal", {box, 5e-324, {}}, "size 4.94066e-324"},
        {"sliver_box", {{0, 0, 1, 1e-9}, 1, {}}, "vertices; at most 20000000"},
        {"too_many_vertices", few, "more than 1500 vertices"},
        {"no_nodes",
         {box, 1, {{"a", round, 0}}},
         "boundary 'a' has nodes = 0; a closed curve needs at least 3"},
        {"two_nodes", {box, 1, {{"a", round, 2}}}, "boundary 'a' has nodes = 2"},
        {"negative_nodes", {box, 1, {{"a", round, -7}}}, "boundary 'a' has nodes = -7"},
        {"huge_nodes",
         {box, 1, {{"a", round, 2'000'000'000}}},
         "boundary 'a' has nodes = 2000000000; at most"},
        {"name_twice", {box, 1, {{"a", round, 40}, {"a", round_curve(3, 0, 1), 40}}}, "'a' is given twice"},
        {"name_of_the_box", {box, 1, {{"farfield", round, 40}}}, "'farfield' has the name of the box"},
        {"open_curve", {box, 1, {{"a", Curve(open), 40}}}, "boundary 'a' is open; a mesh can be generated"},
        {"figure_of_eight", {box, 1, {{"a", eight, 60}}}, "boundary 'a' crosses or touches itself near (0"},
        {"eight_between_nodes", {box, 1, {{"a", loop, 3}}}, "boundary 'a' crosses or touches itself near (0"},
        {"line_there_and_back", {box, 1, {{"a", flat, 40}}}, "boundary 'a' crosses or touches itself"},
        {"single_point",
         {box, 1, {{"a", point, 40}}},
         "boundary 'a' has two nodes at the same place near (0, 0)"},
        {"curves_cross",
         {box, 1, {{"a", round, 40}, {"b", round_curve(1, 0, 1), 40}}},
         "boundary 'a' crosses or touches boundary 'b' near (0.5, "},
        {"same_curve_twice",
         {box, 1, {{"a", round, 40}, {"b", round, 40}}},
         "'a' crosses or touches boundary 'b'"},
        {"curve_in_curve",
         {box, 1, {{"a", round, 40}, {"b", round_curve(0, 0, 0.5), 40}}},
         "boundary 'b' lies inside boundary 'a'"},
        {"curve_around_curve",
         {box, 1, {{"b", round_curve(0, 0, 0.5), 40}, {"a", round, 40}}},
         "boundary 'b' lies inside boundary 'a'"},
        {"curve_across_the_box",
         {box, 1, {{"a", round_curve(5, 0, 1), 40}}},
         "crosses or touches the box near (5"},
        {"curve_outside", {box, 1, {{"a", round_curve(9, 0, 1), 40}}}, "boundary 'a' lies outside the box"},
        {"curve_around_the_box",
         {box, 1, {{"a", round_curve(0, 0, 50), 40}}},
         "boundary 'a' lies outside the box"},
    };
}

INSTANTIATE_TEST_SUITE_P(MeshDomain, RefusedDomain, testing::ValuesIn(refusals()),
                         [](const auto& refusal) { return refusal.param.name; });

} // namespace
} // namespace morph
