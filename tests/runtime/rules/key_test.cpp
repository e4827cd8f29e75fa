// The key of every configuration, and its validity, against graphs with union-find; masks and bit strings alike.
#include "restrip/rules/key.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "fan_operation.hpp"
#include "naive_patch.hpp"

namespace restrip {
namespace {

// t_3 enters through its port, runs e_3 (round to t_0), e_0, and leaves at t_1.
static_assert(closed_fan(4).joined(0b1001, 0b1010) == 0b0010);
static_assert(canonical_joined(0b1010, 0b0010) == 0b1010);
static_assert(open_fan(4).joined(0b011, 0b0101) == 0b0100);
static_assert(closed_fan(4).valid(0b0111, 0b1001) && !closed_fan(4).valid(0b1111, 0) &&
              !closed_fan(4).valid(0b0011, 0b0010));
static_assert(!closed_fan(4).valid(0b10000, 0) && !closed_fan(4).valid(0, 0b10000));
static_assert(open_fan(4).valid(0b111, 0b1001) && !open_fan(4).valid(0b1000, 0));

// Counts the valid configurations of the patch that an operation leaves, after comparing each with the naive answer.
int compare_all(const exact::FanOperation& operation) {
  const naive::Patch patch = operation.patch();
  int valid = 0;
  for (Word ports = 0; ports < (Word{1} << operation.k); ++ports) {
    for (Word inner = 0; inner < (Word{1} << patch.edges.size()); ++inner) {
      const naive::Bits port_bits = naive::bits_of(ports, operation.k);
      const naive::Bits inner_bits = naive::bits_of(inner, patch.edges.size());
      const naive::Analysis truth = naive::analyze(patch, inner_bits, port_bits);
      const std::vector<Word> port_words = naive::words_of(port_bits);
      const std::vector<Word> inner_words = naive::words_of(inner_bits);
      Word joined_word = ~Word{0};
      operation.after().joined(BitSpan{inner_words.data()}, BitSpan{port_words.data()},
                               MutableBitSpan::of(joined_word));
      EXPECT_EQ(joined_word & ~ports, 0U);
      EXPECT_EQ(operation.after().joined(inner, ports) & ~ports, 0U);
      EXPECT_EQ(operation.after().valid(inner, ports), truth.valid) << "inner " << inner << " ports " << ports;
      EXPECT_EQ(operation.after().valid(BitSpan{inner_words.data()}, BitSpan{port_words.data()}), truth.valid);
      if (!truth.valid) continue;
      ++valid;
      const Word expected = naive::mask_of(naive::key_of(patch, port_bits, truth.joined));
      const auto canonical = [&](Word joined) { return patch.cyclic ? canonical_joined(ports, joined) : joined; };
      EXPECT_EQ(canonical(operation.after().joined(inner, ports)), expected) << "inner " << inner << " ports " << ports;
      EXPECT_EQ(canonical(joined_word), expected) << "inner " << inner << " ports " << ports;
    }
  }
  return valid;
}

TEST(Key, OfEveryConfiguration) {
  // Rings by (k, a), 1 <= a <= k/2: the figures of docs/explanation/theory.md for collapses. Closed fans by k.
  const std::vector<std::vector<int>> valid_rings = {
      {278}, {998, 1016}, {3562, 3640}, {12694, 12988, 13032}, {45218, 46280, 46492}};
  const std::vector<int> valid_fans = {44, 160, 572, 2040, 7268};
  for (int family = 0; family < 5; ++family)
    for (std::size_t k = family < 2 ? 3 : 1; k <= (family == 2 ? 6U : 7U); ++k)
      for (const exact::FanOperation& operation : exact::fan_operations(family, k)) {
        SCOPED_TRACE(operation.text());
        const int valid = compare_all(operation);
        if (family == 0) {
          EXPECT_EQ(valid, valid_rings[k - 3][std::min(operation.i, k - operation.i) - 1]);
        }
        if (family == 1) {
          EXPECT_EQ(valid, valid_fans[k - 3]);
        }
      }
}

// A random valid colouring: edges and ports in random order, each made solid when that breaks nothing and a coin
// agrees.
void color_at_random(const naive::Patch& patch, std::mt19937_64& random, naive::Bits& inner, naive::Bits& ports) {
  const std::size_t k = patch.port_node.size();
  const std::size_t edges = patch.edges.size();
  const std::uint64_t keep = 2 + random() % 14;  // of 16
  inner.assign(edges, false);
  ports.assign(k, false);
  std::vector<std::size_t> order(edges + k);
  for (std::size_t x = 0; x < order.size(); ++x) order[x] = x;
  const std::uint64_t few_ports = random() % 8;  // without ports strands grow long
  for (std::size_t x = order.size(); x-- > 1;) std::swap(order[x], order[random() % (x + 1)]);
  std::vector<int> degree(patch.nodes, 0);
  naive::UnionFind strands(patch.nodes);
  for (const std::size_t x : order) {
    if (x >= edges) {
      int& d = degree[patch.port_node[x - edges]];
      if (d == 2 || random() % 8 < few_ports) continue;
      ++d;
      ports[x - edges] = true;
    } else if (random() % 16 < keep) {
      const auto [u, v] = patch.edges[x];
      if (degree[u] == 2 || degree[v] == 2 || !strands.unite(u, v)) continue;
      ++degree[u];
      ++degree[v];
      inner[x] = true;
    }
  }
}

// The largest words, and strings that cross word boundaries.
TEST(Key, RandomLargeConfigurations) {
  std::mt19937_64 random(20260101);
  for (int run = 0; run < 4000; ++run) {
    const std::size_t k = run % 2 == 0 ? 55 + random() % (max_word_valence - 54) : 60 + random() % 140;
    const exact::FanOperation operation = exact::random_operation(random, k);
    SCOPED_TRACE(operation.text() + ", run " + std::to_string(run));
    const naive::Patch patch = operation.patch();
    naive::Bits inner;
    naive::Bits ports;
    color_at_random(patch, random, inner, ports);
    const naive::Analysis truth = naive::analyze(patch, inner, ports);
    ASSERT_TRUE(truth.valid);
    const naive::Pairs expected = naive::pairs_of(patch, ports, naive::key_of(patch, ports, truth.joined));
    const std::vector<Word> inner_words = naive::words_of(inner);
    const std::vector<Word> port_words = naive::words_of(ports);
    const BitSpan in{inner_words.data()};
    const BitSpan p{port_words.data()};
    std::vector<Word> out(words_for(k), ~Word{0});
    operation.after().joined(in, p, MutableBitSpan{out.data()});
    EXPECT_TRUE(operation.after().valid(in, p));
    EXPECT_EQ(naive::pairs_of(patch, ports, naive::bits_from(out, k)), expected);
    if (k > max_word_valence) continue;
    const Word m = naive::mask_of(inner);
    const Word q = naive::mask_of(ports);
    EXPECT_TRUE(operation.after().valid(m, q));
    EXPECT_EQ(naive::pairs_of(patch, ports, naive::bits_of(operation.after().joined(m, q), k)), expected);
  }
}

}  // namespace
}  // namespace restrip
