#pragma once
// Tests that need the solver say so where it is missing.

#include <gtest/gtest.h>

#include <cstdlib>

namespace restrip::verify::sat::test {

inline bool cadical_is_there() { return std::system("command -v cadical >/dev/null 2>&1") == 0; }

}  // namespace restrip::verify::sat::test

#define RESTRIP_NEEDS_CADICAL() \
  if (!::restrip::verify::sat::test::cadical_is_there()) GTEST_SKIP() << "the package cadical is not installed"
