#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace morph;

TEST(NearestName, FindsAMistypedNameAndRefusesAFarOne)
{
    EXPECT_EQ(nearest_name("airfiol", {"farfield", "airfoil"}), "airfoil");
    EXPECT_EQ(nearest_name("AIRFOIL", {"farfield", "airfoil"}), "airfoil");
    EXPECT_EQ(nearest_name("wing", {"farfield", "airfoil"}), "");
    EXPECT_EQ(did_you_mean("degre", {"degree"}), "; did you mean 'degree'?");
}

TEST(ParallelFor, VisitsEveryItemOnceForAnyThreadCount)
{
    for (const int threads : {1, 2, 7}) {
        set_thread_count(threads);
        std::vector<int> visits(1003);
        parallel_for(visits.size(), 10, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 1003) << threads << " threads";
    }
    set_thread_count(0);
}

TEST(ParallelFor, PassesOnWhatABodyThrows)
{
    EXPECT_THROW(parallel_for(100, 1,
                              [](std::size_t begin, std::size_t) {
                                  if (begin == 50)
                                      throw InputError("item 50");
                              }),
                 InputError);
}

TEST(ParallelFor, RefusesANegativeThreadCount)
{
    EXPECT_THROW(set_thread_count(-1), InputError);
}

} // namespace
