// The key of every configuration, and its validity, against graphs with union-find; masks and bit strings alike.
#include "restrip/rules/key.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "naive_patch.hpp"

namespace restrip {
namespace {

// t_3 enters through its port, runs e_3 (round to t_0), e_0, and leaves at t_1.
static_assert(joined_closed(4, 0b1001, 0b1010) == 0b0010);
static_assert(canonical_joined(0b1010, 0b0010) == 0b1010);
static_assert(joined_open(4, 0b011, 0b0101) == 0b0100);
static_assert(valid_closed(4, 0b0111, 0b1001) && !valid_closed(4, 0b1111, 0) && !valid_closed(4, 0b0011, 0b0010));
static_assert(!valid_closed(4, 0b10000, 0) && !valid_closed(4, 0, 0b10000));
static_assert(valid_open(4, 0b111, 0b1001) && !valid_open(4, 0b1000, 0));

constexpr std::size_t largest = 7;

// Counts the valid configurations of one patch, after comparing each with the naive answer. The callables take masks,
// and words of any number.
template <class JoinedMask, class ValidMask, class JoinedBits, class ValidBits>
int compare_all(const naive::Patch& patch, JoinedMask joined_mask, ValidMask valid_mask, JoinedBits joined_bits,
                ValidBits valid_bits) {
  const std::size_t k = patch.port_node.size();
  int valid = 0;
  for (Word ports = 0; ports < (Word{1} << k); ++ports) {
    for (Word inner = 0; inner < (Word{1} << patch.edges.size()); ++inner) {
      const naive::Bits port_bits = naive::bits_of(ports, k);
      const naive::Bits inner_bits = naive::bits_of(inner, patch.edges.size());
      const naive::Analysis truth = naive::analyze(patch, inner_bits, port_bits);
      const std::vector<Word> port_words = naive::words_of(port_bits);
      const std::vector<Word> inner_words = naive::words_of(inner_bits);
      Word joined_word = ~Word{0};
      joined_bits(BitSpan{inner_words.data()}, BitSpan{port_words.data()}, MutableBitSpan::of(joined_word));
      EXPECT_EQ(joined_word & ~ports, 0U);
      EXPECT_EQ(joined_mask(inner, ports) & ~ports, 0U);
      EXPECT_EQ(valid_mask(inner, ports), truth.valid) << "inner " << inner << " ports " << ports;
      EXPECT_EQ(valid_bits(BitSpan{inner_words.data()}, BitSpan{port_words.data()}), truth.valid);
      if (!truth.valid) continue;
      ++valid;
      const Word expected = naive::mask_of(naive::key_of(patch, port_bits, truth.joined));
      const auto canonical = [&](Word joined) { return patch.cyclic ? canonical_joined(ports, joined) : joined; };
      EXPECT_EQ(canonical(joined_mask(inner, ports)), expected) << "inner " << inner << " ports " << ports;
      EXPECT_EQ(canonical(joined_word), expected) << "inner " << inner << " ports " << ports;
    }
  }
  return valid;
}

TEST(Key, ClosedFan) {
  const int valid_of[] = {44, 160, 572, 2040, 7268};  // k = 3 ... 7
  for (std::size_t k = 3; k <= largest; ++k) {
    EXPECT_EQ(compare_all(
                  naive::closed_fan(k), [&](Word loop, Word ports) { return joined_closed(k, loop, ports); },
                  [&](Word loop, Word ports) { return valid_closed(k, loop, ports); },
                  [&](BitSpan loop, BitSpan ports, MutableBitSpan out) { joined_closed(k, loop, ports, out); },
                  [&](BitSpan loop, BitSpan ports) { return valid_closed(k, loop, ports); }),
              valid_of[k - 3]);
  }
}

TEST(Key, OpenFan) {
  for (std::size_t k = 1; k <= largest; ++k) {
    compare_all(
        naive::open_fan(k), [&](Word loop, Word ports) { return joined_open(k, loop, ports); },
        [&](Word loop, Word ports) { return valid_open(k, loop, ports); },
        [&](BitSpan loop, BitSpan ports, MutableBitSpan out) { joined_open(k, loop, ports, out); },
        [&](BitSpan loop, BitSpan ports) { return valid_open(k, loop, ports); });
  }
}

TEST(Key, RingWithChord) {
  // By (k, a), 1 <= a <= k/2: the figures of docs/explanation/theory.md for collapses.
  const std::vector<std::vector<int>> valid_of = {
      {278}, {998, 1016}, {3562, 3640}, {12694, 12988, 13032}, {45218, 46280, 46492}};
  for (std::size_t k = 3; k <= largest; ++k) {
    for (std::size_t a = 1; a < k; ++a) {
      const int valid = compare_all(
          naive::ring_with_chord(k, a), [&](Word inner, Word ports) { return joined_ring(k, a, inner, ports); },
          [&](Word inner, Word ports) { return valid_ring(k, a, inner, ports); },
          [&](BitSpan inner, BitSpan ports, MutableBitSpan out) { joined_ring(k, a, inner, ports, out); },
          [&](BitSpan inner, BitSpan ports) { return valid_ring(k, a, inner, ports); });
      EXPECT_EQ(valid, valid_of[k - 3][(a <= k / 2 ? a : k - a) - 1]) << "k " << k << " a " << a;
    }
  }
}

TEST(Key, PathWithChord) {
  for (std::size_t k = 1; k < largest; ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = i + 1; j <= k; ++j) {
        compare_all(
            naive::path_with_chord(k, i, j),
            [&](Word inner, Word ports) { return joined_path_with_chord(k, i, j, inner, ports); },
            [&](Word inner, Word ports) { return valid_path_with_chord(k, i, j, inner, ports); },
            [&](BitSpan inner, BitSpan ports, MutableBitSpan out) {
              joined_path_with_chord(k, i, j, inner, ports, out);
            },
            [&](BitSpan inner, BitSpan ports) { return valid_path_with_chord(k, i, j, inner, ports); });
      }
    }
  }
}

TEST(Key, Path) {
  for (std::size_t k = 1; k <= largest; ++k) {
    for (std::size_t i = 0; i <= k; ++i) {
      compare_all(
          naive::path(k, i), [&](Word inner, Word ports) { return joined_path(k, i, inner, ports); },
          [&](Word inner, Word ports) { return valid_path(k, i, inner, ports); },
          [&](BitSpan inner, BitSpan ports, MutableBitSpan out) { joined_path(k, i, inner, ports, out); },
          [&](BitSpan inner, BitSpan ports) { return valid_path(k, i, inner, ports); });
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
    const std::size_t i = random() % k;
    const std::size_t j = i + 1 + random() % (k - i);
    const std::size_t a = 1 + random() % (k - 1);
    // The colours of one patch, as spans and, if they fit, as words: joined(colors…) and valid(colors…) for both.
    const auto check = [&](const char* family, const naive::Patch& patch, const auto& joined, const auto& valid) {
      SCOPED_TRACE("k " + std::to_string(k) + ", " + family + ", run " + std::to_string(run));
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
      joined(in, p, MutableBitSpan{out.data()});
      EXPECT_TRUE(valid(in, p));
      EXPECT_EQ(naive::pairs_of(patch, ports, naive::bits_from(out, k)), expected);
      if (k > max_word_valence) return;
      const Word m = naive::mask_of(inner);
      const Word q = naive::mask_of(ports);
      EXPECT_TRUE(valid(m, q));
      EXPECT_EQ(naive::pairs_of(patch, ports, naive::bits_of(joined(m, q), k)), expected);
    };
    switch (random() % 5) {
      case 0:
        check(
            "closed fan", naive::closed_fan(k), [&](auto... colors) { return joined_closed(k, colors...); },
            [&](auto... colors) { return valid_closed(k, colors...); });
        break;
      case 1:
        check(
            "open fan", naive::open_fan(k), [&](auto... colors) { return joined_open(k, colors...); },
            [&](auto... colors) { return valid_open(k, colors...); });
        break;
      case 2:
        check(
            "ring with chord", naive::ring_with_chord(k, a),
            [&](auto... colors) { return joined_ring(k, a, colors...); },
            [&](auto... colors) { return valid_ring(k, a, colors...); });
        break;
      case 3:
        check(
            "path with chord", naive::path_with_chord(k, i, j),
            [&](auto... colors) { return joined_path_with_chord(k, i, j, colors...); },
            [&](auto... colors) { return valid_path_with_chord(k, i, j, colors...); });
        break;
      default:
        check(
            "path", naive::path(k, i), [&](auto... colors) { return joined_path(k, i, colors...); },
            [&](auto... colors) { return valid_path(k, i, colors...); });
    }
  }
}

}  // namespace
}  // namespace restrip
