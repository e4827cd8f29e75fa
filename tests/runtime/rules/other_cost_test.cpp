// Claim: with an automaton of another cost, in which swaps have a price, restrip::exact returns a sound recolouring,
// and none costs less. For small valences by trying all recolourings, for every key, every way in which strips may go
// on behind the ports, and every position; for valences up to 1,000 by a second search. Both count swaps by the corners
// of the triangles. The automaton is made in the build, of the weights RESTRIP_TEST_WEIGHTS.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fan_operation.hpp"
#include "naive_turns.hpp"

// The least cost of a recolouring for patches too large to look at every colouring, where swaps have a price.
// Walks along the row of nodes and keeps, for every different way in which the strands so far hang together and turn,
// the least cost.
namespace naive {

class TurnFrontier {
 public:
  TurnFrontier(const TurnPatch& patch, const Bits& ports, const Bits& joined, Behind behind, Weights weights)
      : patch_(patch),
        ports_(ports),
        behind_(std::move(behind)),
        weights_(weights),
        allowed_(pairs_of(patch.graph, ports, joined)) {}

  int least() const {
    const Patch& graph = patch_.graph;
    const bool chord = graph.edges.size() > graph.nodes - (graph.cyclic ? 0 : 1);
    std::optional<int> result;
    for (int use_closing = 0; use_closing <= (graph.cyclic ? 1 : 0); ++use_closing) {
      for (int use_chord = 0; use_chord <= (chord ? 1 : 0); ++use_chord) {
        const auto least = least_with(use_closing != 0, use_chord != 0);
        if (least && (!result || *least < *result)) result = least;
      }
    }
    return result.value();
  }

 private:
  // The halves of edges that wait for their node: the edge to the next node of the row, the chord at A and at D, the
  // edge that closes a ring at the first node and at the last.
  enum Half : int { row_edge, chord_a, chord_d, closing_first, closing_last, halves };
  static constexpr std::size_t at(Half half) { return static_cast<std::size_t>(half); }
  static constexpr int absent = -1;   // no such half
  static constexpr int nothing = -2;  // a node where the strand ends
  static constexpr int first_port = 100;

  // What a half's strand leads to at its other end: another half, one of the above, or a port; and the corner about
  // which the strip passes the triangle on the other side of the half's edge, once it is known.
  struct State {
    std::array<int, halves> end;
    std::array<Corner, halves> corner;
    friend auto operator<=>(const State&, const State&) = default;
  };

  std::optional<int> least_with(bool closing, bool chord) const {
    const Patch& graph = patch_.graph;
    State start;
    start.end.fill(absent);
    start.corner.fill(no_corner);
    int base = weights_.restart * static_cast<int>(graph.nodes);
    const auto begin = [&](Half one, Half other) {
      start.end[at(one)] = other;
      start.end[at(other)] = one;
      base -= weights_.restart;
    };
    if (closing) begin(closing_first, closing_last);
    if (chord) begin(chord_a, chord_d);
    std::map<State, int> states{{start, base}};
    std::size_t port = 0;
    for (std::size_t node = 0; node < graph.nodes; ++node) {
      std::map<State, int> next;
      const bool has_port = port < graph.port_node.size() && graph.port_node[port] == node;
      for (const auto& [state, cost] : states) {
        for (int onward = 0; onward <= (node + 1 < graph.nodes ? 1 : 0); ++onward) {
          step(state, cost, node, has_port && ports_[port] ? std::optional(port) : std::nullopt, onward != 0, chord,
               next);
        }
      }
      if (has_port) ++port;
      states.swap(next);
    }
    std::optional<int> result;
    for (const auto& entry : states) {
      if (!result || entry.second < *result) result = entry.second;
    }
    return result;
  }

  // Ties together all that meets at one node.
  void step(State state, int cost, std::size_t node, std::optional<std::size_t> port, bool onward, bool chord,
            std::map<State, int>& next) const {
    const Patch& graph = patch_.graph;
    struct Waiting {
      Half half;
      Half other;  // the half of the same edge that keeps the corner of this node; itself where nobody waits for it
      Edge edge;
    };
    std::vector<Waiting> here;
    if (state.end[row_edge] != absent) here.push_back({row_edge, row_edge, patch_.inner(node - 1)});
    if (chord && graph.edges.back().first == node)
      here.push_back({chord_a, chord_d, patch_.inner(graph.edges.size() - 1)});
    if (chord && graph.edges.back().second == node)
      here.push_back({chord_d, chord_d, patch_.inner(graph.edges.size() - 1)});
    if (node == 0 && state.end[closing_first] != absent)
      here.push_back({closing_first, closing_last, patch_.inner(graph.nodes - 1)});
    if (node + 1 == graph.nodes && state.end[closing_last] != absent)
      here.push_back({closing_last, closing_last, patch_.inner(graph.nodes - 1)});
    const std::size_t degree = here.size() + (port ? 1 : 0) + (onward ? 1 : 0);
    if (degree > 2) return;
    if (here.size() == 2 && state.end[at(here[0].half)] == here[1].half) return;  // a cycle

    Corner corner = no_corner;
    if (degree == 2) {
      std::vector<Edge> edges;
      edges.reserve(2);
      for (const Waiting& waiting : here) edges.push_back(waiting.edge);
      if (port) edges.push_back(patch_.ports[*port]);
      if (onward) edges.push_back(patch_.inner(node));
      corner = common(edges[0], edges[1]);
    }
    if (degree == 0) cost += weights_.isolated;
    if (port && corner != no_corner && corner == behind_[*port]) cost += weights_.swap;
    std::vector<int> ends;
    ends.reserve(2);
    for (const Waiting& waiting : here) {
      if (corner != no_corner && corner == state.corner[at(waiting.half)]) cost += weights_.swap;
      ends.push_back(state.end[at(waiting.half)]);
    }
    for (const Waiting& waiting : here) {
      state.end[at(waiting.half)] = absent;
      state.corner[at(waiting.half)] = no_corner;
    }
    for (const Waiting& waiting : here) {
      if (waiting.other != waiting.half) state.corner[at(waiting.other)] = corner;
    }
    if (port) ends.push_back(first_port + static_cast<int>(*port));
    if (onward) {
      if (ends.empty()) ends.push_back(nothing);
      state.end[row_edge] = ends[0];
      state.corner[row_edge] = corner;
      if (ends[0] >= 0 && ends[0] < halves) state.end[static_cast<std::size_t>(ends[0])] = row_edge;
      cost -= weights_.restart;
    } else {
      while (ends.size() < 2) ends.push_back(nothing);
      if (!tie(state, ends[0], ends[1]) || !tie(state, ends[1], ends[0])) return;
    }
    const auto [place, is_new] = next.emplace(state, cost);
    if (!is_new && cost < place->second) place->second = cost;
  }

  bool tie(State& state, int one, int two) const {
    if (one >= 0 && one < halves) state.end[static_cast<std::size_t>(one)] = two;
    if (one < first_port || two < first_port || one > two) return true;
    return allowed_.count({static_cast<std::size_t>(one - first_port), static_cast<std::size_t>(two - first_port)}) !=
           0;
  }

  const TurnPatch& patch_;
  Bits ports_;
  Behind behind_;
  Weights weights_;
  Pairs allowed_;
};

}  // namespace naive

namespace restrip::exact {
namespace {

static_assert(tables::automaton.tells_turns);
// Answers at compile time: three triangles in one strip.
static_assert(best_collapse(3, 0, 0).value == Value{2, 0});
static_assert(best_fan_collapse(1, 0, 0).value == Value{0, 1});

constexpr naive::Weights weights{RESTRIP_TEST_WEIGHTS};

std::vector<FanOperation> operations(std::size_t k) {
  std::vector<FanOperation> all;
  for (std::size_t a = 1; k >= 3 && a < k; ++a) all.push_back({0, k, a, 0});
  if (k >= 3) all.push_back({1, k, 0, 0});
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j <= k; ++j) all.push_back({2, k, i, j});
  }
  for (std::size_t i = 0; i <= k; ++i) all.push_back({3, k, i, 0});
  all.push_back({4, k, 0, 0});
  return all;
}

naive::Behind corners_of(const naive::TurnPatch& patch, const naive::Bits& left, const naive::Bits& right) {
  naive::Behind behind;
  for (std::size_t i = 0; i < left.size(); ++i) {
    behind.push_back(left[i] ? patch.ports[i][0] : right[i] ? patch.ports[i][1] : naive::no_corner);
  }
  return behind;
}

// A recolouring that is sound for some key with these ports.
struct Sound {
  Word needed = 0;  // bits of `joined`
  naive::Turned turned;
};

// Every key of one operation, in four steps: ports, what is behind them, what is joined. Returns the number of keys.
std::size_t check_all_keys(const FanOperation& operation) {
  const naive::TurnPatch patch = operation.patch();
  const std::size_t k = operation.k;
  const std::size_t colors = patch.graph.edges.size();
  std::size_t keys = 0;
  for (Word ports = 0; ports < bit(k); ++ports) {
    const naive::Bits port_bits = naive::bits_of(ports, k);
    std::vector<Sound> sounds;
    std::vector<int> number_of(std::size_t{1} << colors, -1);
    for (Word inner = 0; inner < bit(colors); ++inner) {
      const naive::Bits inner_bits = naive::bits_of(inner, colors);
      const naive::Analysis truth = naive::analyze(patch.graph, inner_bits, port_bits);
      if (!truth.valid) continue;
      const naive::Bits needed = naive::key_of(patch.graph, port_bits, truth.joined);
      if (!naive::subset(truth.joined, naive::pairs_of(patch.graph, port_bits, needed))) continue;
      number_of[inner] = static_cast<int>(sounds.size());
      sounds.push_back({naive::mask_of(needed), naive::turned(patch, inner_bits, port_bits, weights)});
    }
    for (Word left = ports;; left = (left - 1) & ports) {
      for (Word right = ports & ~left;; right = (right - 1) & ports & ~left) {
        const naive::Behind behind = corners_of(patch, naive::bits_of(left, k), naive::bits_of(right, k));
        std::vector<int> least(bit(k), std::numeric_limits<int>::max());
        std::vector<int> costs;
        for (const Sound& sound : sounds) {
          costs.push_back(sound.turned.with(behind, weights));
          least[sound.needed] = std::min(least[sound.needed], costs.back());
        }
        for (std::size_t i = 0; i < k; ++i) {
          for (Word joined = 0; joined < bit(k); ++joined) {
            if (has(joined, i)) least[joined] = std::min(least[joined], least[joined & ~bit(i)]);
          }
        }
        for (Word joined = ports;; joined = (joined - 1) & ports) {
          ++keys;
          // Of two ports in a ring either bit stands for the pair.
          const bool two = patch.graph.cyclic && count_bits(ports) == 2 && joined != 0;
          const Word meant = two ? ports : joined;
          const Recoloring best = operation.best(ports, joined, Turns{left, right});
          const int at = best.colors < number_of.size() ? number_of[best.colors] : -1;
          if (at < 0 || (sounds[static_cast<std::size_t>(at)].needed & ~meant) != 0 ||
              costs[static_cast<std::size_t>(at)] != least[meant]) {
            ADD_FAILURE() << operation.text() << " ports " << ports << " joined " << joined << " left " << left
                          << " right " << right << ": colors " << best.colors << ", best " << least[meant]
                          << (at < 0 ? ", not sound" : "");
            return keys;
          }
          if (joined == 0) break;
        }
        if (right == 0) break;
      }
      if (left == 0) break;
    }
  }
  return keys;
}

// An unoptimised build stops one earlier. RESTRIP_EXHAUSTIVE=1 in the environment continues to k = 7.
TEST(OtherCost, EveryKeyOfEveryPosition) {
#ifdef __OPTIMIZE__
  const std::size_t usual = 5;
#else
  const std::size_t usual = 4;
#endif
  const std::size_t largest = std::getenv("RESTRIP_EXHAUSTIVE") != nullptr ? 7 : usual;
  std::size_t words = 1;
  for (std::size_t k = 1; k <= largest; ++k) {
    words *= 7;  // a dashed port, or a solid one, joined or not, with one of three things behind it
    for (const FanOperation& operation : operations(k)) {
      EXPECT_EQ(check_all_keys(operation), words) << operation.text();
      if (testing::Test::HasFailure()) return;
    }
  }
}

void check_one(std::mt19937_64& random, std::size_t k) {
  const FanOperation operation = random_operation(random, k);
  const auto [ports, joined] = RandomKey(random, k);
  const naive::TurnPatch patch = operation.patch();
  const std::size_t colors = patch.graph.edges.size();
  // Strips that end or continue.
  const std::uint64_t left_of_8 = random() % 9;
  naive::Bits left(k);
  naive::Bits right(k);
  for (std::size_t x = 0; x < k; ++x) {
    left[x] = random() % 8 < left_of_8;
    right[x] = !left[x] && random() % 2 == 0;
  }
  SCOPED_TRACE(operation.text());
  const std::vector<Word> port_words = naive::words_of(ports);
  const std::vector<Word> joined_words = naive::words_of(joined);
  const std::vector<Word> left_words = naive::words_of(left);
  const std::vector<Word> right_words = naive::words_of(right);
  std::vector<Word> out(words_for(colors == 0 ? 1 : colors), 0);
  const Value value =
      operation.best(BitSpan{port_words.data()}, BitSpan{joined_words.data()}, MutableBitSpan{out.data()},
                     LongTurns{BitSpan{left_words.data()}, BitSpan{right_words.data()}});
  const naive::Bits inner = naive::bits_from(out, colors);
  const naive::Analysis truth = naive::analyze(patch.graph, inner, ports);
  ASSERT_TRUE(truth.valid);
  EXPECT_TRUE(naive::subset(truth.joined, naive::pairs_of(patch.graph, ports, joined)));
  const naive::Behind behind = corners_of(patch, left, right);
  EXPECT_EQ(value, (Value{truth.solid, truth.isolated}));
  EXPECT_EQ(naive::turned(patch, inner, ports, weights).with(behind, weights),
            naive::TurnFrontier(patch, ports, joined, behind, weights).least());
  if (k > max_word_valence) return;
  const Recoloring word =
      operation.best(naive::mask_of(ports), naive::mask_of(joined), Turns{naive::mask_of(left), naive::mask_of(right)});
  EXPECT_EQ(word.value, value);
  EXPECT_EQ(naive::bits_of(word.colors, colors), inner);
}

void check_many(std::uint64_t seed, int runs, std::size_t from, std::size_t to) {
  std::mt19937_64 random(seed);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " run " + std::to_string(run));
    ASSERT_NO_FATAL_FAILURE(check_one(random, from + random() % (to - from)));
    if (testing::Test::HasFailure()) return;
  }
}

// The second search is right where everything can be enumerated, or at least agrees.
TEST(OtherCost, Small) { check_many(20260111, 1500, 3, 13); }

TEST(OtherCost, AroundTheWordSize) { check_many(20260112, 250, 55, 70); }

TEST(OtherCost, Thousand) { check_many(20260113, 8, 1000, 1001); }

// A strip that continues behind the port in the direction that repeats an index is not left to repeat it for nothing.
TEST(OtherCost, SeesHowStripsTurnBehindPorts) {
  const Word left = best_collapse(4, 0b0001, 0, {0b0001, 0}).colors;
  const Word right = best_collapse(4, 0b0001, 0, {0, 0b0001}).colors;
  EXPECT_FALSE(has(left, 3));  // the link to the triangle before
  EXPECT_TRUE(has(left, 0));
  EXPECT_FALSE(has(right, 0));  // the link to the triangle behind
  EXPECT_TRUE(has(right, 3));
}

}  // namespace
}  // namespace restrip::exact
