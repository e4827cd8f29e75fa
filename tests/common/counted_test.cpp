// Claim: counts are in correct English, with a singular for one. tests/tools/program_test.py tests the program for it.
#include "common/counted.hpp"

#include <gtest/gtest.h>

namespace restrip {
namespace {

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(0, "strip"), "0 strips");
  EXPECT_EQ(counted(1, "strip"), "1 strip");
  EXPECT_EQ(counted(21, "strip"), "21 strips");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(11, "vertex", "vertices"), "11 vertices");
}

}  // namespace
}  // namespace restrip
