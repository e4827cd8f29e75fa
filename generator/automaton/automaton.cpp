#include "automaton/automaton.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace restrip::generator {
namespace {

Costs relative(Costs costs) {
  std::optional<int> least;
  for (const auto& cost : costs)
    if (cost && (!least || *cost < *least)) least = cost;
  for (auto& cost : costs)
    if (cost) *cost -= *least;
  return costs;
}

/// All distinguishable arcs: finitely many, found breadth first.
struct Closure {
  std::vector<Arc> arcs;
  std::vector<std::string> witness;
  std::vector<std::vector<std::optional<ArcStep>>> steps;  ///< by arc and letter, from arc to arc; without costs

  Closure() {
    std::map<Arc, std::size_t> number;
    // The two links of the empty arc are one edge, which the next arc counts.
    Arc& empty = arcs.emplace_back();
    empty.costs[both_dashed] = empty.costs[through_case] = 0;
    witness.emplace_back();
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      steps.emplace_back();
      for (const Letter letter : all_letters) {
        auto& step = steps[i].emplace_back();
        if (letter == Letter::boundary && arcs[i].boundary) continue;
        const Appended longer = append(arcs[i].costs, letter);
        const Arc next{relative(longer.costs), with_letter(arcs[i].ports, letter),
                       arcs[i].boundary || letter == Letter::boundary};
        const auto [place, is_new] = number.emplace(next, arcs.size());
        if (is_new) {
          arcs.push_back(next);
          witness.push_back(witness[i] + text_of(letter));
        }
        step = ArcStep{place->second, 0, longer.before};
      }
    }
  }

  [[nodiscard]] bool can_be_first(std::size_t i) const { return i != 0 && !arcs[i].boundary; }
};

/// Every two arcs around A and D, and every arc around a fan.
struct Contexts {
  Meetings all_meetings;
  std::vector<std::vector<std::uint16_t>> best;  ///< by first and second arc; empty if none exist
  std::vector<std::optional<Case>> closings;

  explicit Contexts(const Closure& all) : best(all.arcs.size()), closings(all.arcs.size()) {
    for (std::size_t x = 0; x < all.arcs.size(); ++x) {
      if (!all.can_be_first(x)) continue;
      closings[x] = best_closing(all.arcs[x]);
      best[x].resize(all.arcs.size());
      for (std::size_t y = 1; y < all.arcs.size(); ++y)
        best[x][y] = static_cast<std::uint16_t>(all_meetings.best(all.arcs[x], all.arcs[y]));
    }
  }

  [[nodiscard]] const Meeting& meeting(std::size_t x, std::size_t y) const { return all_meetings[best[x][y]]; }
};

using CaseSet = std::set<Case>;

/// For each arc, the cases in best recolourings of some patch: cases chosen in a context, and cases from which such a
/// case of a longer arc comes.
std::vector<CaseSet> needed_cases(const Closure& all, const Contexts& contexts) {
  std::vector<CaseSet> needed(all.arcs.size());
  for (std::size_t x = 0; x < all.arcs.size(); ++x) {
    if (all.arcs[x].costs[both_dashed]) needed[x].insert(both_dashed);  // a whole open fan
    if (contexts.closings[x]) needed[x].insert(*contexts.closings[x]);
    if (!all.can_be_first(x)) continue;
    for (std::size_t y = 1; y < all.arcs.size(); ++y) {
      needed[x].insert(contexts.meeting(x, y).first);
      needed[y].insert(contexts.meeting(x, y).second);
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

/// Numbers equal things, in order of appearance.
template <class Thing>
std::size_t number_for(std::map<Thing, std::size_t>& numbers, const Thing& thing) {
  return numbers.emplace(thing, numbers.size()).first->second;
}

/// Moore's algorithm: arcs stay together as long as nothing distinguishes them.
std::vector<std::size_t> minimal_classes(const Closure& all, const Contexts& contexts,
                                         const std::vector<CaseSet>& needed, const std::vector<Costs>& costs) {
  const std::size_t n = all.arcs.size();
  using Sight = std::vector<std::size_t>;
  std::vector<std::size_t> now(n, 0);
  std::size_t count = 1;
  const auto refine = [&](const auto& sight_of) {
    std::map<std::pair<std::size_t, Sight>, std::size_t> numbers;
    std::vector<std::size_t> finer(n);
    for (std::size_t x = 0; x < n; ++x) finer[x] = number_for(numbers, std::pair{now[x], sight_of(x)});
    const bool changed = numbers.size() != count;
    now = std::move(finer);
    count = numbers.size();
    return changed;
  };
  std::map<std::vector<std::uint16_t>, std::size_t> rows;
  std::map<std::vector<std::uint16_t>, std::size_t> columns;
  refine([&](std::size_t x) {
    Sight sight{x == 0 ? 1U : 0U, all.arcs[x].boundary ? 1U : 0U, contexts.closings[x].value_or(both_dashed)};
    for (const auto& cost : costs[x]) sight.push_back(cost ? 1 + static_cast<std::size_t>(*cost) : 0);
    for (const auto& step : all.steps[x]) {
      if (!step) continue;
      for (const Case c : needed[step->to]) sight.push_back(case_codes * c + step->before[c]);
      sight.push_back(case_codes * case_codes);
    }
    sight.push_back(number_for(rows, contexts.best[x]));
    std::vector<std::uint16_t> column;
    for (std::size_t first = 0; x != 0 && first < n; ++first)
      if (all.can_be_first(first)) column.push_back(contexts.best[first][x]);
    sight.push_back(number_for(columns, column));
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

/// Numbers the distinct rows and columns of meetings.
void number_meetings(Automaton& automaton, const Contexts& contexts, const std::vector<std::size_t>& smallest) {
  using Line = std::vector<std::uint16_t>;
  std::map<Line, std::size_t> firsts;
  std::map<Line, std::size_t> seconds;
  const std::size_t n = automaton.classes.size();
  for (std::size_t i = 1; i < n; ++i) {
    ArcClass& arc = automaton.classes[i];
    Line row;
    Line column;
    for (std::size_t j = 1; j < n; ++j) {
      if (arc.can_be_first()) row.push_back(contexts.best[smallest[i]][smallest[j]]);
      if (automaton.classes[j].can_be_first()) column.push_back(contexts.best[smallest[j]][smallest[i]]);
    }
    if (arc.can_be_first()) arc.as_first = number_for(firsts, row);
    arc.as_second = number_for(seconds, column);
  }
  automaton.meets.assign(firsts.size(), std::vector<Meeting>(seconds.size()));
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = 1; j < n; ++j)
      if (automaton.classes[i].can_be_first())
        automaton.meets[automaton.classes[i].as_first][automaton.classes[j].as_second] =
            contexts.meeting(smallest[i], smallest[j]);
}

}  // namespace

Automaton make_automaton() {
  const Closure all;
  const Contexts contexts(all);
  const std::vector<CaseSet> needed = needed_cases(all, contexts);
  Automaton automaton;
  automaton.counts.with_boundary = all.arcs.size() - 1;
  std::set<Costs> values;
  std::vector<Costs> costs(all.arcs.size());
  for (std::size_t x = 0; x < all.arcs.size(); ++x) {
    automaton.counts.with_ports += all.can_be_first(x) ? 1U : 0U;
    if (all.can_be_first(x)) values.insert(all.arcs[x].costs);
    for (const Case c : needed[x]) costs[x][c] = all.arcs[x].costs[c];
    costs[x] = relative(costs[x]);
  }
  automaton.counts.values = values.size();
  const std::vector<std::size_t> class_of = minimal_classes(all, contexts, needed, costs);

  // Arcs were found in order of witness, so classes are numbered in that order as well.
  std::vector<std::size_t> smallest;
  for (std::size_t x = 0; x < all.arcs.size(); ++x) {
    if (class_of[x] != smallest.size()) continue;
    smallest.push_back(x);
    ArcClass& result = automaton.classes.emplace_back();
    result.witness = all.witness[x];
    result.boundary = all.arcs[x].boundary;
    result.costs = costs[x];
    result.closing = contexts.closings[x];
    for (std::size_t letter = 0; letter < all.steps[x].size(); ++letter) {
      auto& kept = result.steps.emplace_back();
      const auto& step = all.steps[x][letter];
      if (!step) continue;
      kept = ArcStep{class_of[step->to], 0, {}};
      for (const Case c : needed[step->to]) kept->before[c] = step->before[c];
      const Case any = *needed[step->to].begin();
      // The cost of one case, relative to the best cases of the two classes.
      const Appended longer = append(all.arcs[x].costs, all_letters.at(letter));
      const Case from = step->before[any];
      kept->cost = *longer.costs[any] - *all.arcs[x].costs[from] + *costs[x][from] - *costs[step->to][any];
    }
  }
  number_meetings(automaton, contexts, smallest);
  return automaton;
}

namespace {

using Rows = std::vector<std::string>;

std::string section_of(std::string_view name, const Rows& rows) {
  return fmt::format("section {}\nclaim rows {}\n{}\n", name, rows.size(), fmt::join(rows, "\n"));
}

}  // namespace

AutomatonArrays automaton_arrays(const Automaton& automaton) {
  std::map<unsigned, std::size_t> number;
  std::vector<std::size_t> meet;
  std::vector<unsigned> meetings;
  for (const std::vector<Meeting>& row : automaton.meets)
    for (const Meeting& m : row) {
      const unsigned word = m.first | m.second << 4U | (m.chord ? 1U : 0U) << 8U;
      const auto [place, is_new] = number.emplace(word, number.size());
      if (is_new) meetings.push_back(word);
      meet.push_back(place->second);
    }
  std::vector<std::size_t> next;
  TableArray before{"before", 32, {}};
  std::vector<unsigned> closed;
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
  for (const ArcClass& c : automaton.classes) {
    for (const auto& step : c.steps) {
      next.push_back(step ? step->to : 0);
      std::uint64_t cases = 0;
      for (Case to = 0; step && to < case_codes; ++to)
        if (automaton.classes[step->to].costs[to]) cases |= std::uint64_t{step->before[to]} << 4U * to;
      before.values.push_back(static_cast<std::uint32_t>(cases));
      before.values.push_back(static_cast<std::uint32_t>(cases >> 32U));
    }
    closed.push_back(c.closing.value_or(both_dashed));
    first.push_back(c.as_first);
    second.push_back(c.as_second);
  }
  return {automaton.meets.at(0).size(),
          {0,
           {array_of("next", next), before, array_of("closed", closed), array_of("first", first),
            array_of("second", second), array_of("meet", meet), array_of("meetings", meetings)}}};
}

AutomatonCertificate automaton_certificate(const Automaton& automaton) {
  const Rows cost{fmt::format("weights {} 0 {}", strip_cost, isolated_cost)};
  Rows classes;
  for (std::size_t x = 0; x < automaton.classes.size(); ++x) {
    const ArcClass& c = automaton.classes[x];
    classes.push_back(fmt::format("class {} {} {} {}", x, c.witness.empty() ? "-" : c.witness,
                                  c.can_be_first() ? std::to_string(c.as_first) : "-",
                                  x == 0 ? "-" : std::to_string(c.as_second)));
    for (Case k = 0; k < case_codes; ++k)
      if (c.costs[k]) classes.push_back(fmt::format("value {} {} {}", x, text_of(k), *c.costs[k]));
    for (std::size_t place = 0; place < c.steps.size(); ++place) {
      const auto& step = c.steps[place];
      if (!step) continue;
      const char letter = text_of(all_letters.at(place));
      classes.push_back(fmt::format("step {} {} {} {}", x, letter, step->to, step->cost));
      for (Case k = 0; k < case_codes; ++k)
        if (automaton.classes[step->to].costs[k])
          classes.push_back(fmt::format("from {} {} {} {}", x, letter, text_of(k), text_of(step->before[k])));
    }
  }
  Rows closings;
  for (std::size_t x = 1; x < automaton.classes.size(); ++x)
    if (const auto& closing = automaton.classes[x].closing)
      closings.push_back(fmt::format("close {} {}", x, text_of(*closing)));
  Rows meetings;
  for (std::size_t x = 0; x < automaton.meets.size(); ++x)
    for (std::size_t y = 0; y < automaton.meets[x].size(); ++y) {
      const Meeting& m = automaton.meets[x][y];
      meetings.push_back(
          fmt::format("meet {} {} {} {} {}", x, y, text_of(m.first), text_of(m.second), m.chord ? "chord" : "-"));
    }
  const std::size_t rows = cost.size() + classes.size() + closings.size() + meetings.size();
  const std::string text = "restrip-certificate 2\nfamily automaton\n" + section_of("cost", cost) +
                           section_of("classes", classes) + section_of("closings", closings) +
                           section_of("meetings", meetings);
  return {sealed(text, rows), rows};
}

}  // namespace restrip::generator
