#include "automaton/automaton.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <utility>

namespace restrip::generator {
namespace {

Value best_of(const Values& values) {
  std::optional<Value> best;
  for (const auto& value : values)
    if (value && (!best || *value > *best)) best = value;
  return best.value_or(Value{});
}

Values less(Values values, Value by) {
  for (auto& value : values)
    if (value) value = *value - by;
  return values;
}

/// An arc before anything is thrown away, values less their best.
struct FullArc {
  Values values;
  Ports ports;
  bool boundary = false;
  friend auto operator<=>(const FullArc&, const FullArc&) = default;
};

/// What a letter leads to: an index and where each case came from.
struct FullStep {
  std::size_t to = 0;
  std::array<Case, case_codes> before{};
};

/// All arcs, told apart by what they are: finitely many, found breadth first.
struct Closure {
  std::vector<FullArc> arcs;
  std::vector<std::string> witness;
  std::vector<std::array<std::optional<FullStep>, 4>> steps;

  Closure() {
    std::map<FullArc, std::size_t> number;
    const auto number_of = [&](const FullArc& arc, const std::string& word) {
      const auto [place, is_new] = number.emplace(arc, arcs.size());
      if (is_new) {
        arcs.push_back(arc);
        witness.push_back(word);
      }
      return place->second;
    };
    number_of({values_of_empty_arc(), {}, false}, "");
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      steps.emplace_back();
      for (const Letter letter : all_letters) {
        if (letter == Letter::boundary && arcs[i].boundary) continue;
        const Appended longer = append(arcs[i].values, letter);
        const FullArc next{less(longer.values, best_of(longer.values)), with_letter(arcs[i].ports, letter),
                           arcs[i].boundary || letter == Letter::boundary};
        const std::size_t to = number_of(next, witness[i] + text_of(letter));
        steps[i][static_cast<std::size_t>(letter)] = FullStep{to, longer.before};
      }
    }
  }

  [[nodiscard]] Arc arc(std::size_t i) const { return {arcs[i].values, arcs[i].ports}; }
  /// Whether it can lie between A and D; any arc but the empty one can lie between D and A.
  [[nodiscard]] bool can_be_first(std::size_t i) const { return i != 0 && !arcs[i].boundary; }
};

/// Every two arcs around A and D, and every arc around a fan.
struct Contexts {
  std::vector<std::vector<Meeting>> meetings;  ///< by first and second arc; empty, and none, where there are none
  std::vector<Closing> closings;

  explicit Contexts(const Closure& all) : meetings(all.arcs.size()), closings(all.arcs.size()) {
    for (std::size_t x = 0; x < all.arcs.size(); ++x) {
      if (!all.can_be_first(x)) continue;
      closings[x] = best_closing(all.arc(x));
      meetings[x].resize(all.arcs.size());
      for (std::size_t y = 1; y < all.arcs.size(); ++y) meetings[x][y] = best_meeting(all.arc(x), all.arc(y)).meeting;
    }
  }
};

using CaseSet = std::set<Case>;

/// For each arc the cases that a best recolouring of some patch has: those chosen in a context, and those from which
/// such a case of a longer arc comes.
std::vector<CaseSet> needed_cases(const Closure& all, const Contexts& contexts) {
  std::vector<CaseSet> needed(all.arcs.size());
  for (std::size_t x = 0; x < all.arcs.size(); ++x) {
    if (all.arcs[x].values[both_dashed]) needed[x].insert(both_dashed);  // a whole open fan
    if (!all.can_be_first(x)) continue;
    needed[x].insert(contexts.closings[x].arc);
    for (std::size_t y = 1; y < all.arcs.size(); ++y) {
      needed[x].insert(contexts.meetings[x][y].first);
      needed[y].insert(contexts.meetings[x][y].second);
    }
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t x = 0; x < all.arcs.size(); ++x)
      for (const auto& step : all.steps[x]) {
        if (!step) continue;
        const CaseSet there = needed[step->to];
        for (const Case c : there) grown |= needed[x].insert(step->before[c]).second;
      }
  }
  return needed;
}

/// Moore's algorithm: arcs are kept together as long as nothing tells them apart.
std::vector<std::size_t> minimal_classes(const Closure& all, const Contexts& contexts,
                                         const std::vector<CaseSet>& needed, const std::vector<Values>& values) {
  const std::size_t n = all.arcs.size();
  using Sight = std::vector<std::size_t>;
  std::vector<std::size_t> now(n, 0);
  std::size_t count = 1;
  const auto refine = [&](const auto& sight_of) {
    std::map<std::pair<std::size_t, Sight>, std::size_t> numbers;
    std::vector<std::size_t> finer(n);
    for (std::size_t x = 0; x < n; ++x)
      finer[x] = numbers.emplace(std::pair{now[x], sight_of(x)}, numbers.size()).first->second;
    const bool changed = numbers.size() != count;
    now = std::move(finer);
    count = numbers.size();
    return changed;
  };
  const auto code = [](const Meeting& m) { return m.first | m.second << 4U | (m.chord ? 1U : 0U) << 8U; };
  refine([&](std::size_t x) {
    Sight sight{x == 0 ? 1U : 0U, all.arcs[x].boundary ? 1U : 0U, contexts.closings[x].arc};
    for (const auto& value : values[x]) {
      sight.push_back(value ? static_cast<std::size_t>(-value->solid) : 1000);
      sight.push_back(value ? static_cast<std::size_t>(1000 - value->fewer_isolated) : 0);
    }
    for (std::size_t letter = 0; letter < 4; ++letter) {
      const auto& step = all.steps[x][letter];
      if (!step) continue;
      for (const Case c : needed[step->to]) sight.push_back(c << 4U | step->before[c]);
      sight.push_back(1000);
    }
    for (std::size_t y = 1; y < n; ++y) {
      if (all.can_be_first(x)) sight.push_back(code(contexts.meetings[x][y]));
      if (all.can_be_first(y) && x != 0) sight.push_back(code(contexts.meetings[y][x]));
    }
    return sight;
  });
  while (refine([&](std::size_t x) {
    Sight sight;
    for (const auto& step : all.steps[x]) sight.push_back(step ? now[step->to] : count);
    return sight;
  })) {
  }
  return now;
}

AutomatonCounts counts_of(const Closure& all) {
  std::set<Values> values;
  AutomatonCounts counts;
  for (std::size_t x = 1; x < all.arcs.size(); ++x) {
    ++counts.with_boundary;
    if (all.arcs[x].boundary) continue;
    ++counts.with_ports;
    values.insert(all.arcs[x].values);
  }
  counts.values = values.size();
  return counts;
}

/// Numbers for equal rows, in order of appearance.
template <class Row>
std::size_t number_of(std::map<Row, std::size_t>& numbers, const Row& row) {
  return numbers.emplace(row, numbers.size()).first->second;
}

}  // namespace

ValuedMeeting Automaton::meeting(std::size_t first, std::size_t second) const {
  const ArcClass& x = classes[first];
  const ArcClass& y = classes[second];
  const Meeting m = meetings[meets[x.as_first][y.as_second]];
  return {m, x.values[m.first].value() + y.values[m.second].value() + value_around(m)};
}

Automaton make_automaton() {
  const Closure all;
  const Contexts contexts(all);
  const std::vector<CaseSet> needed = needed_cases(all, contexts);
  std::vector<Values> values(all.arcs.size());
  for (std::size_t x = 0; x < all.arcs.size(); ++x) {
    for (const Case c : needed[x]) values[x][c] = all.arcs[x].values[c];
    values[x] = less(values[x], best_of(values[x]));
  }
  const std::vector<std::size_t> class_of = minimal_classes(all, contexts, needed, values);

  Automaton automaton;
  automaton.counts = counts_of(all);
  // Arcs were found in order of witness, so classes are numbered in that order as well.
  std::vector<std::size_t> smallest;
  for (std::size_t x = 0; x < all.arcs.size(); ++x)
    if (class_of[x] == smallest.size()) smallest.push_back(x);
  std::map<std::vector<Meeting>, std::size_t> firsts;
  std::map<std::vector<Meeting>, std::size_t> seconds;
  std::map<Meeting, std::size_t> meetings;
  for (const std::size_t x : smallest) {
    ArcClass result;
    result.witness = all.witness[x];
    result.boundary = all.arcs[x].boundary;
    result.values = values[x];
    for (std::size_t letter = 0; letter < 4; ++letter) {
      const auto& step = all.steps[x][letter];
      if (!step) continue;
      ArcStep& kept = result.steps[letter].emplace();
      kept.to = class_of[step->to];
      for (const Case c : needed[step->to]) kept.before[c] = step->before[c];
      const Case any = *needed[step->to].begin();
      kept.gain = append(values[x], all_letters[letter]).values[any].value() - values[step->to][any].value();
    }
    std::vector<Meeting> row;
    std::vector<Meeting> column;
    for (const std::size_t y : smallest) {
      if (all.can_be_first(x) && y != 0) row.push_back(contexts.meetings[x][y]);
      if (all.can_be_first(y) && x != 0) column.push_back(contexts.meetings[y][x]);
    }
    if (!row.empty()) {
      result.as_first = number_of(firsts, row);
      result.closing = {contexts.closings[x].arc, values[x][contexts.closings[x].arc].value()};
    }
    if (!column.empty()) result.as_second = number_of(seconds, column);
    for (const Meeting& m : row) number_of(meetings, m);
    automaton.classes.push_back(std::move(result));
  }
  automaton.meetings.resize(meetings.size());
  for (const auto& [m, number] : meetings) automaton.meetings[number] = m;
  automaton.meets.assign(firsts.size(), std::vector<std::size_t>(seconds.size(), 0));
  for (std::size_t i = 0; i < smallest.size(); ++i)
    for (std::size_t j = 1; j < smallest.size(); ++j)
      if (all.can_be_first(smallest[i]))
        automaton.meets[automaton.classes[i].as_first][automaton.classes[j].as_second] =
            meetings.at(contexts.meetings[smallest[i]][smallest[j]]);
  return automaton;
}

}  // namespace restrip::generator
