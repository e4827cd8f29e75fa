#include "class_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "arcs_around.hpp"
#include "automaton_mutants.hpp"
#include "witnesses.hpp"

namespace restrip::verify {
namespace {

std::string in_words(Worth worth) {
  return fmt::format("{} solid edges and {} isolated triangles", worth.solid, -worth.fewer_isolated);
}

Worths less(Worths worths, Worth by) {
  for (auto& worth : worths)
    if (worth) worth = *worth - by;
  return worths;
}

/// What of the ports of an arc tells which pairs of end ports are joined before, whatever the other arc: how many there
/// are, up to three; whether the first is joined to the one before it; whether there are two and they are joined.
std::string ports_of(const std::string& word) {
  std::string ports;
  std::copy_if(word.begin(), word.end(), std::back_inserter(ports), [](char c) { return c == 's' || c == 'j'; });
  return ports.size() < 3 ? ports : ports.substr(0, 1) + "..";
}

std::string text_of(const Worths& worths) {
  std::string text;
  for (const auto& worth : worths)
    text += worth ? fmt::format(" {},{}", worth->solid, worth->fewer_isolated) : std::string(" none");
  return text;
}

}  // namespace

ClassCheck::ClassCheck(const AutomatonCertificate& certificate)
    : certificate_(certificate),
      claims_{{"each witness is a shortest arc of its class", "steps followed, breadth first", 0, {}},
              {"the values are those of the best colourings", "all colourings of one arc of each kind", 0, {}},
              {"what a letter adds to them", "the same", 0, {}},
              {"every case comes from the case that is named", "the same, without the last triangle", 0, {}},
              {"every meeting is sound and best", "all pairs of cases around A and D", 0, {}},
              {"every closing is sound and best", "all cases around a closed fan", 0, {}}} {
  check_witnesses();
  explore();
  check_meetings();
  check_closings();
}

void ClassCheck::fail(Which which, unsigned line, const std::string& what) {
  claims_[which].failures.add(fmt::format("{}:{}: {}", certificate_.file, line, what));
}

void ClassCheck::check_witnesses() {
  const auto shortest = shortest_arcs(certificate_.classes.size(), letters, [&](std::size_t c, std::size_t letter) {
    const auto& step = certificate_.classes[c].steps[letter];
    return step ? std::optional(step->to) : std::nullopt;
  });
  for (std::size_t c = 0; c < certificate_.classes.size(); ++c) {
    ++claims_[witnesses].cases;
    const AutomatonClass& stated = certificate_.classes[c];
    if (const std::string fault = witness_fault(c, stated.witness, shortest[c]); !fault.empty())
      fail(witnesses, stated.line, fault);
  }
}

std::size_t ClassCheck::place_of(const std::string& word, const Worths& absolute, std::size_t arc_class) {
  const Worths worths = less(absolute, best_of(absolute));
  const std::string key = fmt::format("{} {} {} {}", arc_class, has_boundary(word), ports_of(word), text_of(worths));
  const auto [place, is_new] = places_.emplace(key, arcs_.size());
  if (!is_new) return place->second;
  ProductArc arc{word, worths, best_of(absolute), arc_class, {}, true};
  const AutomatonClass& stated = certificate_.classes[arc_class];
  std::optional<Worth> offset;
  for (std::size_t c = 0; c < all_cases.size(); ++c) {
    if (!stated.values[c]) continue;
    ++claims_[values].cases;
    if (!worths[c] || (offset && *worths[c] - *stated.values[c] != *offset)) {
      arc.comparable = false;
      fail(values, stated.line,
           fmt::format("wrong value: case {} of class {}, arc {}", all_cases[c].text(), arc_class,
                       word.empty() ? "-" : word));
      break;
    }
    offset = *worths[c] - *stated.values[c];
  }
  arc.offset = offset.value_or(Worth{});
  // A whole open fan has the case with both links dashed.
  if (worths[both_dashed] && !stated.values[both_dashed])
    fail(values, stated.line, fmt::format("missing value: case -- of class {}", arc_class));
  if (has_boundary(word) != stated.has_boundary())
    fail(values, stated.line, fmt::format("wrong class: {} for the arc {}", arc_class, word));
  arcs_.push_back(arc);
  return place->second;
}

void ClassCheck::check_step(std::size_t at, std::size_t letter) {
  const ProductArc arc = arcs_[at];
  const AutomatonStep& step = certificate_.classes[arc.arc_class].steps[letter].value();
  const std::string word = arc.word + letters[letter];
  const Origins longer = origins_of(word);
  const Worth added = best_of(longer.worths) - arc.best;
  const std::size_t place = place_of(word, longer.worths, step.to);
  const ProductArc& next = arcs_[place];
  ++claims_[gains].cases;
  if (arc.comparable && next.comparable && step.gain + arc.offset != added + next.offset &&
      !mutated(AutomatonMutant::automaton_any_gain))
    fail(gains, step.line,
         fmt::format("wrong gain: {} where the arc {} gains {}", in_words(step.gain), word,
                     in_words(added + next.offset - arc.offset)));
  const AutomatonClass& from = certificate_.classes[arc.arc_class];
  for (std::size_t c = 0; c < all_cases.size(); ++c) {
    if (!certificate_.classes[step.to].values[c]) continue;
    ++claims_[origins].cases;
    const std::size_t before = step.from[c];
    if (mutated(AutomatonMutant::automaton_any_origin)) continue;
    if (!is_solid(longer.from[c], static_cast<unsigned>(before)) || !from.values[before])
      fail(origins, step.line,
           fmt::format("wrong origin: no best colouring of {} with case {} has case {} before its last letter", word,
                       all_cases[c].text(), all_cases[before].text()));
  }
}

void ClassCheck::explore() {
  place_of("", worths_of(""), 0);
  if (arcs_[0].offset != Worth{})
    fail(values, certificate_.classes[0].line, "wrong value: the empty arc is worth nothing");
  constexpr std::size_t longest = 14;
  if (mutated(AutomatonMutant::automaton_first_arcs_only)) return;
  for (std::size_t at = 0; at < arcs_.size(); ++at)
    for (std::size_t letter = 0; letter < letters.size(); ++letter) {
      if (!certificate_.classes[arcs_[at].arc_class].steps[letter]) continue;
      if (letters[letter] == 'b' && has_boundary(arcs_[at].word)) continue;
      if (arcs_[at].word.size() >= longest) {
        fail(values, certificate_.classes[arcs_[at].arc_class].line,
             fmt::format("the arcs do not close: {} is still a new one", arcs_[at].word));
        return;
      }
      check_step(at, letter);
    }
}

void ClassCheck::check_meeting(const ProductArc& x, const ProductArc& y) {
  ++claims_[meetings].cases;
  const auto& stated = certificate_.meetings[x.arc_class][y.arc_class];
  const auto worth_of = [&](const Around& way) -> std::optional<Worth> {
    if (!x.worths[way.first] || !y.worths[way.second]) return {};
    for (const auto& [one, other] : way.joined)
      if (!joined_before(x.word, y.word, one, other) && !mutated(AutomatonMutant::automaton_join_anything)) return {};
    return *x.worths[way.first] + *y.worths[way.second] + way.worth;
  };
  const auto arcs = [&] { return fmt::format("the arcs {} and {}", x.word, y.word); };
  const Around own = around(stated->first, stated->second, stated->chord);
  const bool own_legal = own.legal || mutated(AutomatonMutant::automaton_any_own_meeting);
  const auto own_worth = own_legal ? worth_of(own) : std::nullopt;
  if (!own_worth || !certificate_.classes[x.arc_class].values[stated->first] ||
      !certificate_.classes[y.arc_class].values[stated->second])
    return fail(meetings, stated->line, fmt::format("unsound meeting: {}", arcs()));
  for (const Around& way : all_around()) {
    if (way.chord && mutated(AutomatonMutant::automaton_never_chord)) continue;
    if (const auto worth = worth_of(way); worth && *worth > *own_worth)
      return fail(
          meetings, stated->line,
          fmt::format("not the best meeting: {}, {} {}{} has {} more", arcs(), all_cases[way.first].text(),
                      all_cases[way.second].text(), way.chord ? " with the chord" : "", in_words(*worth - *own_worth)));
  }
  if (stated->value + x.offset + y.offset != *own_worth)
    fail(meetings, stated->line, fmt::format("wrong value: the meeting of {}", arcs()));
}

void ClassCheck::check_meetings() {
  for (const ProductArc& x : arcs_) {
    if (x.word.empty() || !x.comparable || !certificate_.can_be_first(x.arc_class)) continue;
    for (const ProductArc& y : arcs_)
      if (!y.word.empty() && y.comparable && y.arc_class != 0) check_meeting(x, y);
  }
}

void ClassCheck::check_closings() {
  for (const ProductArc& arc : arcs_) {
    if (arc.word.empty() || !arc.comparable || !certificate_.can_be_first(arc.arc_class)) continue;
    ++claims_[closings].cases;
    const auto& stated = certificate_.closings[arc.arc_class];
    // The two links are one edge: a strand over it that leaves by ports at both ends joins them, one that goes through
    // is a cycle.
    const auto sound = [&](std::size_t c) {
      const Case k = all_cases[c];
      if (!arc.worths[c] || (k.left == '-') != (k.right == '-') || k.left == 't') return false;
      return k.left != 'p' || k.right != 'p' || joined_before(arc.word, "", {false, false}, {false, true});
    };
    if (!sound(stated->arc) || !certificate_.classes[arc.arc_class].values[stated->arc]) {
      fail(closings, stated->line, fmt::format("unsound closing: the fan {}", arc.word));
      continue;
    }
    for (std::size_t c = 0; c < all_cases.size(); ++c)
      if (sound(c) && *arc.worths[c] > *arc.worths[stated->arc] && !mutated(AutomatonMutant::automaton_any_closing))
        fail(closings, stated->line,
             fmt::format("not the best closing: the fan {}, {} has {} more", arc.word, all_cases[c].text(),
                         in_words(*arc.worths[c] - *arc.worths[stated->arc])));
    if (stated->value + arc.offset != *arc.worths[stated->arc])
      fail(closings, stated->line, fmt::format("wrong value: the closing of the fan {}", arc.word));
  }
}

}  // namespace restrip::verify
