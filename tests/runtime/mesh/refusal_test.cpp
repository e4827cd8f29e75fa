// Each refusal has its own sentence, and any other number is called unknown.
#include "restrip/mesh/refusal.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace restrip {
namespace {

static_assert(static_cast<int>(Refusal::granted) == 0, "a refusal that is not zero is one");

TEST(Refusals, EachHasASentenceOfItsOwn) {
  std::set<std::string> sentences;
  const int last = static_cast<int>(Refusal::colors_not_valid);
  for (int n = 0; n <= last; ++n) {
    const std::string sentence = describe(static_cast<Refusal>(n));
    EXPECT_GT(sentence.size(), 15U);
    EXPECT_NE(sentence, "unknown");
    EXPECT_TRUE(sentences.insert(sentence).second) << sentence;
  }
  EXPECT_STREQ(describe(static_cast<Refusal>(last + 1)), "unknown");
}

}  // namespace
}  // namespace restrip
