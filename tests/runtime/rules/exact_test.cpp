// restrip::exact answers fans of any size: small ones, valences around the word size, and far above it. Soundness by
// graphs with union-find, optimality by a second, independent search. Every key up to k = 8: rules_test.cpp, against
// the tables and by exhaustion, and verify.automaton.shipped, by digests of the answers that the certificate gives.
#include "restrip/rules/exact.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "../../support/failing_new.hpp"
#include "fan_operation.hpp"
#include "outside_frontier.hpp"

namespace restrip::exact {
namespace {

// Answers at compile time. A square without ports becomes one strand of six triangles.
static_assert(best(ring_with_chord(4, 2), 0, 0).value == Value{5, 0});
static_assert(best(closed_fan(4), 0b1111, 0b0101).value == Value{2, 0});
static_assert(best(closed_fan(3), 0, 0).value == Value{2, 0});
static_assert(best(open_fan(1), 0, 0).value == Value{0, 1});
static_assert(noexcept(best(ring_with_chord(4, 2), Word{0}, Word{0})));

void check(const FanOperation& operation, const RandomKey& key) {
  const naive::Patch patch = operation.patch();
  const std::size_t colors = patch.edges.size();
  const std::vector<Word> ports = naive::words_of(key.ports);
  const std::vector<Word> joined = naive::words_of(key.joined);
  std::vector<Word> out(words_for(colors), ~Word{0});
  const std::size_t allocated = testing_support::allocations();
  const Value value =
      best(operation.after(), BitSpan{ports.data()}, BitSpan{joined.data()}, MutableBitSpan{out.data()});
  EXPECT_LE(testing_support::allocations(), allocated + (operation.k <= 64 ? 0 : 1));
  for (std::size_t e = colors; e < out.size() * word_bits; ++e) EXPECT_FALSE(BitSpan{out.data()}[e]);

  const naive::Analysis truth = naive::analyze(patch, naive::bits_from(out, colors), key.ports);
  ASSERT_TRUE(truth.valid);
  EXPECT_TRUE(naive::subset(truth.joined, naive::pairs_of(patch, key.ports, key.joined)));
  EXPECT_EQ(value, (Value{truth.solid, truth.isolated}));
  EXPECT_EQ(truth.value(), naive::best_for_key(patch, key.ports, key.joined));

  if (operation.k > max_word_valence) return;
  const Recoloring word = best(operation.after(), naive::mask_of(key.ports), naive::mask_of(key.joined));
  EXPECT_EQ(word.value, value);
  EXPECT_EQ(naive::bits_of(word.colors, colors), naive::bits_from(out, colors));
}

void check_many(std::uint64_t seed, int runs, std::size_t from, std::size_t to) {
  std::mt19937_64 random(seed);
  for (int run = 0; run < runs; ++run) {
    const FanOperation operation = random_operation(random, from + random() % (to - from));
    SCOPED_TRACE("seed " + std::to_string(seed) + " run " + std::to_string(run) + " " + operation.text());
    ASSERT_NO_FATAL_FAILURE(check(operation, RandomKey(random, operation.k)));
    if (testing::Test::HasFailure()) return;
  }
  std::cout << runs << " random fans, k = " << from << " ... " << to - 1 << '\n';
}

// Small ones, around the size of a word, several words, a thousand triangles.
TEST(Exact, FansOfEverySize) {
  check_many(20260101, 10000, 3, 13);
  check_many(20260102, 2500, 55, 70);
  check_many(20260103, 1200, 65, 201);
  check_many(20260104, 40, 1000, 1001);
}

}  // namespace
}  // namespace restrip::exact
