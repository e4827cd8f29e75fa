// Claim: with the automaton of rows, best_row returns a sound recolouring of which none has fewer strips; of those none
// fewer isolated triangles and ports given up; of those none fewer ports given up. Every row with up to 6 ports and
// every key by all recolourings; rows of up to 300 triangles by a search along the row that knows each strand by its
// port. The automaton is made in the build.
#include "restrip/rules/row.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "restrip/tables/row_automaton.hpp"

namespace restrip::exact {
namespace {

constexpr Row hole(std::size_t k) { return {k - 2, true, true, 0}; }
// A triangle with three ports, all joined, keeps two of them.
static_assert(best_row<tables::row_automaton>(hole(3), 7, 7).value == RowValue{0, 0, 1});
static_assert(best_row<tables::row_automaton>(hole(5), 0, 0).value == RowValue{2, 0, 0});

/// In the order of preference, smaller is better; strips less what all recolourings have.
struct Criteria {
  int strips = 0;
  int isolated_and_given = 0;
  int given = 0;
  friend auto operator<=>(const Criteria&, const Criteria&) = default;
};
Criteria operator+(const Criteria& a, const Criteria& b) {
  return {a.strips + b.strips, a.isolated_and_given + b.isolated_and_given, a.given + b.given};
}
Criteria criteria_of(const RowValue& value) {
  return {value.given_up - value.solid, value.isolated + value.given_up, value.given_up};
}

/// A row with a key, by places.
struct KeyedRow {
  Row row;
  std::vector<bool> solid;
  std::vector<bool> joined;

  [[nodiscard]] std::size_t places() const { return solid.size(); }
  /// Its own place of a triangle.
  [[nodiscard]] std::size_t own(std::size_t triangle) const { return triangle + (row.front ? 1 : 0); }
  /// Whether two solid ports may be joined.
  [[nodiscard]] bool may_join(std::size_t one, std::size_t other) const {
    const auto follows = [&](std::size_t later, std::size_t earlier) {
      std::size_t at = later;
      do at = (at + places() - 1) % places();
      while (!solid[at]);
      return at == earlier;
    };
    const bool two = std::count(solid.begin(), solid.end(), true) == 2;
    return (follows(other, one) && (joined[other] || (two && joined[one]))) ||
           (follows(one, other) && (joined[one] || (two && joined[other])));
  }
};

/// What a recolouring is worth, found on the triangles and their ports; nothing when it is not sound.
std::optional<Criteria> worth(const KeyedRow& key, const std::vector<bool>& links, const std::vector<bool>& kept) {
  const std::size_t n = key.row.triangles;
  std::vector<std::vector<std::size_t>> ports(n);
  for (std::size_t i = 0; i < n; ++i)
    if (kept[key.own(i)]) ports[i].push_back(key.own(i));
  if (key.row.front && kept.front()) ports.front().push_back(0);
  if (key.row.back && kept.back()) ports.back().push_back(key.places() - 1);
  Criteria found;
  for (std::size_t place = 0; place < key.places(); ++place) {
    if (kept[place] && !key.solid[place]) return {};
    if (key.solid[place] && !kept[place]) found = found + Criteria{1, 1, 1};
  }
  std::vector<std::size_t> strip;  // the ports of the present one
  for (std::size_t i = 0; i < n; ++i) {
    const bool left = i > 0 && links[i - 1];
    const bool right = i + 1 < n && links[i];
    const std::size_t degree = ports[i].size() + (left ? 1 : 0) + (right ? 1 : 0);
    if (degree > 2) return {};
    if (degree == 0) ++found.isolated_and_given;
    if (right) --found.strips;
    if (!left) strip.clear();
    strip.insert(strip.end(), ports[i].begin(), ports[i].end());
    for (std::size_t a = 0; a < strip.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (!key.may_join(strip[a], strip[b])) return {};
  }
  return found;
}

/// Asks the automaton by bit strings, and checks what it says of its answer.
Criteria answer(const KeyedRow& key) {
  const std::size_t ports = key.places();
  std::vector<Word> solid(words_for(ports));
  std::vector<Word> joined(words_for(ports));
  std::vector<Word> colors(words_for(ports), ~Word{0});
  std::vector<Word> kept(words_for(ports), ~Word{0});
  for (std::size_t place = 0; place < ports; ++place) {
    if (key.solid[place]) MutableBitSpan{solid.data()}.set(key.row.port(place));
    if (key.joined[place]) MutableBitSpan{joined.data()}.set(key.row.port(place));
  }
  const RowValue value = best_row<tables::row_automaton>(key.row, BitSpan{solid.data()}, BitSpan{joined.data()},
                                                         MutableBitSpan{colors.data()}, MutableBitSpan{kept.data()});
  std::vector<bool> links;
  for (std::size_t i = 0; i + 1 < key.row.triangles; ++i) links.push_back(BitSpan{colors.data()}[i]);
  std::vector<bool> kept_places;
  for (std::size_t place = 0; place < ports; ++place) kept_places.push_back(BitSpan{kept.data()}[key.row.port(place)]);
  const auto found = worth(key, links, kept_places);
  EXPECT_TRUE(found.has_value());
  EXPECT_TRUE(found == criteria_of(value));
  if (ports > word_bits) return criteria_of(value);
  const RowRecoloring word = best_row<tables::row_automaton>(key.row, solid[0], joined[0]);
  EXPECT_EQ(word.value, value);
  EXPECT_EQ(word.kept, kept[0]);
  EXPECT_EQ(word.colors, links.empty() ? 0 : colors[0]);
  return criteria_of(value);
}

std::vector<bool> bits_of(Word mask, std::size_t n) {
  std::vector<bool> bits;
  for (std::size_t i = 0; i < n; ++i) bits.push_back(has(mask, i));
  return bits;
}

TEST(BestRow, IsBestOfAllRecolourings) {
  std::size_t keys = 0;
  for (std::size_t n = 1; n <= 6; ++n)
    for (const bool front : {false, true})
      for (const bool back : {false, true}) {
        const std::size_t ports = n + (front ? 1 : 0) + (back ? 1 : 0);
        if (ports > 6) continue;
        const Row row{n, front, back, (3 * n) % ports};
        for (Word solid = 0; solid < bit(ports); ++solid) {
          for (Word joined = solid;; joined = (joined - 1) & solid) {
            const KeyedRow key{row, bits_of(solid, ports), bits_of(joined, ports)};
            std::optional<Criteria> best;
            for (Word links = 0; links < bit(n - 1); ++links)
              for (Word kept = solid;; kept = (kept - 1) & solid) {
                const auto found = worth(key, bits_of(links, n - 1), bits_of(kept, ports));
                if (found && (!best || *found < *best)) best = found;
                if (kept == 0) break;
              }
            ASSERT_TRUE(best == answer(key)) << n << ' ' << front << back << ' ' << solid << ' ' << joined;
            ++keys;
            if (joined == 0) break;
          }
        }
      }
  EXPECT_EQ(keys, 3U + 3 * 9 + 4 * (27U + 81 + 243 + 729));
}

/// The best recolouring by a search along the row. A state is the colour of the link to the right and where the strand
/// over it leads: to a port, or to none.
Criteria best_along(const KeyedRow& key) {
  constexpr std::size_t no_link = nowhere;
  constexpr std::size_t no_port = nowhere - 1;
  std::map<std::size_t, Criteria> states{{no_link, {}}};
  for (std::size_t i = 0; i < key.row.triangles; ++i) {
    std::vector<std::size_t> own{key.own(i)};
    if (i == 0 && key.row.front) own.push_back(0);
    if (i + 1 == key.row.triangles && key.row.back) own.push_back(key.places() - 1);
    std::map<std::size_t, Criteria> next;
    for (const auto& [state, criteria] : states)
      for (Word keeps = 0; keeps < bit(own.size()); ++keeps)
        for (const bool right : {false, true}) {
          Criteria here = criteria;
          std::vector<std::size_t> ends;  // ports of the strand through this triangle
          bool possible = !right || i + 1 < key.row.triangles;
          for (std::size_t p = 0; p < own.size(); ++p) {
            if (has(keeps, p)) ends.push_back(own[p]);
            possible &= key.solid[own[p]] || !has(keeps, p);
            if (key.solid[own[p]] && !has(keeps, p)) here = here + Criteria{1, 1, 1};
          }
          const std::size_t degree = ends.size() + (state != no_link ? 1 : 0) + (right ? 1 : 0);
          if (state < no_port) ends.push_back(state);
          if (!possible || degree > 2 || ends.size() > 2) continue;
          if (ends.size() == 2 && (right || !key.may_join(ends[0], ends[1]))) continue;
          if (degree == 0) ++here.isolated_and_given;
          if (right) --here.strips;
          const std::size_t to = !right ? no_link : ends.empty() ? no_port : ends[0];
          const auto [place, is_new] = next.emplace(to, here);
          if (!is_new) place->second = std::min(place->second, here);
        }
    states = std::move(next);
  }
  return states.at(no_link);
}

TEST(BestRow, IsBestForRowsOfAnyLength) {
  std::mt19937 random(7);
  const auto chance = [&](unsigned percent) { return random() % 100 < percent; };
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t n = trial % 2 == 0 ? 1 + random() % 300 : 60 + random() % 6;
    const bool front = chance(50);
    const bool back = chance(50);
    KeyedRow key{{n, front, back, 0}, {}, {}};
    key.row.first = random() % key.row.ports();
    const auto solid = static_cast<unsigned>(random() % 101);
    const auto joined = static_cast<unsigned>(random() % 101);
    for (std::size_t place = 0; place < key.row.ports(); ++place) {
      key.solid.push_back(chance(solid));
      key.joined.push_back(key.solid.back() && chance(joined));
    }
    ASSERT_TRUE(best_along(key) == answer(key)) << "trial " << trial;
  }
}

// The first and the last solid port joined over all the others, which are given up: the only way to save a strip here.
TEST(BestRow, JoinsTheFirstAndTheLastOverAnyNumber) {
  for (const std::size_t k : {5U, 64U, 1000U}) {
    KeyedRow key{hole(k), std::vector<bool>(k, true), std::vector<bool>(k, false)};
    EXPECT_EQ(answer(key).strips, 2);
    key.joined[0] = true;
    EXPECT_EQ(answer(key).strips, 1);
    EXPECT_EQ(answer(key).given, static_cast<int>(k) - 2);
  }
}

}  // namespace
}  // namespace restrip::exact
