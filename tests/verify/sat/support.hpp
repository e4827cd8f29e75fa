#pragma once
// Tests that need the solver fail where it is missing, or are skipped if it was missing when the build was configured
// and that was allowed.

#include <gtest/gtest.h>

#include <cstdlib>

namespace restrip::verify::sat::test {

inline bool cadical_is_there() { return std::system("command -v cadical >/dev/null 2>&1") == 0; }

}  // namespace restrip::verify::sat::test

#ifdef RESTRIP_ALLOW_MISSING
#define RESTRIP_NEEDS_CADICAL() \
  if (!::restrip::verify::sat::test::cadical_is_there()) GTEST_SKIP() << "the package cadical is not installed"
#else
#define RESTRIP_NEEDS_CADICAL() \
  ASSERT_TRUE(::restrip::verify::sat::test::cadical_is_there()) << "install the package cadical"
#endif
