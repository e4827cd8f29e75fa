#include "automaton/meeting.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace restrip::generator {
namespace {

/// The four ends of two arcs in ring order; A lies between second_last and first_first, D between the other two.
enum End : std::size_t { first_first, first_last, second_first, second_last, ends };
constexpr std::size_t at_a = ends;
constexpr std::size_t at_d = ends + 1;

using EndPair = std::pair<End, End>;

/// A way to put cases together, whatever the arcs.
struct Way {
  Meeting meeting;
  Value value;                 ///< of A, D, and the edges that no arc counts
  std::vector<EndPair> joins;  ///< ends whose strands reach ports and are joined
  int tie = 0;                 ///< smaller is preferred
};

/// Ends and new triangles under "connected by solid edges".
class Strands {
 public:
  Strands() { std::iota(label_.begin(), label_.end(), std::size_t{0}); }
  /// False when the edge closes a cycle.
  bool join(std::size_t x, std::size_t y) {
    const std::size_t from = label_[x];
    const std::size_t to = label_[y];
    if (from == to) return false;
    std::replace(label_.begin(), label_.end(), from, to);
    return true;
  }
  [[nodiscard]] bool same(std::size_t x, std::size_t y) const { return label_[x] == label_[y]; }

 private:
  std::array<std::size_t, ends + 2> label_{};
};

/// The tie-break (docs/automaton.md, "Ties"): as much of the tables' own (preference.cpp) as can be seen from here.
int tie_of(const Way& way, int degree_a, int degree_d, const std::array<Reach, ends>& reach) {
  int tie = way.meeting.chord ? 64 : 0;
  tie += 64 * (degree_a + degree_d);
  tie += 100 * ((degree_a == 1 ? 1 : 0) + (degree_d == 1 ? 1 : 0));
  tie -= 49 * static_cast<int>(way.joins.size());
  tie -= 53 * static_cast<int>(std::count(reach.begin(), reach.end(), Reach::ends));
  return tie;
}

std::optional<Way> make_way(const Meeting& meeting) {
  const std::array<Reach, ends> reach{left_of(meeting.first), right_of(meeting.first), left_of(meeting.second),
                                      right_of(meeting.second)};
  const auto solid = [&](End end) { return reach[end] == Reach::dashed ? 0 : 1; };
  const int chord = meeting.chord ? 1 : 0;
  const int degree_a = solid(first_first) + solid(second_last) + chord;
  const int degree_d = solid(first_last) + solid(second_first) + chord;
  if (degree_a > 2 || degree_d > 2) return {};
  Strands strands;
  const auto joins = [&](bool wanted, std::size_t x, std::size_t y) { return !wanted || strands.join(x, y); };
  const bool no_cycle = joins(meeting.first == through_case, first_first, first_last) &&
                        joins(meeting.second == through_case, second_first, second_last) &&
                        joins(solid(first_first) != 0, at_a, first_first) &&
                        joins(solid(first_last) != 0, at_d, first_last) &&
                        joins(solid(second_first) != 0, at_d, second_first) &&
                        joins(solid(second_last) != 0, at_a, second_last) && joins(meeting.chord, at_a, at_d);
  if (!no_cycle) return {};
  Way way;
  way.meeting = meeting;
  way.value.solid = solid(first_last) + solid(second_last) + chord;
  way.value.fewer_isolated = -((degree_a == 0 ? 1 : 0) + (degree_d == 0 ? 1 : 0));
  for (const End x : {first_first, first_last, second_first})
    for (std::size_t y = x + 1; y < ends; ++y)
      if (reach[x] == Reach::port && reach[y] == Reach::port && strands.same(x, y))
        way.joins.emplace_back(x, static_cast<End>(y));
  way.tie = tie_of(way, degree_a, degree_d, reach);
  return way;
}

/// All ways, preferred ones first.
const std::vector<Way>& ways() {
  static const std::vector<Way> all = [] {
    std::vector<Way> list;
    for (const Case first : all_cases)
      for (const Case second : all_cases)
        for (const bool chord : {false, true})
          if (auto way = make_way({first, second, chord})) list.push_back(std::move(*way));
    std::stable_sort(list.begin(), list.end(), [](const Way& x, const Way& y) { return x.tie < y.tie; });
    return list;
  }();
  return all;
}

/// Which ends reach ports that the key joins.
class JoinedEnds {
 public:
  JoinedEnds(const Ports& first, const Ports& second) {
    const auto add = [&](End x, End y) {
      // The two end ports of an arc with one port are the same.
      for (const End u : same_port(x, first, second))
        for (const End v : same_port(y, first, second)) pairs_[u][v] = pairs_[v][u] = true;
    };
    if (first.two_joined) add(first_first, first_last);
    if (second.two_joined) add(second_first, second_last);
    if (first.count > 0 && second.count > 0) {
      if (first.first_joined) add(second_last, first_first);
      if (second.first_joined) add(first_last, second_first);
    } else {
      if (first.count > 1 && first.first_joined) add(first_last, first_first);
      if (second.count > 1 && second.first_joined) add(second_last, second_first);
    }
  }
  [[nodiscard]] bool has(const EndPair& pair) const { return pairs_[pair.first][pair.second]; }

 private:
  static std::vector<End> same_port(End end, const Ports& first, const Ports& second) {
    if (end < second_first) return first.count == 1 ? std::vector{first_first, first_last} : std::vector{end};
    return second.count == 1 ? std::vector{second_first, second_last} : std::vector{end};
  }

  std::array<std::array<bool, ends>, ends> pairs_{};
};

}  // namespace

Ports with_letter(Ports ports, Letter letter) {
  if (letter != Letter::separate && letter != Letter::joined) return ports;
  const bool joined = letter == Letter::joined;
  if (ports.count == 0) ports.first_joined = joined;
  ports.two_joined = ports.count == 1 && joined;
  ports.count = std::min(ports.count + 1, 3U);
  return ports;
}

Value value_around(const Meeting& meeting) { return make_way(meeting).value().value; }

ValuedMeeting best_meeting(const Arc& first, const Arc& second) {
  const JoinedEnds joined(first.ports, second.ports);
  std::optional<ValuedMeeting> best;
  for (const Way& way : ways()) {
    const auto& x = first.values[way.meeting.first];
    const auto& y = second.values[way.meeting.second];
    if (!x || !y) continue;
    if (!std::all_of(way.joins.begin(), way.joins.end(), [&](const EndPair& pair) { return joined.has(pair); }))
      continue;
    const Value value = *x + *y + way.value;
    if (!best || value > best->value) best = {way.meeting, value};
  }
  if (!best) throw std::logic_error("two arcs without a sound recolouring");
  return *best;
}

Closing best_closing(const Arc& arc) {
  const bool ports_joined = arc.ports.count > 1 && (arc.ports.first_joined || arc.ports.two_joined);
  std::optional<Closing> best;
  for (const Case c : all_cases) {
    if (!arc.values[c] || c == through_case) continue;
    if ((left_of(c) == Reach::dashed) != (right_of(c) == Reach::dashed)) continue;
    if (c == case_of(Reach::port, Reach::port) && !ports_joined) continue;
    if (!best || *arc.values[c] > best->value) best = Closing{c, *arc.values[c]};
  }
  if (!best) throw std::logic_error("a closed fan without a sound recolouring");
  return *best;
}

}  // namespace restrip::generator
