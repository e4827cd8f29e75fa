#include "automaton/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>

#include "automaton/arcs_around.hpp"

namespace restrip::verify {
namespace {

/// Isolated triangles alone.
constexpr Weights isolated_weights{0, 0, 1};

/// A cost of strips as strips more and isolated triangles more than some other arc has; these are few.
struct Worth {
  int strips = 0;
  int isolated = 0;

  explicit Worth(int cost) {
    const int high = cost + 500 * strips_weights.restart;
    strips = (high + strips_weights.restart / 2) / strips_weights.restart - 500;
    isolated = cost - strips * strips_weights.restart;
  }
};

/// An arc, by what is best after an operation and by what may have been before it. A configuration before the operation
/// is any sound colouring for the key, so the fewest isolated triangles before are asked for on their own.
struct FactArc {
  std::string word;
  Costs best;            ///< less the least of them
  Costs least_isolated;  ///< less the isolated triangles of the same
};

/// Differences of isolated triangles beyond this are taken for this much: too large for it to matter, and never larger
/// than they are, so that the worst is not underestimated.
constexpr int saturation = 4;

std::size_t triangles(const std::string& word) {
  return word.size() - static_cast<std::size_t>(std::count(word.begin(), word.end(), 'b'));
}

/// The case of an arc and one element behind it; nothing where they do not fit.
std::optional<std::size_t> followed(Case arc, Case element, char letter) {
  if ((arc.right == '-') != (element.left == '-')) return {};
  if (arc.right == 'p' && element.left == 'p' && !is_joined(letter)) return {};
  if (arc.right == 't' && element.left == 't') return through;
  if (arc.right == 't') return number_of(element);
  if (element.left == 't') return number_of(arc);
  return number_of({arc.left, element.right});
}

void keep_less(std::optional<int>& least, int cost) {
  if (!least || cost < *least) least = cost;
}

/// One letter alone.
struct Element {
  Costs best;
  Costs least_isolated;

  explicit Element(char letter) {
    for (Mask links = 0; links < mask_count(2); ++links) {
      const std::string word(1, letter);
      const ArcColoring c = arc_coloring(word, links, strips_weights);
      if (!c.sound) continue;
      keep_less(best[c.arc_case], c.cost);
      keep_less(least_isolated[c.arc_case], arc_coloring(word, links, isolated_weights).cost);
    }
  }
};

FactArc longer(const FactArc& arc, char letter, const Element& element) {
  FactArc result{arc.word + letter, {}, {}};
  for (std::size_t c = 0; c < case_count; ++c)
    for (std::size_t e = 0; arc.best[c] && e < case_count; ++e) {
      if (!element.best[e]) continue;
      const auto both = followed(case_at(c), case_at(e), letter);
      if (!both) continue;
      keep_less(result.best[*both], *arc.best[c] + *element.best[e]);
      keep_less(result.least_isolated[*both], *arc.least_isolated[c] + *element.least_isolated[e]);
    }
  const int base = least_of(result.best);
  result.best = shifted(result.best, -base);
  result.least_isolated = shifted(result.least_isolated, -Worth(base).isolated);
  for (auto& least : result.least_isolated)
    if (least) least = std::min(*least, saturation);
  return result;
}

/// Two solid ports in a row of which the first is joined to the second, and the second not to the first: no key has
/// that where there are no other ports.
bool has_only_half_a_pair(const std::string& word) { return ports_in(word) == "Ss" && !has_boundary(word); }

/// Whether some configuration has these letters, as far as they tell: the first port of an open fan is joined to none
/// before it, a lone port to none at all, and of two ports in a ring each is joined to the other or none is.
bool may_be_a_key(const std::string& x, const std::string& y) {
  const std::size_t boundary = std::min(y.find('b'), y.size());
  const std::string path = y.substr(boundary) + x + y.substr(0, boundary);
  const std::string ports = ports_in(path);
  if (has_boundary(y) || ports.size() == 1) return ports.empty() || ports[0] == 's';
  return ports.size() != 2 || ports[0] == ports[1];
}

/// Arcs with the same text are the same to every context.
std::string key_of(const FactArc& arc) {
  std::string key = has_boundary(arc.word) ? "b" : "-";
  key += end_ports(arc.word);
  key += arc.word.size() == 1 ? " alone" : "";  // a = 1
  for (std::size_t c = 0; c < case_count; ++c)
    key += arc.best[c] ? fmt::format(" {}:{}", *arc.best[c], *arc.least_isolated[c]) : " none";
  return key;
}

std::vector<FactArc> all_arcs() {
  std::map<char, Element> elements;
  for (const char letter : letters_of(strips_weights)) elements.emplace(letter, letter);
  Costs empty;
  empty[both_dashed] = empty[through] = 0;
  std::vector<FactArc> arcs{{"", empty, empty}};
  std::map<std::string, std::size_t> seen{{key_of(arcs[0]), 0}};
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (const char letter : letters_of(strips_weights)) {
      if (is_boundary(letter) && has_boundary(arcs[i].word)) continue;
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
  Mask joined = 0;
  int cost = 0;
};

/// A and D with the chord between the arcs; without them, so that the arcs share their links; A alone between two arcs
/// of an open fan; or without it.
enum Between : std::size_t { with_chord, in_ring, with_one, in_path };

std::array<std::vector<Way>, 4> all_ways() {
  const ArcWays known(strips_weights);
  std::array<std::vector<Way>, 4> ways;
  const auto add = [&](std::size_t first, std::size_t second, bool chord) {
    const ArcWay& way = known.around(first, second, chord);
    if (!way.legal) return;
    const Case x = case_at(first);
    const Case y = case_at(second);
    ways[with_chord].push_back({first, second, way.joined, way.cost});
    if (chord) return;
    // A node with both edges or none may be taken out of a ring: of its two edges one is left.
    const bool a_passed = (x.left == '-') == (y.right == '-');
    const bool d_passed = (x.right == '-') == (y.left == '-');
    if (a_passed && d_passed) ways[in_ring].push_back({first, second, way.joined, 0});
    // In an open fan nothing leads to A; D is the triangle that is there or not.
    if (x.left != '-' || y.right != '-') return;
    const int alone = x.right == '-' && y.left == '-' ? strips_weights.isolated : 0;
    ways[with_one].push_back({first, second, way.joined, alone - (x.right != '-' ? strips_weights.restart : 0)});
    if (d_passed) ways[in_path].push_back({first, second, way.joined, 0});
  };
  const auto is_plain = [](std::size_t c) { return case_at(c).text().find_first_of("fqo") == std::string::npos; };
  for (std::size_t first = 0; first < case_count; ++first)
    for (std::size_t second = 0; is_plain(first) && second < case_count; ++second)
      for (const bool chord : {false, true})
        if (is_plain(second)) add(first, second, chord);
  return ways;
}

/// What can be had between two arcs: the best, and the least isolated triangles of any sound colouring.
struct Outcome {
  std::optional<int> best;
  std::optional<int> least_isolated;
};

Outcome outcome_of(const FactArc& x, const FactArc& y, const std::vector<Way>& ways, Mask allowed) {
  Outcome outcome;
  for (const Way& way : ways) {
    if (!x.best[way.first] || !y.best[way.second] || !is_subset(way.joined, allowed)) continue;
    keep_less(outcome.best, *x.best[way.first] + *y.best[way.second] + way.cost);
    keep_less(outcome.least_isolated,
              *x.least_isolated[way.first] + *y.least_isolated[way.second] + Worth(way.cost).isolated);
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
    add(operations, "strips", added + Worth(*after.best).strips - Worth(*before.best).strips, k, witness);
    add(operations, "isolated", Worth(*after.best).isolated - *before.least_isolated, k, witness);
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
      if ((ports_in(y.word).empty() && has_only_half_a_pair(x.word)) ||
          (ports_in(x.word).empty() && has_only_half_a_pair(y.word)))
        continue;
      const Mask joined = pairs_joined_before(x.word, y.word);
      const std::size_t k = triangles(x.word) + triangles(y.word);
      const std::string witness = fmt::format("{} {}", x.word.empty() ? "-" : x.word, y.word.empty() ? "-" : y.word);
      if (!open && k >= 1) {
        ++result.pairs;
        collector.set_witness(may_be_a_key(x.word, y.word + "b"));
        const Outcome without = outcome_of(x, y, ways[in_path], joined);
        const Outcome with = outcome_of(x, y, ways[with_one], joined);
        collector.add("boundary split", without, with, 1, k, witness);
        collector.add("boundary collapse", with, without, -1, k, witness);
      }
      if (x.word.empty() || y.word.empty() || (!open && k < 3)) continue;
      ++result.pairs;
      collector.set_witness(may_be_a_key(x.word, y.word));
      const Outcome ring = outcome_of(x, y, ways[in_ring], joined);
      const Outcome chord = outcome_of(x, y, ways[with_chord], joined);
      collector.add(open ? "open split" : "split", ring, chord, 2, k, witness);
      if (!open && x.word.size() == 1) collector.add("split with a = 1", ring, chord, 2, k, witness);
      // Before a collapse a strip over the chord may also join ports of which the key says nothing.
      const Outcome before = outcome_of(x, y, ways[with_chord], joined | ~pairs_in_key(x.word, y.word));
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
