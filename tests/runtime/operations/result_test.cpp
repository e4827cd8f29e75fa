// A result converts to whether the operation was granted, and is of a refused operation otherwise.
#include "restrip/operations/result.hpp"

#include <gtest/gtest.h>

namespace restrip {
namespace {

TEST(Result, IsTrueIfGranted) {
  for (int i = 0; i <= static_cast<int>(Refusal::colors_not_valid); ++i) {
    Checked result;
    result.refusal = static_cast<Refusal>(i);
    EXPECT_EQ(static_cast<bool>(result), result.refusal == Refusal::granted);
    EXPECT_EQ(result.granted(), static_cast<bool>(result));
    EXPECT_EQ(result.new_vertex(), none);
  }
}

TEST(Result, CountsCompare) {
  RuleCounts counts{.asked = 3, .taken = 2, .kept = 1};
  EXPECT_EQ(counts, (RuleCounts{3, 2, 1, 0}));
  counts.improved = 1;
  EXPECT_FALSE(counts == (RuleCounts{3, 2, 1, 0}));
}

}  // namespace
}  // namespace restrip
