// restrip::exact beyond what can be enumerated: valences around the word size and far above it. Soundness by graphs
// with union-find, optimality by a second, independent search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <new>
#include <random>
#include <string>
#include <vector>

#include "frontier_search.hpp"
#include "naive_patch.hpp"
#include "restrip/rules/exact.hpp"

namespace {
std::size_t allocations = 0;
}  // namespace

// Not inlined, or the compiler takes the pair of malloc and free below for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace restrip::exact {
namespace {

constexpr const char* families[] = {"split", "collapse", "open-split", "boundary-split", "fan-collapse"};

struct Instance {
  int family = 0;
  std::size_t k = 0;
  std::size_t a = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  naive::Bits ports;
  naive::Bits joined;

  naive::Patch patch() const {
    switch (family) {
      case 0:
        return naive::ring_with_chord(k, a);
      case 1:
        return naive::closed_fan(k);
      case 2:
        return naive::path_with_chord(k, i, j);
      case 3:
        return naive::path(k, i);
      default:
        return naive::open_fan(k);
    }
  }

  Value solve(BitSpan p, BitSpan q, MutableBitSpan out) const {
    switch (family) {
      case 0:
        return best_split(k, a, p, q, out);
      case 1:
        return best_collapse(k, p, q, out);
      case 2:
        return best_open_split(k, i, j, p, q, out);
      case 3:
        return best_boundary_split(k, i, p, q, out);
      default:
        return best_fan_collapse(k, p, q, out);
    }
  }

  Recoloring solve_word() const {
    const Word p = naive::mask_of(ports);
    const Word q = naive::mask_of(joined);
    switch (family) {
      case 0:
        return best_split(k, a, p, q);
      case 1:
        return best_collapse(k, p, q);
      case 2:
        return best_open_split(k, i, j, p, q);
      case 3:
        return best_boundary_split(k, i, p, q);
      default:
        return best_fan_collapse(k, p, q);
    }
  }
};

Instance random_instance(std::mt19937_64& random, std::size_t k) {
  Instance result;
  result.family = static_cast<int>(random() % 5);
  result.k = k;
  result.a = 1 + random() % (k - 1);
  result.i = random() % k;
  result.j = result.i + 1 + random() % (k - result.i);
  if (random() % 4 == 0) result.i = 0;
  if (random() % 4 == 0) result.j = k;
  // Between a handful of ports and all of them, and each pair joined seldom or nearly always.
  const std::uint64_t solid_of_64 = random() % 3 == 0 ? random() % 4 : random() % 65;
  const std::uint64_t joined_of_8 = random() % 9;
  result.ports.resize(k);
  result.joined.resize(k);
  for (std::size_t x = 0; x < k; ++x) {
    result.ports[x] = random() % 64 < solid_of_64;
    result.joined[x] = result.ports[x] && random() % 8 < joined_of_8;
  }
  return result;
}

void check(const Instance& instance) {
  const naive::Patch patch = instance.patch();
  const std::size_t colors = patch.edges.size();
  const std::vector<Word> ports = naive::words_of(instance.ports);
  const std::vector<Word> joined = naive::words_of(instance.joined);
  std::vector<Word> out(words_for(colors), ~Word{0});
  const std::size_t allocated = allocations;
  const Value value = instance.solve(BitSpan{ports.data()}, BitSpan{joined.data()}, MutableBitSpan{out.data()});
  if (instance.k <= 64) {
    EXPECT_EQ(allocations, allocated);
  } else {
    EXPECT_LE(allocations, allocated + 1);
  }
  for (std::size_t e = colors; e < out.size() * word_bits; ++e) EXPECT_FALSE(BitSpan{out.data()}[e]);

  const naive::Analysis truth = naive::analyze(patch, naive::bits_from(out, colors), instance.ports);
  ASSERT_TRUE(truth.valid);
  EXPECT_TRUE(naive::subset(truth.joined, naive::pairs_of(patch, instance.ports, instance.joined)));
  EXPECT_EQ(value, (Value{truth.solid, truth.isolated}));
  EXPECT_EQ(value.solid * 1000000L - value.isolated,
            naive::FrontierSearch(patch, instance.ports, instance.joined).best());

  if (instance.k > max_word_valence) return;
  const Recoloring word = instance.solve_word();
  EXPECT_EQ(word.value, value);
  EXPECT_EQ(naive::bits_of(word.colors, colors), naive::bits_from(out, colors));
}

void check_many(std::uint64_t seed, int runs, std::size_t from, std::size_t to) {
  std::mt19937_64 random(seed);
  for (int run = 0; run < runs; ++run) {
    const Instance instance = random_instance(random, from + random() % (to - from));
    SCOPED_TRACE("seed " + std::to_string(seed) + " run " + std::to_string(run) + " " + families[instance.family] +
                 " k " + std::to_string(instance.k));
    ASSERT_NO_FATAL_FAILURE(check(instance));
    if (testing::Test::HasFailure()) return;
  }
  std::cout << runs << " random fans, k = " << from << " ... " << to - 1 << '\n';
}

// The second search is right where everything can be enumerated, or at least agrees.
TEST(ExactLarge, Small) { check_many(20260101, 10000, 3, 13); }

TEST(ExactLarge, AroundTheWordSize) { check_many(20260102, 2500, 55, 70); }

TEST(ExactLarge, SeveralWords) { check_many(20260103, 1200, 65, 201); }

TEST(ExactLarge, Thousand) { check_many(20260104, 40, 1000, 1001); }

}  // namespace
}  // namespace restrip::exact
