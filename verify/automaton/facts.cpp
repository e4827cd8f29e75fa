#include "facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>

#include "arcs_around.hpp"

namespace restrip::verify {
namespace {

/// An arc, by what is best after an operation and by what may have been before it. A configuration before the operation
/// is any sound colouring for the key, so the fewest isolated triangles before are asked for on their own.
struct FactArc {
  std::string word;
  Worths best;                                                      ///< as in classes, less `base`
  std::array<std::optional<int>, all_cases.size()> least_isolated;  ///< minus the least possible, less that of `base`
};

/// Differences of isolated triangles beyond this are taken for this much: too small for it to matter, and never smaller
/// than they are, so that the worst is not underestimated.
constexpr int saturation = -4;

bool port(char letter) { return letter == 's' || letter == 'j'; }
std::size_t triangles(const std::string& word) {
  return word.size() - static_cast<std::size_t>(std::count(word.begin(), word.end(), 'b'));
}

/// The case of an arc and one element behind it; nothing where they do not fit.
std::optional<std::size_t> followed(Case arc, Case element, char letter) {
  if ((arc.right == '-') != (element.left == '-')) return {};
  if (arc.right == 'p' && element.left == 'p' && letter != 'j') return {};
  if (arc.right == 't' && element.left == 't') return number_of({'t', 't'});
  if (arc.right == 't') return number_of(element);
  if (element.left == 't') return number_of(arc);
  return number_of({arc.left, element.right});
}

template <class Number>
void keep_better(std::optional<Number>& best, Number value) {
  if (!best || *best < value) best = value;
}

/// One letter alone.
struct Element {
  Worths best;
  std::array<std::optional<int>, all_cases.size()> least_isolated;

  explicit Element(const std::string& word) {
    for_each_coloring(word, [&](const ArcColoring& c) {
      keep_better(best[c.arc_case], c.worth);
      keep_better(least_isolated[c.arc_case], c.worth.fewer_isolated);
    });
  }
};

FactArc longer(const FactArc& arc, char letter, const Element& element) {
  FactArc result{arc.word + letter, {}, {}};
  for (std::size_t c = 0; c < all_cases.size(); ++c)
    for (std::size_t e = 0; e < all_cases.size(); ++e) {
      const auto both = followed(all_cases[c], all_cases[e], letter);
      if (!both) continue;
      if (arc.best[c] && element.best[e]) keep_better(result.best[*both], *arc.best[c] + *element.best[e]);
      if (arc.least_isolated[c] && element.least_isolated[e])
        keep_better(result.least_isolated[*both], *arc.least_isolated[c] + *element.least_isolated[e]);
    }
  const Worth base = best_of(result.best);
  for (auto& worth : result.best)
    if (worth) worth = *worth - base;
  for (auto& least : result.least_isolated)
    if (least) least = std::max(*least - base.fewer_isolated, saturation);
  return result;
}

/// Two solid ports in a row of which the first is joined to the second, and the second not to the first: no key has
/// that where there are no other ports.
bool has_only_half_a_pair(const std::string& word) {
  std::string ports;
  std::copy_if(word.begin(), word.end(), std::back_inserter(ports), port);
  return ports == "js" && !has_boundary(word);
}

/// Whether some configuration has these letters, as far as they tell: the first port of an open fan is joined to none
/// before it, a lone port to none at all, and of two ports in a ring each is joined to the other or none is.
bool may_be_a_key(const std::string& x, const std::string& y) {
  std::string ports;
  const std::size_t boundary = std::min(y.find('b'), y.size());
  const std::string path = y.substr(boundary) + x + y.substr(0, boundary);
  std::copy_if(path.begin(), path.end(), std::back_inserter(ports), port);
  if (has_boundary(y) || ports.size() == 1) return ports.empty() || ports[0] == 's';
  return ports.size() != 2 || ports[0] == ports[1];
}

/// Arcs with the same text are the same to every context.
std::string key_of(const FactArc& arc) {
  std::string key = has_boundary(arc.word) ? "b" : "-";
  std::string ports;
  std::copy_if(arc.word.begin(), arc.word.end(), std::back_inserter(ports), port);
  key += ports.size() < 3 ? ports : ports.substr(0, 1) + "..";
  key += arc.word.size() == 1 ? " alone" : "";  // a = 1
  for (std::size_t c = 0; c < all_cases.size(); ++c) {
    key += arc.best[c] ? fmt::format(" {},{}", arc.best[c]->solid, arc.best[c]->fewer_isolated) : " none";
    key += arc.least_isolated[c] ? fmt::format(":{}", *arc.least_isolated[c]) : "";
  }
  return key;
}

std::vector<FactArc> all_arcs() {
  std::map<char, Element> elements;
  for (const char letter : letters) elements.emplace(letter, Element(std::string(1, letter)));
  const Element none("");
  std::vector<FactArc> arcs{{"", none.best, none.least_isolated}};
  std::map<std::string, std::size_t> seen{{key_of(arcs[0]), 0}};
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (const char letter : letters) {
      if (letter == 'b' && has_boundary(arcs[i].word)) continue;
      FactArc next = longer(arcs[i], letter, elements.at(letter));
      if (!seen.emplace(key_of(next), arcs.size()).second) continue;
      arcs.push_back(std::move(next));
      if (arcs.size() > 20000) throw std::logic_error("arcs do not close");
    }
  return arcs;
}

/// A way to put two cases together, and what it adds.
struct Way {
  std::size_t first = 0;
  std::size_t second = 0;
  std::vector<std::pair<ArcEnd, ArcEnd>> joined;
  Worth worth;
};

/// A and D with the chord between the arcs; without them, so that the arcs share their links; A alone between two arcs
/// of an open fan; or without it.
enum Between : std::size_t { with_chord, in_ring, with_one, in_path };

std::array<std::vector<Way>, 4> all_ways() {
  std::array<std::vector<Way>, 4> ways;
  for (const Around& way : all_around()) {
    const Case x = all_cases[way.first];
    const Case y = all_cases[way.second];
    ways[with_chord].push_back({way.first, way.second, way.joined, way.worth});
    if (way.chord) continue;
    // A node with both edges or none may be taken out of a ring: of its two edges one is left.
    const bool a_passed = (x.left == '-') == (y.right == '-');
    const bool d_passed = (x.right == '-') == (y.left == '-');
    if (a_passed && d_passed) ways[in_ring].push_back({way.first, way.second, way.joined, {}});
    // In an open fan nothing leads to A; D is the triangle that is there or not.
    if (x.left != '-' || y.right != '-') continue;
    const int alone = x.right == '-' && y.left == '-' ? 1 : 0;
    ways[with_one].push_back({way.first, way.second, way.joined, {x.right != '-' ? 1 : 0, -alone}});
    if (d_passed) ways[in_path].push_back({way.first, way.second, way.joined, {}});
  }
  return ways;
}

/// What can be had between two arcs: the best, and the least isolated triangles of any sound colouring.
/// Before a collapse a strip over the chord may also join ports of which the key says nothing.
struct Outcome {
  std::optional<Worth> best;
  std::optional<int> least_isolated;
};

Outcome outcome_of(const FactArc& x, const FactArc& y, const std::vector<Way>& ways, bool before_collapse = false) {
  // Which pairs of ends are joined is the same for all ways.
  std::array<std::array<std::optional<bool>, 4>, 4> known;
  const auto number = [](ArcEnd end) { return (end.second_arc ? 2U : 0U) + (end.right ? 1U : 0U); };
  Outcome outcome;
  for (const Way& way : ways) {
    if (!x.best[way.first] || !y.best[way.second]) continue;
    const bool sound = std::all_of(way.joined.begin(), way.joined.end(), [&](const auto& pair) {
      auto& answer = known[number(pair.first)][number(pair.second)];
      if (!answer)
        answer = joined_before(x.word, y.word, pair.first, pair.second) ||
                 (before_collapse && !in_key(x.word, y.word, pair.first, pair.second));
      return *answer;
    });
    if (!sound) continue;
    keep_better(outcome.best, *x.best[way.first] + *y.best[way.second] + way.worth);
    keep_better(outcome.least_isolated,
                *x.least_isolated[way.first] + *y.least_isolated[way.second] + way.worth.fewer_isolated);
  }
  return outcome;
}

class Collector {
 public:
  void add(const std::string& operations, const char* measure, int cost, std::size_t k, const std::string& witness) {
    if (!witness_is_a_key_ && k < no_witness) return add(operations, measure, cost, no_witness, "");
    for (Fact& fact : facts) {
      if (fact.operations != operations || fact.measure != measure) continue;
      if (cost > fact.worst || (cost == fact.worst && k < fact.k)) fact = {operations, measure, cost, k, witness};
      return;
    }
    facts.push_back({operations, measure, cost, k, witness});
  }

  /// An operation that leads from `before` to `after` and adds so many triangles.
  void add(const std::string& operations, const Outcome& before, const Outcome& after, int added, std::size_t k,
           const std::string& witness) {
    if (!before.best || !after.best) return;
    add(operations, "strips", added - (after.best->solid - before.best->solid), k, witness);
    add(operations, "isolated", *before.least_isolated - after.best->fewer_isolated, k, witness);
  }

  /// Whether the pairs that follow can be witnesses. Those that cannot count as well: others of their kind may be.
  void set_witness(bool is_a_key) { witness_is_a_key_ = is_a_key; }

  std::vector<Fact> facts;

 private:
  static constexpr std::size_t no_witness = 1000;
  bool witness_is_a_key_ = true;
};

}  // namespace

Facts facts_of_every_fan() {
  const std::vector<FactArc> arcs = all_arcs();
  const auto ways = all_ways();
  Collector collector;
  Facts result;
  result.arcs = arcs.size();
  for (const FactArc& x : arcs) {
    if (has_boundary(x.word)) continue;
    for (const FactArc& y : arcs) {
      const bool open = has_boundary(y.word);
      const bool ports_in_x = std::any_of(x.word.begin(), x.word.end(), port);
      const bool ports_in_y = std::any_of(y.word.begin(), y.word.end(), port);
      if ((!ports_in_y && has_only_half_a_pair(x.word)) || (!ports_in_x && has_only_half_a_pair(y.word))) continue;
      const std::size_t k = triangles(x.word) + triangles(y.word);
      const std::string witness = fmt::format("{} {}", x.word.empty() ? "-" : x.word, y.word.empty() ? "-" : y.word);
      if (!open && k >= 1) {
        ++result.pairs;
        collector.set_witness(may_be_a_key(x.word, y.word + "b"));
        const Outcome without = outcome_of(x, y, ways[in_path]);
        const Outcome with = outcome_of(x, y, ways[with_one]);
        collector.add("boundary split", without, with, 1, k, witness);
        collector.add("boundary collapse", with, without, -1, k, witness);
      }
      if (x.word.empty() || y.word.empty() || (!open && k < 3)) continue;
      ++result.pairs;
      collector.set_witness(may_be_a_key(x.word, y.word));
      const Outcome ring = outcome_of(x, y, ways[in_ring]);
      const Outcome chord = outcome_of(x, y, ways[with_chord]);
      collector.add(open ? "open split" : "split", ring, chord, 2, k, witness);
      if (!open && x.word.size() == 1) collector.add("split with a = 1", ring, chord, 2, k, witness);
      const Outcome before = outcome_of(x, y, ways[with_chord], true);
      collector.add(open ? "open collapse" : "collapse", before, ring, -2, k, witness);
    }
  }
  result.facts = collector.facts;
  std::sort(result.facts.begin(), result.facts.end(), [](const Fact& one, const Fact& other) {
    return std::pair(one.operations, one.measure) < std::pair(other.operations, other.measure);
  });
  return result;
}

std::string table_of(const Facts& facts) {
  std::string text =
      "| operation | measure | at most | first met with k | first arc, second arc |\n| --- | --- | --- | --- | --- |\n";
  for (const Fact& fact : facts.facts)
    text += fmt::format("| {} | {} | {} | {} | `{}` |\n", fact.operations, fact.measure,
                        fact.worst == 0 ? "0" : fmt::format("{:+}", fact.worst), fact.k, fact.witness);
  return text + fmt::format("\n{} kinds of arcs, {} pairs.\n", facts.arcs, facts.pairs);
}

}  // namespace restrip::verify
