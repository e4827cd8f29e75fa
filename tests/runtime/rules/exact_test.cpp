// Claim: restrip::exact returns a sound recolouring, and no other is better. Proved by exhaustion for every key and
// every position, valence by valence, against graphs with union-find.
//
// RESTRIP_EXHAUSTIVE=1 in the environment continues to k = 12.
#include "restrip/rules/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "fan_operation.hpp"
#include "naive_patch.hpp"

namespace restrip::exact {
namespace {

// Answers at compile time. A square without ports becomes one strand of six triangles.
static_assert(best(ring_with_chord(4, 2), 0, 0).value == Value{5, 0});
static_assert(best(closed_fan(4), 0b1111, 0b0101).value == Value{2, 0});
static_assert(best(closed_fan(3), 0, 0).value == Value{2, 0});
static_assert(best(open_fan(1), 0, 0).value == Value{0, 1});
static_assert(noexcept(best(ring_with_chord(4, 2), Word{0}, Word{0})));

long number_of(const Value& value) { return value.solid * 1'000'000L - value.isolated; }

// The largest valence to search. An unoptimised build stops one earlier, to stay below half a minute.
std::size_t largest() {
#ifdef __OPTIMIZE__
  const std::size_t usual = 10;
#else
  const std::size_t usual = 9;
#endif
  return std::getenv("RESTRIP_EXHAUSTIVE") != nullptr ? 12 : usual;
}

// Every key of one patch; `answer` takes ports and joined.
template <class Answer>
void check_all_keys(const naive::Patch& patch, Answer answer) {
  const std::size_t k = patch.port_node.size();
  naive::ExhaustiveSearch search(patch);
  std::size_t keys = 0;
  for (Word ports = 0; ports < (Word{1} << k); ++ports) {
    search.solve(ports);
    for (Word given = ports;; given = (given - 1) & ports) {
      // In a ring with two solid ports one bit is as good as two; a lone port, or a path's first, has none before it.
      const Word joined = patch.cyclic ? canonical_joined(ports, given) : given;
      const bool meaningful = patch.cyclic ? (ports & (ports - 1)) != 0 : (given & ports & (~ports + 1)) == 0;
      if (meaningful || given == 0) {
        ++keys;
        const Recoloring best = answer(ports, given);
        const auto judged = search.judge(best.colors, joined);
        if (!judged || *judged != number_of(best.value) || *judged != search.best(joined)) {
          ADD_FAILURE() << "k " << k << " ports " << ports << " joined " << given << " colors " << best.colors
                        << " value " << number_of(best.value) << (judged ? "" : ", not sound") << "; best is "
                        << search.best(joined);
          return;
        }
      }
      if (given == 0) break;
    }
  }
  // Each triangle lacks a solid port, or has one that is joined or not; but see `meaningful`.
  std::size_t words = 1;
  for (std::size_t i = 0; i < k; ++i) words *= 3;
  EXPECT_EQ(keys, patch.cyclic ? words - k : (words + 1) / 2);
}

TEST(Exact, EveryKeyAtEveryPosition) {
  constexpr std::size_t smallest[] = {2, 3, 1, 1, 1};
  for (int family = 0; family < 5; ++family)
    for (std::size_t k = smallest[family]; k <= largest(); ++k)
      for (const FanOperation& operation : fan_operations(family, k)) {
        SCOPED_TRACE(operation.text());
        check_all_keys(operation.patch(),
                       [&](Word ports, Word joined) { return best(operation.after(), ports, joined); });
      }
}

// From colours to colours: for every valid configuration the answer to its key is best among the recolourings that join
// no pair but the configuration's own, for all such pairs. This does not depend on keys.
void check_all_configurations(const FanOperation& operation_before, const FanOperation& operation) {
  const naive::Patch before = operation_before.patch();
  const naive::Patch after = operation.patch();
  const std::size_t k = operation.k;
  for (Word ports = 0; ports < (Word{1} << k); ++ports) {
    const naive::Bits port_bits = naive::bits_of(ports, k);
    std::vector<naive::Analysis> recolorings;
    for (Word inner = 0; inner < (Word{1} << after.edges.size()); ++inner) {
      recolorings.push_back(naive::analyze(after, naive::bits_of(inner, after.edges.size()), port_bits));
    }
    for (Word inner = 0; inner < (Word{1} << before.edges.size()); ++inner) {
      const naive::Analysis now = naive::analyze(before, naive::bits_of(inner, before.edges.size()), port_bits);
      if (!now.valid) continue;
      long best = std::numeric_limits<long>::min();
      for (const naive::Analysis& next : recolorings)
        if (next.valid && naive::subset(next.joined, now.joined)) best = std::max(best, next.value());
      const Recoloring found = exact::best(operation.after(), ports, operation_before.after().joined(inner, ports));
      const naive::Analysis& next = recolorings.at(found.colors);
      ASSERT_TRUE(next.valid && naive::subset(next.joined, now.joined)) << "inner " << inner << " ports " << ports;
      ASSERT_EQ(number_of(found.value), next.value()) << "inner " << inner << " ports " << ports;
      ASSERT_EQ(next.value(), best) << "inner " << inner << " ports " << ports;
    }
  }
}

TEST(Exact, EveryConfiguration) {
  for (const int family : {0, 2, 3})
    for (std::size_t k = family == 0 ? 3 : 1; k <= (family == 0 ? 6U : 5U); ++k)
      for (const FanOperation& split : fan_operations(family, k)) {
        SCOPED_TRACE(split.text());
        check_all_configurations(split.inverse(), split);
        check_all_configurations(split, split.inverse());
      }
}

}  // namespace
}  // namespace restrip::exact
