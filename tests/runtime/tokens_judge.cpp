// Asks the look-ups, the keys, the automaton and the tables of operations whatever they can be asked, and prints a
// digest of each kind of answer: what tokens.py compares. The automaton in which swaps have a price is asked instead
// where one is first on the include path.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "restrip/rules/rules.hpp"
#include "restrip/tables/linked.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_matching.hpp"

namespace {

using namespace restrip;

using Sizes = std::initializer_list<std::size_t>;

class Digest {
 public:
  explicit Digest(const char* name) : name_(name) {}
  ~Digest() { std::printf("%s %016llx\n", name_, static_cast<unsigned long long>(sum_)); }
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  template <class Number>
  void add(Number number) {
    sum_ = sum_ * 1000003 + static_cast<std::uint64_t>(number);
  }
  void add(const Rule& rule) {
    add(rule.colors);
    add(rule.strips);
    add(rule.valid);
  }
  void add(const exact::Recoloring& found) {
    add(found.colors);
    add(found.value);
  }
  void add(const exact::Value& value) {
    add(value.solid);
    add(value.isolated);
  }
  void add(const detail::InnerPairs& pairs) {
    add(pairs.joined);
    add(pairs.over_chord);
    add(pairs.count());
  }
  void add(const tables::OperationRule& rule) {
    add(rule.colors);
    add(rule.ports);
    add(rule.strips);
    add(rule.valid);
  }
  void add(const std::vector<Word>& words) {
    for (const Word word : words) add(word);
  }

 private:
  const char* name_;
  std::uint64_t sum_ = 0;
};

std::mt19937_64 numbers(8);

/// Few bits as often as many.
Word some_bits(std::size_t n) {
  const Word mask = numbers() % 3 == 0 ? numbers() & numbers() : numbers() % 2 == 0 ? numbers() | numbers() : numbers();
  return mask & low_bits(n);
}

std::vector<Word> long_bits(std::size_t n) {
  std::vector<Word> words(words_for(n) + 1);
  for (std::size_t i = 0; i < n; ++i)
    if (numbers() % 3 != 0) words[i / word_bits] |= bit(i % word_bits);
  if (numbers() % 4 == 0)  // few
    for (std::size_t i = 0; i < n; ++i)
      if (numbers() % 16 != 0) words[i / word_bits] &= ~bit(i % word_bits);
  return words;
}

/// Calls with every position of fans of k triangles: closed(a), open(i, j), gap(i).
template <class Closed, class Open, class Gap>
void each_position(std::size_t k, Closed&& closed, Open&& open, Gap&& gap) {
  for (std::size_t a = 1; k > 2 && a < k; ++a) closed(a);
  for (std::size_t j = 1; j <= k; ++j)
    for (std::size_t i = 0; i < j; ++i) open(i, j);
  for (std::size_t i = 0; i <= k; ++i) gap(i);
}

void rules_of(Digest& told, std::size_t k, Word colors, Word ports) {
  each_position(
      k,
      [&](std::size_t a) {
        told.add(split_rule({k, a}, colors, ports));
        told.add(collapse_rule({k, a}, colors, ports));
      },
      [&](std::size_t i, std::size_t j) {
        told.add(open_split_rule({k, i, j}, colors, ports));
        told.add(open_collapse_rule({k, i, j}, colors, ports));
      },
      [&](std::size_t i) {
        told.add(boundary_split_rule({k, i}, colors, ports));
        told.add(boundary_collapse_rule({k, i}, colors, ports));
      });
}

/// Sparse colours are valid often enough in large fans.
void rules() {
  Digest told("rules");
  for (std::size_t k = 1; k <= 5; ++k)
    for (Word colors = 0; colors < bit(k + 4); ++colors)
      for (Word ports = 0; ports < bit(k + 1); ++ports) rules_of(told, k, colors, ports);
  for (const std::size_t k : Sizes{6, 7, 8, 9, 13, 31, 32, 33, 60, 61})
    for (int n = 0; n < (k < 10 ? 3000 : 60); ++n) rules_of(told, k, some_bits(k + 3) & some_bits(k + 3), some_bits(k));
  for (const bool inner : {false, true})
    for (unsigned ports = 0; ports < 32; ++ports) {
      const FlipRule rule = flip_rule(inner, ports);
      for (const int part : {int{rule.inner}, static_cast<int>(rule.ports), rule.strips, int{rule.valid}})
        told.add(part);
    }
}

void keys_of(Digest& told, const detail::Layout& patch, Word colors, Word ports) {
  told.add(detail::valid(patch, colors, ports));
  if (((colors >> patch.colors()) | (ports >> patch.k)) != 0) return;
  told.add(detail::inner_pairs(patch, colors, ports));
  told.add(detail::isolated(patch, colors, ports));
  told.add(detail::isolated(patch, BitSpan::of(colors), BitSpan::of(ports)));
}

void keys() {
  Digest told("keys");
  Word joined = 0;
  const MutableBitSpan to = MutableBitSpan::of(joined);
  for (const std::size_t k : Sizes{1, 2, 3, 4, 5, 8, 12, 30, 59, 61})
    for (std::size_t n = 0; n < (k < 6 ? 400 : 80); ++n) {
      const Word colors = some_bits(k + 4 - n % 2);
      const Word ports = some_bits(k + (n % 8 == 0 ? 1 : 0));
      const BitSpan c = BitSpan::of(colors);
      const BitSpan p = BitSpan::of(ports);
      if (k > 2) {
        told.add(valid_closed(k, colors, ports));
        told.add(valid_closed(k, c, p));
        joined_closed(k, c, p, to);
        told.add(joined);
        told.add(joined_closed(k, colors & low_bits(k), ports & low_bits(k)));
        told.add(detail::isolated_closed(k, colors, ports));
        told.add(detail::ends_closed(k, colors, ports));
      }
      keys_of(told, detail::closed_fan(k), colors, ports);
      keys_of(told, detail::open_fan(k), colors, ports);
      told.add(valid_open(k, colors, ports));
      told.add(valid_open(k, c, p));
      joined_open(k, c, p, to);
      told.add(joined);
      told.add(joined_open(k, colors, ports));
      told.add(canonical_joined(ports, joined));
      each_position(
          k,
          [&](std::size_t a) {
            keys_of(told, detail::ring_with_chord(k, a), colors, ports);
            told.add(valid_ring(k, a, colors, ports));
            told.add(valid_ring(k, a, c, p));
            told.add(joined_ring(k, a, colors, ports));
            told.add(detail::ring_pairs(k, a, colors, ports));
            joined_ring(k, a, c, p, to);
            told.add(joined);
            told.add(detail::isolated_ring(k, a, colors, ports));
            told.add(detail::ends_ring(k, a, colors, ports));
          },
          [&](std::size_t i, std::size_t j) {
            if (k > 12 && (i + j) % 7 != 0) return;
            keys_of(told, detail::path_with_chord(k, i, j), colors, ports);
            told.add(valid_path_with_chord(k, i, j, colors, ports));
            told.add(valid_path_with_chord(k, i, j, c, p));
            told.add(joined_path_with_chord(k, i, j, colors, ports));
            joined_path_with_chord(k, i, j, c, p, to);
            told.add(joined);
          },
          [&](std::size_t i) {
            keys_of(told, detail::path(k, i), colors, ports);
            told.add(valid_path(k, i, colors, ports));
            told.add(valid_path(k, i, c, p));
            told.add(joined_path(k, i, colors, ports));
            joined_path(k, i, c, p, to);
            told.add(joined);
          });
    }
  for (const std::size_t k : Sizes{64, 65, 130})
    for (int n = 0; n < 20; ++n) {
      const std::vector<Word> colors = long_bits(k + 3);
      const std::vector<Word> ports = long_bits(k);
      const BitSpan c{colors.data()};
      const BitSpan p{ports.data()};
      std::vector<Word> pairs(words_for(k));
      const MutableBitSpan pairs_to{pairs.data()};
      told.add(valid_ring(k, k / 2, c, p));
      joined_ring(k, k / 2, c, p, pairs_to);
      told.add(pairs);
      told.add(valid_path_with_chord(k, k / 3, k, c, p));
      joined_path_with_chord(k, k / 3, k, c, p, pairs_to);
      told.add(pairs);
      told.add(p.first_set(0, k));
      told.add(p.first_set(k / 2, k - 1));
      told.add(p.first_set(k, k));
    }
}

/// Every key and position of small fans, some of large ones; on words and on bit strings.
void automaton() {
  Digest told("automaton");
  const auto ask = [&](std::size_t k, Word ports, Word joined, exact::Turns turns) {
    const BitSpan p = BitSpan::of(ports);
    const BitSpan j = BitSpan::of(joined);
    const exact::LongTurns long_turns{BitSpan::of(turns.left), BitSpan::of(turns.right)};
    Word colors = 0;
    const MutableBitSpan to = MutableBitSpan::of(colors);
    told.add(exact::best_collapse(k, ports, joined, turns));
    told.add(exact::best_collapse(k, p, j, to, long_turns));
    told.add(colors);
    told.add(exact::best_fan_collapse(k, ports, joined, turns));
    told.add(exact::best_fan_collapse(k, p, j, to, long_turns));
    told.add(colors);
    each_position(
        k,
        [&](std::size_t a) {
          told.add(exact::best_split(k, a, ports, joined, turns));
          told.add(exact::best_split(k, a, p, j, to, long_turns));
          told.add(colors);
        },
        [&](std::size_t from, std::size_t goal) {
          told.add(exact::best_open_split(k, from, goal, ports, joined, turns));
          told.add(exact::best_open_split(k, from, goal, p, j, to, long_turns));
          told.add(colors);
        },
        [&](std::size_t i) {
          told.add(exact::best_boundary_split(k, i, ports, joined, turns));
          told.add(exact::best_boundary_split(k, i, p, j, to, long_turns));
          told.add(colors);
        });
  };
  const auto some_turns = [](std::size_t k) {
    const Word left = tables::automaton.tells_turns ? some_bits(k) : 0;
    return exact::Turns{left, tables::automaton.tells_turns ? some_bits(k) & ~left : 0};
  };
  for (std::size_t k = 1; k <= 5; ++k)
    for (Word ports = 0; ports < bit(k); ++ports)
      for (Word joined = 0; joined < bit(k); ++joined) ask(k, ports, joined, some_turns(k));
  for (const std::size_t k : Sizes{8, 17, 61})
    for (int n = 0; n < (k < 10 ? 300 : 20); ++n) ask(k, some_bits(k), some_bits(k), some_turns(k));
  for (const std::size_t k : Sizes{63, 64, 65, 66, 130})
    for (int n = 0; n < 20; ++n) {
      const std::vector<Word> ports = long_bits(k);
      const std::vector<Word> joined = long_bits(k);
      std::vector<Word> colors(words_for(k + 3), ~Word{0});
      const BitSpan p{ports.data()};
      const BitSpan j{joined.data()};
      const MutableBitSpan to{colors.data()};
      const auto answer = [&](const exact::Value& value) {
        told.add(value);
        told.add(colors);
      };
      answer(exact::best_split(k, k / 2, p, j, to));
      answer(exact::best_collapse(k, p, j, to));
      answer(exact::best_open_split(k, k / 3, k - 1, p, j, to));
      answer(exact::best_boundary_split(k, k / 4, p, j, to));
      answer(exact::best_fan_collapse(k, p, j, to));
    }
}

void bits() {
  Digest told("bits");
  for (std::size_t n = 0; n <= 66; ++n) {
    told.add(bit(n));
    told.add(low_bits(n));
    told.add(words_for(n));
    const Word mask = numbers();
    const Word other = numbers() >> (n % 64);
    told.add(has(mask, n));
    told.add(insert_zero(mask, n));
    told.add(remove_bit(mask, n));
    told.add(count_bits(mask));
    told.add(count_difference(mask, other));
    told.add(count_difference(mask >> 32, other & 0xffffffffU));
    if (n <= 64) told.add(detail::reversed(mask & low_bits(n), n));
  }
}

/// What members hold of which nothing is said.
void defaults() {
  Digest told("defaults");
  told.add(Rule{});
  told.add(exact::Recoloring{});
  told.add(detail::InnerPairs{});
  told.add(tables::OperationRule{});
  const FlipRule flip;
  const SplitPosition split;
  const GapPair gaps;
  const Gap gap;
  const detail::Layout patch;
  const tables::FamilyPosition place;
  const tables::PositionTriangles triangles;
  const tables::PatchTriangle triangle;
  const LinkedRule linked;
  const tables::OperationTable<std::uint8_t, 1> table{};
  const tables::SurfaceOperation<std::uint8_t, 1, 1, 1> surface{};
  const tables::SurfaceFamily<std::uint8_t, 1, 1, 1, 1> family{};
  const tables::PositionTable<std::uint8_t> view;
  for (const std::size_t number :
       {static_cast<std::size_t>(flip.inner),
        std::size_t{flip.ports},
        static_cast<std::size_t>(flip.strips),
        static_cast<std::size_t>(flip.valid),
        split.k,
        split.a,
        gaps.k,
        gaps.i,
        gaps.j,
        gap.k,
        gap.i,
        patch.k,
        patch.inserted,
        patch.opposite,
        static_cast<std::size_t>(patch.ring),
        std::size_t{place.before.triangles},
        std::size_t{place.before.edges},
        std::size_t{place.ports},
        place.first,
        std::size_t{triangles.vertices},
        triangles.first_before,
        triangles.first_after,
        std::size_t{triangle.from},
        std::size_t{triangle.from_side},
        std::size_t{linked.recoloring},
        std::size_t{linked.pairing},
        std::size_t{table.ports},
        static_cast<std::size_t>(table.matching),
        std::size_t{surface.vertices},
        static_cast<std::size_t>(family.matching),
        std::size_t{view.ports},
        static_cast<std::size_t>(view.matching),
        std::size_t{view.vertices},
        static_cast<std::size_t>(BitSpan{}.words == nullptr),
        static_cast<std::size_t>(detail::LongLetters{}.pair),
        detail::LongLetters{}.first,
        static_cast<std::size_t>(detail::WordLetters{}.ports | detail::WordLetters{}.joined)})
    told.add(number);
}

void operations() {
  Digest told("operations");
  for (std::uint32_t inner = 0; inner < 2; ++inner)
    for (std::uint32_t ports = 0; ports < 16; ++ports) {
      told.add(tables::rule_of(tables::bisect, inner, ports));
      told.add(tables::rule_of(tables::bisect_matching, inner, ports));
    }
  const auto surface = [&](const auto& triangles) {
    for (const tables::PatchTriangle& one : triangles)
      for (const std::uint8_t side : one.side) told.add(tables::edge_of(side));
    for (std::uint64_t edges = 0; edges < 32; ++edges)
      told.add(tables::isolated_among(triangles, tables::patch_edges(static_cast<std::uint32_t>(edges & 7),
                                                                     static_cast<std::uint32_t>(edges >> 3))));
  };
  surface(tables::bisect.triangles_before);
  surface(tables::bisect.triangles_after);
  told.add(tables::edge_of(tables::PatchTriangle::port_side + 31));
  told.add(tables::edge_of(tables::PatchTriangle::boundary_side));

  // Two positions of a family: bisect twice, the second one behind some entries that are never read.
  tables::SurfaceFamily<std::uint16_t, 67, 2, 4, 8> family{};
  for (std::size_t place = 0; place < 2; ++place) {
    const std::size_t first = 35 * place;
    std::copy(tables::bisect.entries.begin(), tables::bisect.entries.end(), family.entries.begin() + first);
    family.positions[place] = {
        {static_cast<unsigned>(3 + place), 1, 0}, tables::bisect.before, tables::bisect.after, 4, first};
    family.position_triangles[place] = {5, 2 * place, 4 * place};
    std::copy(tables::bisect.triangles_before.begin(), tables::bisect.triangles_before.end(),
              family.triangles_before.begin() + 2 * place);
    std::copy(tables::bisect.triangles_after.begin(), tables::bisect.triangles_after.end(),
              family.triangles_after.begin() + 4 * place);
  }
  for (const bool matching : {false, true}) {
    family.matching = matching;
    for (const tables::FamilyNumbers& at :
         {tables::FamilyNumbers{3, 1, 0}, {4, 1, 0}, {4, 2, 0}, {2, 1, 0}, {3, 1, 1}, {9, 0, 0}}) {
      told.add(tables::place_of(family, at));
      const auto table = tables::position_of(family, at);
      told.add(table.vertices);
      for (std::uint32_t inner = 0; inner < 2; ++inner)
        for (std::uint32_t ports = 0; ports < 16; ++ports) {
          told.add(tables::rule_of(family, at, inner, ports));
          told.add(tables::rule_of(table, inner, ports));
        }
      surface(table.triangles_before);
      surface(table.triangles_after);
    }
  }
}

}  // namespace

int main() {
  if (tables::automaton.tells_turns) {
    automaton();
    return 0;
  }
  bits();
  defaults();
  rules();
  keys();
  automaton();
  operations();
  return 0;
}
