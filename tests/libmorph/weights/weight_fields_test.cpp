#include "libmorph/core/error.h"
#include "libmorph/weights/weight_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::HasSubstr;

Weights example()
{
    return {{{"body", 0}, {"body", 1}, {"flap", 0}}, Matrix::Random(5, 3)};
}

std::string complaint(const std::vector<Field>& fields)
{
    try {
        weights_from_fields(fields, example().columns);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(WeightFields, AreNamedByBoundaryAndControlPointFromOne)
{
    const auto fields = weight_fields(example());
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_EQ(fields[0].name, "h_body_1");
    EXPECT_EQ(fields[2].name, "h_flap_1");
}

TEST(WeightFields, ComeBackAsTheSameWeightsInAnyOrder)
{
    const Weights weights = example();
    auto fields = weight_fields(weights);
    std::swap(fields[0], fields[2]);
    fields.push_back({"pressure", FieldLocation::vertex, Matrix::Zero(5, 1)});
    EXPECT_EQ(weights_from_fields(fields, weights.columns).values, weights.values);
}

TEST(WeightFields, NameWhatIsMissingOrBroken)
{
    auto fields = weight_fields(example());
    fields[1].values(3, 0) = std::nan("");
    EXPECT_THAT(complaint(fields), HasSubstr("'h_body_2' holds a value that is not finite"));
    fields[1].values = Matrix::Zero(5, 2);
    EXPECT_THAT(complaint(fields), HasSubstr("2 components"));
    fields[1].location = FieldLocation::element;
    EXPECT_THAT(complaint(fields), HasSubstr("no nodal field 'h_body_2', but h_body_1, h_flap_1"));
    EXPECT_THAT(complaint({}), HasSubstr("none at all"));
}

} // namespace
