// Cut, joined and reversed together, the trees of annealing and plain lists of triangles agree about which triangles
// are in one strip. A set of marked words has the same numbers as a std::set.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "restrip/search/impl/annealing_sets.hpp"

namespace restrip {
namespace {

TEST(StripTrees, AgreeWithLists) {
  constexpr Triangle count = 60;
  std::mt19937 random(3);
  detail::StripTrees trees;
  trees.reset(count);
  std::vector<std::vector<Triangle>> strips(count);
  for (Triangle t = 0; t < count; ++t) strips[t] = {t};
  const auto strip_of = [&](Triangle t) {
    return std::find_if(strips.begin(), strips.end(), [t](const std::vector<Triangle>& strip) {
      return std::find(strip.begin(), strip.end(), t) != strip.end();
    });
  };
  std::size_t longest = 0;
  for (int step = 0; step < 20'000; ++step) {
    const auto t = static_cast<Triangle>(random() % count);
    const auto u = static_cast<Triangle>(random() % count);
    const auto one = strip_of(t);
    const auto other = strip_of(u);
    ASSERT_EQ(trees.together(t, u), one == other);
    if (one != other && random() % 8 != 0) {
      if (random() % 2 == 0) std::reverse(one->begin(), one->end());
      if (random() % 2 == 0) std::reverse(other->begin(), other->end());
      trees.link(one->back(), other->front());
      one->insert(one->end(), other->begin(), other->end());
      longest = std::max(longest, one->size());
      strips.erase(other);
    } else if (one == other && one->size() > 1) {
      const auto at = static_cast<std::ptrdiff_t>(1 + random() % (one->size() - 1));
      const auto second = one->begin() + at;
      if (random() % 2 == 0)
        trees.cut(second[-1], second[0]);
      else
        trees.cut(second[0], second[-1]);
      std::vector<Triangle> rest(second, one->end());
      one->erase(second, one->end());
      strips.push_back(std::move(rest));
    }
  }
  EXPECT_GT(longest, std::size_t{count / 2});
}

TEST(MarkedWords, AgreeWithASet) {
  std::mt19937 random(4);
  for (const std::uint32_t bound : {1U, 64U, 65U, 4096U, 4097U, 300'000U}) {
    detail::MarkedWords words;
    EXPECT_TRUE(words.empty());
    EXPECT_EQ(words.next(0), detail::MarkedWords::no_word);
    words.reset(bound);
    std::set<std::uint32_t> numbers;
    for (int step = 0; step < 300; ++step) {
      const auto number = static_cast<std::uint32_t>(random() % bound);
      if (random() % 3 != 0) {
        words.mark(number);
        numbers.insert(number);
      } else if (!numbers.empty()) {
        const std::uint32_t gone = *numbers.begin();
        words.clear(gone);
        numbers.erase(gone);
      }
      const auto from = numbers.lower_bound(number / 64 * 64);
      ASSERT_EQ(words.next(number / 64), from == numbers.end() ? detail::MarkedWords::no_word : *from / 64);
    }
    std::vector<std::uint32_t> found;
    for (std::size_t word = words.next(0); word != detail::MarkedWords::no_word; word = words.next(word + 1))
      for (std::uint64_t left = words[word]; left != 0; left &= left - 1)
        found.push_back(static_cast<std::uint32_t>(64 * word + static_cast<unsigned>(std::countr_zero(left))));
    EXPECT_EQ(found, std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
  }
}

}  // namespace
}  // namespace restrip
