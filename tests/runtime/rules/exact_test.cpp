// Claim: restrip::exact returns a sound recolouring, and none is better. Proved by exhaustion for every key and every
// position, valence by valence, against graphs with union-find.
//
// RESTRIP_EXHAUSTIVE=1 in the environment goes on to k = 12.
#include "restrip/rules/exact.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

#include "exhaustive_search.hpp"
#include "naive_patch.hpp"

namespace restrip::exact {
namespace {

// Answers at compile time. A square without ports becomes one strand of six triangles.
static_assert(best_split(4, 2, 0, 0).value == Value{5, 0});
static_assert(best_collapse(4, 0b1111, 0b0101).value == Value{2, 0});
static_assert(best_collapse(3, 0, 0).value == Value{2, 0});
static_assert(best_fan_collapse(1, 0, 0).value == Value{0, 1});
static_assert(noexcept(best_split(4, 2, Word{0}, Word{0})));

naive::Merit merit_of(const Value& value) { return {value.solid, value.isolated}; }

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
        if (!judged || *judged != merit_of(best.value) || *judged != search.best(joined)) {
          ADD_FAILURE() << "k " << k << " ports " << ports << " joined " << given << " colors " << best.colors
                        << " solid " << best.value.solid << " isolated " << best.value.isolated
                        << (judged ? "" : ", not sound") << "; best is " << search.best(joined).solid << ", "
                        << search.best(joined).isolated;
          return;
        }
      }
      if (given == 0) break;
    }
  }
  // Each triangle has no port, or one that is joined, or one that is not; but see `meaningful`.
  std::size_t words = 1;
  for (std::size_t i = 0; i < k; ++i) words *= 3;
  EXPECT_EQ(keys, patch.cyclic ? words - k : (words + 1) / 2);
}

TEST(Exact, Split) {
  for (std::size_t k = 2; k <= largest(); ++k) {
    for (std::size_t a = 1; a < k; ++a) {
      SCOPED_TRACE(a);
      check_all_keys(naive::ring_with_chord(k, a), [&](Word p, Word j) { return best_split(k, a, p, j); });
    }
  }
}

TEST(Exact, Collapse) {
  for (std::size_t k = 3; k <= largest(); ++k) {
    check_all_keys(naive::closed_fan(k), [&](Word p, Word j) { return best_collapse(k, p, j); });
  }
}

TEST(Exact, OpenSplit) {
  for (std::size_t k = 1; k <= largest(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = i + 1; j <= k; ++j) {
        SCOPED_TRACE(testing::Message() << "gaps " << i << " " << j);
        check_all_keys(naive::path_with_chord(k, i, j), [&](Word p, Word q) { return best_open_split(k, i, j, p, q); });
      }
    }
  }
}

TEST(Exact, BoundarySplit) {
  for (std::size_t k = 1; k <= largest(); ++k) {
    for (std::size_t i = 0; i <= k; ++i) {
      SCOPED_TRACE(i);
      check_all_keys(naive::path(k, i), [&](Word p, Word j) { return best_boundary_split(k, i, p, j); });
    }
  }
}

TEST(Exact, FanCollapse) {
  for (std::size_t k = 1; k <= largest(); ++k) {
    check_all_keys(naive::open_fan(k), [&](Word p, Word j) { return best_fan_collapse(k, p, j); });
  }
}

// From colours to colours: for every valid configuration the answer to its key is best among the recolourings that join
// no pair but the configuration's own, whatever those pairs are. This needs no faith in keys.
template <class KeyOf, class Answer>
void check_all_configurations(const naive::Patch& before, const naive::Patch& after, KeyOf key_of, Answer answer) {
  const std::size_t k = before.port_node.size();
  for (Word ports = 0; ports < (Word{1} << k); ++ports) {
    const naive::Bits port_bits = naive::bits_of(ports, k);
    std::vector<naive::Analysis> recolorings;
    for (Word inner = 0; inner < (Word{1} << after.edges.size()); ++inner) {
      recolorings.push_back(naive::analyze(after, naive::bits_of(inner, after.edges.size()), port_bits));
    }
    for (Word inner = 0; inner < (Word{1} << before.edges.size()); ++inner) {
      const naive::Analysis now = naive::analyze(before, naive::bits_of(inner, before.edges.size()), port_bits);
      if (!now.valid) continue;
      naive::Merit best;
      for (const naive::Analysis& next : recolorings) {
        const naive::Merit merit{next.solid, next.isolated};
        if (next.valid && naive::better(merit, best) && naive::subset(next.joined, now.joined)) best = merit;
      }
      const Recoloring found = answer(ports, key_of(inner, ports));
      const naive::Analysis& next = recolorings.at(found.colors);
      ASSERT_TRUE(next.valid && naive::subset(next.joined, now.joined)) << "inner " << inner << " ports " << ports;
      ASSERT_EQ(merit_of(found.value), (naive::Merit{next.solid, next.isolated}))
          << "inner " << inner << " ports " << ports;
      ASSERT_EQ(merit_of(found.value), best) << "inner " << inner << " ports " << ports;
    }
  }
}

TEST(Exact, EveryClosedConfiguration) {
  for (std::size_t k = 3; k <= 6; ++k) {
    for (std::size_t a = 1; a < k; ++a) {
      SCOPED_TRACE(testing::Message() << "k " << k << " a " << a);
      const naive::Patch fan = naive::closed_fan(k);
      const naive::Patch ring = naive::ring_with_chord(k, a);
      check_all_configurations(
          fan, ring, [&](Word loop, Word ports) { return joined_closed(k, loop, ports); },
          [&](Word ports, Word joined) { return best_split(k, a, ports, joined); });
      check_all_configurations(
          ring, fan, [&](Word inner, Word ports) { return joined_ring(k, a, inner, ports); },
          [&](Word ports, Word joined) { return best_collapse(k, ports, joined); });
    }
  }
}

TEST(Exact, EveryOpenConfiguration) {
  for (std::size_t k = 1; k <= 5; ++k) {
    const naive::Patch fan = naive::open_fan(k);
    for (std::size_t i = 0; i <= k; ++i) {
      SCOPED_TRACE(testing::Message() << "k " << k << " gap " << i);
      check_all_configurations(
          fan, naive::path(k, i), [&](Word loop, Word ports) { return joined_open(k, loop, ports); },
          [&](Word ports, Word joined) { return best_boundary_split(k, i, ports, joined); });
      check_all_configurations(
          naive::path(k, i), fan, [&](Word inner, Word ports) { return joined_path(k, i, inner, ports); },
          [&](Word ports, Word joined) { return best_fan_collapse(k, ports, joined); });
      for (std::size_t j = i + 1; j <= k; ++j) {
        SCOPED_TRACE(j);
        const naive::Patch with_chord = naive::path_with_chord(k, i, j);
        check_all_configurations(
            fan, with_chord, [&](Word loop, Word ports) { return joined_open(k, loop, ports); },
            [&](Word ports, Word joined) { return best_open_split(k, i, j, ports, joined); });
        check_all_configurations(
            with_chord, fan, [&](Word inner, Word ports) { return joined_path_with_chord(k, i, j, inner, ports); },
            [&](Word ports, Word joined) { return best_fan_collapse(k, ports, joined); });
      }
    }
  }
}

}  // namespace
}  // namespace restrip::exact
