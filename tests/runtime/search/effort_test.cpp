// The defaults are the documented ones, and each effort comes after the ones that do less.
#include "restrip/search/effort.hpp"

#include <gtest/gtest.h>

namespace restrip {
namespace {

TEST(Effort, DefaultsAndOrder) {
  EXPECT_EQ(default_policy, Policy::quick);
  EXPECT_EQ(default_effort, Effort::fast);
  EXPECT_LT(Effort::fast, Effort::full);
  EXPECT_LT(Effort::full, Effort::best);
}

}  // namespace
}  // namespace restrip
