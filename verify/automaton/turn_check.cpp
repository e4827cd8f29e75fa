#include "turn_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "automaton_mutants.hpp"
#include "witnesses.hpp"

namespace restrip::verify {
namespace {

constexpr int no_cost = std::numeric_limits<int>::max();

/// The words that joints are read off, and the longest arc of a kind before the kinds are said not to close.
constexpr std::size_t longest_joint = 6;
constexpr std::size_t longest_kind = 100;

/// They depend on no certificate.
const TurnJoints& all_joints() {
  static const TurnJoints joints(longest_joint);
  return joints;
}

TurnCosts shifted(TurnCosts turn_costs, int by) {
  for (auto& cost : turn_costs)
    if (cost) *cost += by;
  return turn_costs;
}

/// Leaves out what is no better than the best colouring with a link cut, or both. In any patch that may be put in its
/// place: a dashed edge in place of a solid one is sound, makes no swap, and leaves at most the neighbour isolated. The
/// arc itself counts its left link.
TurnCosts without_hopeless(const TurnCosts& turn_costs, const TurnWeights& weights) {
  TurnCosts kept = turn_costs;
  for (std::size_t c = 0; c < turn_cases; ++c) {
    const Case k = turn_case(c);
    const auto drop_for = [&](Case cut, int loss) {
      const auto& cost = turn_costs[turn_number(cut).value()];
      if (turn_costs[c] && cost && *cost + loss <= *turn_costs[c]) kept[c].reset();
    };
    const int of_left = weights.isolated;
    const int of_right = weights.restart + weights.isolated;
    if (k.left != '-' && k.right != '-') drop_for({'-', '-'}, of_left + of_right);
    if (k.left != '-' && k.left != 't') drop_for({'-', k.right}, of_left);
    if (k.right != '-' && k.right != 't') drop_for({k.left, '-'}, of_right);
  }
  return kept;
}

/// The cases that an arc has, in a row.
struct TurnEntry {
  std::size_t turn_case = 0;
  int cost = 0;
};
std::vector<TurnEntry> entries_of(const TurnCosts& turn_costs) {
  std::vector<TurnEntry> entries;
  for (std::size_t c = 0; c < turn_cases; ++c)
    if (turn_costs[c]) entries.push_back({c, *turn_costs[c]});
  return entries;
}

/// The least cost for each set of pairs of links that may be joined.
using Leasts = std::array<int, pair_sets>;

void allow_more_pairs(Leasts& leasts) {
  for (unsigned pair = 0; mask_count(pair) < pair_sets; ++pair)
    for (Mask set = 0; set < pair_sets; ++set)
      if (is_solid(set, pair)) leasts[set] = std::min(leasts[set], leasts[set & ~single(pair)]);
}

Leasts leasts_around(const TurnWays& ways, const std::vector<TurnEntry>& first, const std::vector<TurnEntry>& second) {
  Leasts leasts;
  leasts.fill(no_cost);
  for (const TurnEntry& x : first)
    for (const TurnEntry& y : second)
      for (const bool chord : {false, true}) {
        const TurnWay& way = ways.around(x.turn_case, y.turn_case, chord);
        if (way.legal) leasts[way.joined] = std::min(leasts[way.joined], x.cost + y.cost + way.cost);
      }
  allow_more_pairs(leasts);
  return leasts;
}

/// The same for one pair only: not joined, and joined.
using TwoLeasts = std::array<int, 2>;

void offer(TwoLeasts& leasts, const TurnWay& way, int cost) {
  if (!way.legal) return;
  for (const std::size_t allowed : {0U, 1U})
    if (way.joined <= allowed) leasts[allowed] = std::min(leasts[allowed], cost + way.cost);
}

std::string name_of(const std::string& word) { return word.empty() ? "-" : word; }

}  // namespace

/// What is behind a link of an arc that ends at the boundary of the mesh: case numbers are those of the whole arc.
struct TurnCheck::AtBoundary {
  std::string word;
  TurnCosts exact;
  TurnCosts claimed;
};

TurnCheck::TurnCheck(const TurnCertificate& certificate, unsigned every)
    : certificate_(certificate),
      joints_(all_joints()),
      ways_(certificate.weights),
      claims_{{"an arc and a triangle behind it matter by their cases", "all colourings of all arcs of up to 6", 0, {}},
              {"each witness is a shortest arc of its class", "steps followed, breadth first", 0, {}},
              {"the values are the least costs", "arcs put together triangle by triangle", 0, {}},
              {"what a letter costs", "the same", 0, {}},
              {"every case comes from the case that is named", "the same, without the last triangle", 0, {}},
              {"no case that a class leaves out is needed", "all pairs of arcs, all sets of joined ports", 0, {}}} {
  claims_[joints].cases = joints_.colorings();
  claims_[joints].failures = joints_.failures();
  check_witnesses();
  explore();
  const bool all_hold = std::all_of(claims_.begin(), claims_.end(),
                                    [](const AutomatonClaim& claim) { return claim.failures.count == 0; });
  if (all_hold && !mutated(AutomatonMutant::turns_no_pairs)) check_answers(every);
}

void TurnCheck::fail(Which which, unsigned line, const std::string& what) {
  claims_[which].failures.add(fmt::format("{}:{}: {}", certificate_.file, line, what));
}

void TurnCheck::check_witnesses() {
  const auto shortest = shortest_arcs(
      certificate_.classes.size(), turn_letters,
      [&](std::size_t c, std::size_t letter) { return std::optional(certificate_.classes[c].steps[letter].to); });
  for (std::size_t c = 0; c < certificate_.classes.size(); ++c) {
    ++claims_[witnesses].cases;
    const TurnClass& stated = certificate_.classes[c];
    if (const std::string fault = witness_fault(c, stated.witness, shortest[c]); !fault.empty())
      fail(witnesses, stated.line, fault);
  }
}

std::size_t TurnCheck::place_of(const std::string& word, const TurnCosts& absolute, std::size_t arc_class) {
  const TurnCosts relative = shifted(absolute, -least_of(absolute));
  const auto [place, is_new] = places_.emplace(std::pair{arc_class, relative}, arcs_.size());
  if (!is_new) return place->second;
  TurnArcKind arc{word, relative, arc_class, 0, true};
  const TurnClass& claimed = certificate_.classes[arc_class];
  arc.offset = *relative[both_dashed] - *claimed.costs[both_dashed];
  for (std::size_t c = 0; c < turn_cases; ++c) {
    if (!claimed.costs[c]) continue;
    ++claims_[values].cases;
    if (relative[c] && *relative[c] == *claimed.costs[c] + arc.offset) continue;
    arc.comparable = false;
    fail(values, claimed.line,
         fmt::format("wrong value: case {} of class {}, arc {}", turn_case(c).text(), arc_class, name_of(word)));
    break;
  }
  arcs_.push_back(arc);
  return place->second;
}

void TurnCheck::check_step(std::size_t at, std::size_t letter) {
  const TurnArcKind arc = arcs_[at];
  const TurnStep& step = certificate_.classes[arc.arc_class].steps[letter];
  const std::string word = arc.word + turn_letters[letter];
  const std::string_view triangle = turn_letters.substr(letter, 1);
  TurnCosts longer;
  std::array<Mask, turn_cases> from{};  // the cases without the triangle that the least costs come from
  for (Mask links = 0; links < mask_count(2); ++links) {
    const TurnColoring alone = turn_coloring(triangle, links, certificate_.weights);
    if (!alone.sound) continue;
    const auto offer_case = [&](std::size_t c, std::size_t before, int cost) {
      if (longer[c] && *longer[c] < cost) return;
      if (!longer[c] || *longer[c] > cost) from[c] = 0;
      longer[c] = cost;
      from[c] |= single(static_cast<unsigned>(before));
    };
    for (std::size_t before = 0; before < turn_cases; ++before) {
      if (!arc.costs[before]) continue;
      if (arc.word.empty()) {
        // The two links of the empty arc are one edge.
        if ((before == both_dashed) == !is_solid(links, 0)) offer_case(alone.arc_case, before, alone.cost);
        continue;
      }
      const auto& joint = joints_.at(before, alone.arc_case, turn_joined(triangle[0]));
      if (!joint || !joint->sound) continue;
      offer_case(joint->arc_case, before,
                 *arc.costs[before] + alone.cost + (joint->swap ? certificate_.weights.swap : 0));
    }
  }
  const TurnCosts hopeful = without_hopeless(longer, certificate_.weights);
  const int added = least_of(hopeful);
  const TurnArcKind& next = arcs_[place_of(word, hopeful, step.to)];
  if (!next.comparable || !arc.comparable) return;
  ++claims_[costs].cases;
  if (step.cost - added != next.offset - arc.offset && !mutated(AutomatonMutant::turns_any_cost))
    fail(costs, step.line,
         fmt::format("wrong cost: {} where the arc {} costs {} more", step.cost, word,
                     added + next.offset - arc.offset));
  const TurnClass& source = certificate_.classes[arc.arc_class];
  for (std::size_t c = 0; c < turn_cases; ++c) {
    if (!certificate_.classes[step.to].costs[c]) continue;
    ++claims_[origins].cases;
    const std::size_t before = step.from[c];
    if (mutated(AutomatonMutant::turns_any_origin)) continue;
    if (!is_solid(from[c], static_cast<unsigned>(before)) || !source.costs[before])
      fail(origins, step.line,
           fmt::format("wrong origin: no best colouring of {} with case {} has case {} before its last letter", word,
                       turn_case(c).text(), turn_case(before).text()));
  }
}

void TurnCheck::explore() {
  TurnCosts empty;
  empty[both_dashed] = empty[turn_through] = 0;
  place_of("", empty, 0);
  if (certificate_.classes[0].costs != empty)
    fail(values, certificate_.classes[0].line,
         "wrong value: the empty arc has the cases -- and tt, which cost nothing");
  if (mutated(AutomatonMutant::turns_first_arcs_only)) return;
  for (std::size_t at = 0; at < arcs_.size(); ++at)
    for (std::size_t letter = 0; letter < turn_letters.size(); ++letter) {
      if (arcs_[at].word.size() >= longest_kind) {
        fail(values, certificate_.classes[arcs_[at].arc_class].line,
             fmt::format("the arcs do not close: {} is still a new one", arcs_[at].word));
        return;
      }
      check_step(at, letter);
    }
}

TurnCosts TurnCheck::stated(const TurnArcKind& arc) const {
  return shifted(certificate_.classes[arc.arc_class].costs, arc.offset);
}

void TurnCheck::check_pair(const TurnArcKind& first, const TurnCosts& second, const TurnCosts& second_stated,
                           const std::string& second_word) {
  ++claims_[answers].cases;
  const Leasts exact = leasts_around(ways_, entries_of(first.costs), entries_of(second));
  const Leasts claimed = leasts_around(ways_, entries_of(stated(first)), entries_of(second_stated));
  if (exact != claimed)
    fail(answers, certificate_.classes[first.arc_class].line,
         fmt::format("missing case: of the arcs {} and {} something better can be made", name_of(first.word),
                     second_word));
}

void TurnCheck::check_answers(unsigned every) {
  // Arcs of open fans that end at the boundary, below A and above D, those with the same costs once.
  std::vector<AtBoundary> below;
  std::vector<AtBoundary> above;
  const auto collect = [&](std::vector<AtBoundary>& list, const TurnArcKind& arc, bool left_dashed) {
    AtBoundary kind{arc.word, {}, {}};
    const TurnCosts claimed = stated(arc);
    for (std::size_t c = 0; c < turn_cases; ++c) {
      if ((left_dashed ? turn_case(c).left : turn_case(c).right) != '-') continue;
      kind.exact[c] = arc.costs[c];
      kind.claimed[c] = claimed[c];
    }
    const int base = kind.exact[both_dashed].value();
    kind.exact = shifted(kind.exact, -base);
    kind.claimed = shifted(kind.claimed, -base);
    const bool known = std::any_of(list.begin(), list.end(), [&](const AtBoundary& other) {
      return other.exact == kind.exact && other.claimed == kind.claimed;
    });
    if (!known) list.push_back(std::move(kind));
  };
  for (const TurnArcKind& arc : arcs_) {
    collect(below, arc, true);
    collect(above, arc, false);
  }

  for (const AtBoundary& x : below)
    for (const AtBoundary& y : above) {
      ++claims_[answers].cases;
      TwoLeasts exact{no_cost, no_cost};
      TwoLeasts claimed{no_cost, no_cost};
      for (const TurnEntry& one : entries_of(x.exact))
        for (const TurnEntry& other : entries_of(y.exact))
          offer(exact, ways_.one_between(one.turn_case, other.turn_case), one.cost + other.cost);
      for (const TurnEntry& one : entries_of(x.claimed))
        for (const TurnEntry& other : entries_of(y.claimed))
          offer(claimed, ways_.one_between(one.turn_case, other.turn_case), one.cost + other.cost);
      if (exact != claimed)
        fail(answers, certificate_.classes[0].line,
             fmt::format("missing case: of {}, A and {} something better can be made", name_of(x.word),
                         name_of(y.word)));
    }

  // Around D and A, with the boundary between them: the case of both together.
  struct SecondArc {
    std::string word;
    TurnCosts exact;
    TurnCosts claimed;
  };
  std::vector<SecondArc> seconds;
  const auto together = [](const TurnCosts& behind_d, const TurnCosts& before_a) {
    TurnCosts both;
    for (const TurnEntry& one : entries_of(behind_d))
      for (const TurnEntry& other : entries_of(before_a))
        both[turn_number({turn_case(one.turn_case).left, turn_case(other.turn_case).right}).value()] =
            one.cost + other.cost;
    return both;
  };
  for (const AtBoundary& y : above)
    for (const AtBoundary& x : below)
      seconds.push_back({fmt::format("{} and, behind the boundary, {}", name_of(y.word), name_of(x.word)),
                         together(y.exact, x.exact), together(y.claimed, x.claimed)});

  for (std::size_t i = 1; i < arcs_.size(); i += every) {
    const TurnArcKind& first = arcs_[i];
    for (std::size_t j = 1; j < arcs_.size(); ++j) check_pair(first, arcs_[j].costs, stated(arcs_[j]), arcs_[j].word);
    for (const SecondArc& second : seconds) check_pair(first, second.exact, second.claimed, second.word);

    ++claims_[answers].cases;
    TwoLeasts exact{no_cost, no_cost};
    TwoLeasts claimed{no_cost, no_cost};
    for (const TurnEntry& entry : entries_of(first.costs)) offer(exact, ways_.closed(entry.turn_case), entry.cost);
    for (const TurnEntry& entry : entries_of(stated(first))) offer(claimed, ways_.closed(entry.turn_case), entry.cost);
    if (exact != claimed)
      fail(answers, certificate_.classes[first.arc_class].line,
           fmt::format("missing case: of the closed fan {} something better can be made", first.word));
  }
}

}  // namespace restrip::verify
