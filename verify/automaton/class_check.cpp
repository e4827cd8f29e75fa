#include "automaton/class_check.hpp"

#include <fmt/format.h>

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "automaton/arc.hpp"

namespace restrip::verify {
namespace {

/// The longest words from which joints are observed, and the longest arc of a kind before the kinds are reported not to
/// close.
constexpr std::size_t longest_joint = 6;
constexpr std::size_t longest_kind = 100;

/// An arc followed by a letter.
struct ArcJoint {
  bool sound = false;
  std::size_t arc_case = 0;
  friend bool operator==(const ArcJoint&, const ArcJoint&) = default;
};

/// The combination of the cases of an arc and a following letter, observed in all colourings of all words of up to
/// `longest_joint` letters. It is a failure if two colourings with the same cases disagree in the case of the whole,
/// its cost or its soundness, or if the longest words show a new combination.
struct ArcJoints {
  std::vector<std::optional<ArcJoint>> joints;  ///< empty if links of different colours meet
  std::uint64_t colorings = 0;
  Failures failures;

  static std::size_t place(std::size_t arc_case, std::size_t own_case, char letter) {
    return 2 * (case_count * arc_case + own_case) + (is_joined(letter) ? 1U : 0U);
  }
};

ArcJoints observed_joints() {
  ArcJoints observed;
  observed.joints.resize(2 * case_count * case_count);
  std::vector<std::string> words{""};
  for (std::size_t length = 1; length <= longest_joint; ++length) {
    std::vector<std::string> longer;
    for (const std::string& word : words)
      for (const char letter : letters)
        if (!is_boundary(letter) || !has_boundary(word)) longer.push_back(word + letter);
    words = std::move(longer);
    if (length < 2) continue;
    const auto last = static_cast<unsigned>(length - 1);
    for (const std::string& word : words)
      for (Mask links = 0; links < mask_count(last + 2); ++links) {
        const ArcColoring alone = arc_coloring(word.substr(last), high_part(links, last));
        if (!alone.sound) continue;
        const ArcColoring arc = arc_coloring(std::string_view(word).substr(0, last), low_part(links, last + 1));
        if (!arc.sound) continue;
        ++observed.colorings;
        const ArcColoring whole = arc_coloring(word, links);
        const ArcJoint seen = whole.sound ? ArcJoint{true, whole.arc_case} : ArcJoint{};
        std::optional<ArcJoint>& known = observed.joints[ArcJoints::place(arc.arc_case, alone.arc_case, word[last])];
        const auto fail = [&](const char* what) {
          observed.failures.add(fmt::format("the arc {} with the links {:x}: {}", word, links, what));
        };
        if (whole.sound && whole.cost != arc.cost + alone.cost) fail("its cost is not the sum of its parts' costs");
        if (known && *known != seen) fail("the cases of its parts do not determine the case of the whole");
        if (!known && length == longest_joint) fail("it has cases that shorter arcs do not have");
        known = seen;
      }
  }
  return observed;
}

/// They do not depend on any certificate.
const ArcJoints& all_joints() {
  static const ArcJoints joints = observed_joints();
  return joints;
}

std::string name_of(const std::string& word) { return word.empty() ? "-" : word; }

/// Arcs distinguished by the least cost of each case and by their end ports, together with the class that the
/// certificate assigns to them: finitely many kinds, which include all arcs.
struct ArcKind {
  std::string word;  ///< one of the shortest
  std::string ports;
  Costs costs;                                       ///< minus the least of them
  std::vector<std::pair<std::size_t, int>> entries;  ///< the same, existing ones only
  std::size_t arc_class = 0;
  int offset = 0;          ///< their excess over the certificate's values
  bool comparable = true;  ///< false if they differ by more than an offset, which has been reported
};

/// An arc with one more letter, and the cases without the letter from which its least costs come.
struct Longer {
  Costs costs;
  std::array<Mask, case_count> from{};

  void offer(std::size_t c, std::size_t before, int cost) {
    if (costs[c] && *costs[c] < cost) return;
    if (!costs[c] || *costs[c] > cost) from[c] = 0;
    costs[c] = cost;
    from[c] |= single(static_cast<unsigned>(before));
  }
};

class ClassChecker {
 public:
  explicit ClassChecker(const AutomatonCertificate& certificate) : certificate_(certificate) {}

  ClassCheck run() {
    claims_[joints].cases = all_joints().colorings;
    claims_[joints].failures = all_joints().failures;
    check_witnesses();
    explore();
    check_meetings();
    return {claims_, arcs_.size()};
  }

 private:
  enum Which : std::size_t { joints, witnesses, values, costs, origins, meetings, closings };

  bool states(const ArcKind& arc, std::size_t arc_case) const {
    return certificate_.classes[arc.arc_class].costs[arc_case].has_value();
  }
  void fail(Which which, unsigned line, const std::string& what) {
    claims_[which].failures.add(fmt::format("{}:{}: {}", certificate_.file, line, what));
  }

  void check_witnesses() {
    // The first of the shortest arcs of each class, found breadth first from the steps; empty for a class to which no
    // arc leads.
    std::vector<std::optional<std::string>> shortest(certificate_.classes.size());
    std::deque<std::size_t> waiting{0};
    shortest[0] = "";
    for (; !waiting.empty(); waiting.pop_front())
      for (const char letter : letters) {
        const AutomatonStep* const step = certificate_.step(waiting.front(), letter);
        if (step == nullptr || shortest[step->to]) continue;
        shortest[step->to] = *shortest[waiting.front()] + letter;
        waiting.push_back(step->to);
      }
    for (std::size_t c = 0; c < certificate_.classes.size(); ++c) {
      ++claims_[witnesses].cases;
      const AutomatonClass& stated = certificate_.classes[c];
      if (!shortest[c])
        fail(witnesses, stated.line, fmt::format("wrong witness: no arc leads to class {}", c));
      else if (*shortest[c] != stated.witness)
        fail(witnesses, stated.line,
             fmt::format("wrong witness: {} for class {}, the shortest is {}", stated.witness, c, *shortest[c]));
    }
  }

  /// The index of an arc's kind; it is new if no equal one was seen.
  std::size_t place_of(const std::string& word, const Costs& absolute, std::size_t arc_class) {
    const int least = least_of(absolute);
    Costs relative = absolute;
    for (auto& cost : relative)
      if (cost) *cost -= least;
    const std::string ports = end_ports(word);
    const auto [place, is_new] =
        places_.emplace(std::tuple{arc_class, has_boundary(word), ports, relative}, arcs_.size());
    if (!is_new) return place->second;
    ArcKind arc{word, ports, relative, {}, arc_class, 0, true};
    for (std::size_t c = 0; c < case_count; ++c)
      if (relative[c]) arc.entries.emplace_back(c, *relative[c]);
    const AutomatonClass& stated = certificate_.classes[arc_class];
    std::optional<int> offset;
    for (std::size_t c = 0; c < case_count; ++c) {
      if (!stated.costs[c]) continue;
      ++claims_[values].cases;
      if (!relative[c] || (offset && *relative[c] - *stated.costs[c] != *offset)) {
        arc.comparable = false;
        fail(values, stated.line,
             fmt::format("wrong value: case {} of class {}, arc {}", case_at(c).text(), arc_class, name_of(word)));
        break;
      }
      offset = *relative[c] - *stated.costs[c];
    }
    arc.offset = offset.value_or(0);
    // A whole open fan has the case with both links dashed.
    if (relative[both_dashed] && !stated.costs[both_dashed])
      fail(values, stated.line, fmt::format("missing value: case -- of class {}", arc_class));
    if (has_boundary(word) != stated.has_boundary() || word.empty() != stated.witness.empty())
      fail(values, stated.line, fmt::format("wrong class: {} for the arc {}", arc_class, name_of(word)));
    arcs_.push_back(arc);
    return place->second;
  }

  Longer longer(const ArcKind& arc, char letter) const {
    Longer result;
    for (Mask links = 0; links < mask_count(2); ++links) {
      const ArcColoring alone = arc_coloring(std::string(1, letter), links);
      if (!alone.sound) continue;
      for (std::size_t before = 0; before < case_count; ++before) {
        if (!arc.costs[before]) continue;
        if (arc.word.empty()) {
          // The two links of the empty arc are one edge.
          if ((before == both_dashed) == !is_solid(links, 0)) result.offer(alone.arc_case, before, alone.cost);
          continue;
        }
        const auto& joint = all_joints().joints[ArcJoints::place(before, alone.arc_case, letter)];
        if (!joint || !joint->sound) continue;
        result.offer(joint->arc_case, before, *arc.costs[before] + alone.cost);
      }
    }
    return result;
  }

  void check_step(std::size_t at, char letter) {
    const ArcKind arc = arcs_[at];
    const AutomatonStep& step = *certificate_.step(arc.arc_class, letter);
    const std::string word = arc.word + letter;
    const Longer next_arc = longer(arc, letter);
    const int added = least_of(next_arc.costs);
    const ArcKind& next = arcs_[place_of(word, next_arc.costs, step.to)];
    if (!next.comparable || !arc.comparable) return;
    ++claims_[costs].cases;
    if (step.cost - added != next.offset - arc.offset)
      fail(costs, step.line,
           fmt::format("wrong cost: {} where the arc {} costs {} more", step.cost, word,
                       added + next.offset - arc.offset));
    for (std::size_t c = 0; c < case_count; ++c) {
      if (!certificate_.classes[step.to].costs[c]) continue;
      ++claims_[origins].cases;
      const std::size_t before = step.from[c];
      if (!is_solid(next_arc.from[c], static_cast<unsigned>(before)) || !states(arc, before))
        fail(origins, step.line,
             fmt::format("wrong origin: no best colouring of {} with case {} has case {} before its last letter", word,
                         case_at(c).text(), case_at(before).text()));
    }
  }

  void explore() {
    Costs empty;
    empty[both_dashed] = 0;
    empty[through] = 0;
    place_of("", empty, 0);
    if (arcs_[0].offset != 0) fail(values, certificate_.classes[0].line, "wrong value: the empty arc costs nothing");
    for (std::size_t at = 0; at < arcs_.size(); ++at)
      for (const char letter : letters) {
        // A class with the boundary inside, assigned to an arc without it, has been reported.
        if (certificate_.step(arcs_[at].arc_class, letter) == nullptr) continue;
        if (is_boundary(letter) && has_boundary(arcs_[at].word)) continue;
        if (arcs_[at].word.size() >= longest_kind) {
          fail(values, certificate_.classes[arcs_[at].arc_class].line,
               fmt::format("the arcs do not close: {} is still new", arcs_[at].word));
          return;
        }
        check_step(at, letter);
      }
  }

  void check_meeting(const ArcKind& x, const ArcKind& y) {
    ++claims_[meetings].cases;
    const AutomatonMeeting& stated = certificate_.meeting(x.arc_class, y.arc_class);
    const auto [place, is_new] = allowed_.emplace(std::pair{x.ports, y.ports}, 0);
    if (is_new) place->second = pairs_joined_before(x.word, y.word);
    const Mask allowed = place->second;
    const auto possible = [&](const ArcWay& way) { return way.legal && is_subset(way.joined, allowed); };
    const auto arcs = [&] { return fmt::format("the arcs {} and {}", x.word, y.word); };
    const ArcWay& own = ways_.around(stated.first, stated.second, stated.chord);
    if (!possible(own) || !states(x, stated.first) || !states(y, stated.second))
      return fail(meetings, stated.line, fmt::format("unsound meeting: {}", arcs()));
    const int own_cost = *x.costs[stated.first] + *y.costs[stated.second] + own.cost;
    for (const auto& [one, of_x] : x.entries)
      for (const auto& [other, of_y] : y.entries)
        for (const bool chord : {false, true}) {
          const ArcWay& way = ways_.around(one, other, chord);
          if (!possible(way) || of_x + of_y + way.cost >= own_cost) continue;
          return fail(
              meetings, stated.line,
              fmt::format("not the best meeting: {}, {} {}{} costs {} less", arcs(), case_at(one).text(),
                          case_at(other).text(), chord ? " with the chord" : "", own_cost - of_x - of_y - way.cost));
        }
  }

  void check_closing(const ArcKind& arc) {
    const auto& stated = certificate_.closings[arc.arc_class];
    if (!stated) return;
    ++claims_[closings].cases;
    const bool may_join = joined_before(arc.word, "", first_left, first_right);
    const auto cost_of = [&](std::size_t c) -> std::optional<int> {
      const ArcWay& way = ways_.closed(c);
      if (!arc.costs[c] || !way.legal || (way.joined != 0 && !may_join)) return {};
      return *arc.costs[c] + way.cost;
    };
    const auto own = cost_of(stated->arc);
    if (!own || !states(arc, stated->arc))
      return fail(closings, stated->line, fmt::format("unsound closing: {}", arc.word));
    for (std::size_t c = 0; c < case_count; ++c)
      if (const auto cost = cost_of(c); cost && *cost < *own)
        return fail(
            closings, stated->line,
            fmt::format("not the best closing: {}, {} costs {} less", arc.word, case_at(c).text(), *own - *cost));
  }

  void check_meetings() {
    for (std::size_t i = 1; i < arcs_.size(); ++i) {
      const ArcKind& x = arcs_[i];
      if (!x.comparable) continue;
      check_closing(x);
      if (!certificate_.classes[x.arc_class].as_first) continue;
      for (const ArcKind& y : arcs_)
        if (y.comparable && certificate_.classes[y.arc_class].as_second) check_meeting(x, y);
    }
  }

  const AutomatonCertificate& certificate_;
  const ArcWays ways_;
  std::vector<AutomatonClaim> claims_{
      {"an arc and a following letter matter by their cases", "all colourings of all arcs of up to 6", 0, {}},
      {"each witness is a shortest arc of its class", "steps followed, breadth first", 0, {}},
      {"the values are the least costs", "arcs put together letter by letter", 0, {}},
      {"what a letter costs", "the same", 0, {}},
      {"every case comes from the stated case", "the same, without the last letter", 0, {}},
      {"every meeting is sound and best", "all pairs of cases around A and D", 0, {}},
      {"every closing is sound and best", "all cases around a closed fan", 0, {}}};
  std::vector<ArcKind> arcs_;
  std::map<std::tuple<std::size_t, bool, std::string, Costs>, std::size_t> places_;
  std::map<std::pair<std::string, std::string>, Mask> allowed_;  ///< by end ports of two arcs
};

}  // namespace

ClassCheck check_classes(const AutomatonCertificate& certificate) { return ClassChecker(certificate).run(); }

}  // namespace restrip::verify
