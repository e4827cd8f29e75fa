#include "certify/certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace restrip::generator {
namespace {

/// The claim to show: a minimum of dashed edges; for that number, a minimum of isolated triangles; and so on.
struct ReasonGoal {
  EdgeSet edges = 0;               ///< edges that a recolouring may leave dashed
  unsigned inner_edges = 0;        ///< edges from this number on are ports
  std::vector<EdgeSet> sets;       ///< none of them can be all solid
  std::vector<EdgeSet> triangles;  ///< each is isolated if all of these are dashed
  int dashed = 0;
  int isolated = 0;
  int given_up = 0;
};

/// Every simple path of inner edges from `at` to `goal` that avoids the nodes `used` and the edges `avoided`.
void collect_paths(const Side& side, unsigned at, unsigned goal, EdgeSet avoided, Mask used, EdgeSet path,
                   std::vector<EdgeSet>& found) {
  if (at == goal) {
    found.push_back(path);
    return;
  }
  used |= Mask{1} << at;
  for (std::size_t e = 0; e < side.edges.size(); ++e) {
    const auto [u, v] = side.edges[e];
    if ((avoided & single(e)) != 0 || (u != at && v != at)) continue;
    const unsigned next = u == at ? v : u;
    if ((used >> next & 1U) == 0) collect_paths(side, next, goal, avoided, used, path | single(e), found);
  }
}

/// A leaf of a greedy tree gives up after this number of steps and splits into cases.
constexpr std::uint64_t most_steps_of_leaf = 2000;

bool smaller(EdgeSet x, EdgeSet y) { return std::tuple{std::popcount(x), x} < std::tuple{std::popcount(y), y}; }

/// Searches for reasons of one goal and counts its steps: one for each visited state, and one for each set examined in
/// a state. A state says which edges are settled as solid or as dashed.
class ReasonSearch {
 public:
  explicit ReasonSearch(const ReasonGoal& goal) : goal_(goal) {}

  /// The first smallest tree in a fixed order; empty if that takes more steps. Exponential in the leaves.
  std::optional<Reason> smallest(std::uint64_t most_steps) {
    last_step_ = steps_ + most_steps;
    for (std::size_t leaves = 1; steps_ <= last_step_; ++leaves)
      if (const Reason* const found = find(0, 0, leaves)) return *found;
    return {};
  }

  /// A tree that need not be smallest: it splits on the edge that is in most small sets.
  Reason greedy(EdgeSet solid = 0, EdgeSet dashed = 0) {
    const std::vector<EdgeSet> sets = open_sets(solid, dashed);
    last_step_ = steps_ + most_steps_of_leaf;
    if (std::optional<Reason> found = leaf(sets, dashed)) return *std::move(found);
    // An edge in a set of one is dashed in any case. Without other edges, all sets have one edge, and the leaf
    // was found above.
    unsigned best = 0;
    std::uint64_t most = 0;
    for (unsigned edge = 0; edge < 32; ++edge) {
      std::uint64_t weight = 0;
      for (const EdgeSet set : sets)
        if (!std::has_single_bit(set) && (set & single(edge)) != 0)
          weight += std::uint64_t{1} << (32 - std::popcount(set));
      if (weight > most) {
        most = weight;
        best = edge;
      }
    }
    return {best, {greedy(solid | single(best), dashed), greedy(solid, dashed | single(best))}, {}};
  }

  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  struct Known {
    std::size_t too_few = 0;  ///< no tree has this number of leaves
    std::optional<Reason> reason;
  };

  /// Sets of the goal that still matter, none of which contains another, in ascending order of (size, set).
  std::vector<EdgeSet> open_sets(EdgeSet solid, EdgeSet dashed) {
    std::vector<EdgeSet> open;
    for (const EdgeSet set : goal_.sets)
      if ((set & dashed) == 0) open.push_back(set & ~solid);
    std::sort(open.begin(), open.end(), smaller);
    std::vector<EdgeSet> kept;
    for (const EdgeSet set : open)
      if (std::none_of(kept.begin(), kept.end(), [&](EdgeSet other) { return (other & ~set) == 0; }))
        kept.push_back(set);
    steps_ += goal_.sets.size();
    return kept;
  }

  /// The first `count` disjoint sets in the order of the list.
  bool choose_disjoint(const std::vector<EdgeSet>& sets, std::size_t from, int count, EdgeSet taken,
                       std::vector<EdgeSet>& chosen) {
    if (count <= 0) return true;
    for (std::size_t i = from; i < sets.size() && steps_ <= last_step_; ++i) {
      ++steps_;
      if ((sets[i] & taken) != 0) continue;
      chosen.push_back(sets[i]);
      if (choose_disjoint(sets, i + 1, count - 1, taken | sets[i], chosen)) return true;
      chosen.pop_back();
    }
    return false;
  }

  std::optional<Reason> leaf(const std::vector<EdgeSet>& sets, EdgeSet dashed) {
    // If an edge must be dashed, the case that it is solid is empty: no smallest tree has such a case.
    if (!sets.empty() && sets.front() == 0) return {};
    const int missing = goal_.dashed - std::popcount(dashed);
    const bool only_dashed_counts = goal_.isolated == 0 && goal_.given_up == 0;
    for (const int count : {missing, missing + 1}) {
      Reason reason;
      if (!choose_disjoint(sets, 0, count, 0, reason.sets)) return {};
      EdgeSet surely_dashed = dashed;
      for (const EdgeSet set : reason.sets)
        if (std::has_single_bit(set)) surely_dashed |= set;
      const int given_up = std::popcount(surely_dashed >> goal_.inner_edges);
      const auto isolated = std::count_if(goal_.triangles.begin(), goal_.triangles.end(),
                                          [&](EdgeSet edges) { return (edges & ~surely_dashed) == 0; });
      if (only_dashed_counts || count > missing ||
          std::tuple{static_cast<int>(isolated) + given_up, given_up} >= std::tuple{goal_.isolated, goal_.given_up})
        return reason;
    }
    return {};
  }

  /// A tree of at most `leaves` leaves, such that no tree has fewer; null if no such tree exists or the steps are used
  /// up. It first searches for trees with one leaf, then two, and so on, and limits each case accordingly. So it is
  /// never called with more leaves than the smallest tree has, and its result depends on the state alone and can be
  /// cached.
  const Reason* find(EdgeSet solid, EdgeSet dashed, std::size_t leaves) {
    if (++steps_ > last_step_) return nullptr;
    Known& known = known_[std::uint64_t{solid} << 32U | dashed];  // its address stays valid when others are added
    if (known.reason) return known.reason->leaves() <= leaves ? &*known.reason : nullptr;
    if (known.too_few == 0) known.reason = leaf(open_sets(solid, dashed), dashed);
    if (known.reason) return &*known.reason;
    if (known.too_few >= leaves) return nullptr;
    for (unsigned edge = 0; leaves > 1 && edge < 32; ++edge) {
      if ((goal_.edges & ~solid & ~dashed & single(edge)) == 0) continue;
      for (std::size_t first = 1; first < leaves; ++first) {
        const Reason* const when_solid = find(solid | single(edge), dashed, first);
        if (when_solid == nullptr) continue;
        const Reason* const when_dashed = find(solid, dashed | single(edge), leaves - first);
        if (when_dashed == nullptr) break;
        known.reason = Reason{edge, {*when_solid, *when_dashed}, {}};
        return &*known.reason;
      }
    }
    if (steps_ <= last_step_) known.too_few = leaves;
    return nullptr;
  }

  const ReasonGoal& goal_;
  std::unordered_map<std::uint64_t, Known> known_;
  std::uint64_t steps_ = 0;
  std::uint64_t last_step_ = 0;
};

}  // namespace

std::size_t Reason::leaves() const { return cases.empty() ? 1 : cases[0].leaves() + cases[1].leaves(); }

std::string Reason::text() const {
  if (!cases.empty()) return fmt::format("if {} then {} else {}", edge, cases[0].text(), cases[1].text());
  std::string words;
  for (const EdgeSet set : sets) words += fmt::format("{}{:x}", words.empty() ? "" : " ", set);
  return words.empty() ? "-" : words;
}

bool has_reasons(const Operation& operation) {
  const Preference first = fewest_strips();
  return operation.constraint.most_edges >= 2 && operation.preference.size() >= first.size() &&
         std::equal(first.begin(), first.end(), operation.preference.begin());
}

Reasoner::Reasoner(const Operation& operation) : may_give_up_(operation.may_give_up), after_(operation.patch.after) {
  const std::size_t inner = after_.edges.size();
  const auto port = [&](std::size_t p) { return single(inner + p); };
  for (unsigned node = 0; node < after_.nodes; ++node) {
    EdgeSet edges = 0;
    for (std::size_t e = 0; e < inner; ++e)
      if (after_.edges[e].u == node || after_.edges[e].v == node) edges |= single(e);
    for (std::size_t p = 0; p < after_.owner.size(); ++p)
      if (after_.owner[p] == node) edges |= port(p);
    edges_of_triangle_.push_back(edges);
    if (std::popcount(edges) > static_cast<int>(operation.constraint.most_edges)) forbidden_.push_back({edges, 0});
  }
  const auto forbid_paths = [&](unsigned from, unsigned to, EdgeSet avoided, EdgeSet ends, Mask pair) {
    std::vector<EdgeSet> paths;
    collect_paths(after_, from, to, avoided, 0, ends, paths);
    for (const EdgeSet path : paths) forbidden_.push_back({path, pair});
  };
  for (std::size_t e = 0; e < inner; ++e) forbid_paths(after_.edges[e].u, after_.edges[e].v, single(e), single(e), 0);
  for (std::size_t p = 0; p < after_.owner.size(); ++p)
    for (std::size_t q = p + 1; q < after_.owner.size(); ++q)
      forbid_paths(after_.owner[p], after_.owner[q], 0, port(p) | port(q), Mask{1} << p | Mask{1} << q);
}

FoundReason Reasoner::find(Mask solid_ports, const std::vector<Mask>& joined, const Choice& best,
                           std::uint64_t most_steps) const {
  const std::size_t inner = after_.edges.size();
  const EdgeSet everything = (single(inner) - 1) | solid_ports << inner;
  ReasonGoal goal;
  goal.inner_edges = static_cast<unsigned>(inner);
  const EdgeSet staying = (solid_ports & ~may_give_up_) << inner;
  goal.edges = everything & ~staying;
  for (const Forbidden& set : forbidden_)
    if ((set.edges & ~everything) == 0 && std::find(joined.begin(), joined.end(), set.pair) == joined.end())
      goal.sets.push_back(set.edges & goal.edges);
  // A triangle with a solid port that stays is never isolated.
  for (const EdgeSet edges : edges_of_triangle_)
    if ((edges & everything & ~goal.edges) == 0) goal.triangles.push_back(edges & everything);
  const EdgeSet recoloring = best.recoloring | best.kept << inner;
  goal.dashed = std::popcount(goal.edges & ~recoloring);
  goal.isolated = static_cast<int>(best.isolated);
  goal.given_up = std::popcount(solid_ports & ~best.kept);
  ReasonSearch search(goal);
  std::optional<Reason> smallest = search.smallest(most_steps);
  const bool is_smallest = smallest.has_value();
  Reason reason = is_smallest ? *std::move(smallest) : search.greedy();
  return {std::move(reason), search.steps(), is_smallest};
}

namespace {

/// A section with claims, rows and reasons.
std::string section_text(const Section& section, Watched watched) {
  std::string text = fmt::format("section {}\n", position_text(section.position));
  const Claims claims = sum(section.claims);
  text += fmt::format("claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                      claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  text += fmt::format("claim keys {}\nclaim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n",
                      section.rows.size(), claims.costing, claims.worst_strips, claims.worst_isolated);
  const Operation operation = operation_of_rows(section.position);
  std::vector<unsigned> identity(operation.patch.after.ports());
  std::iota(identity.begin(), identity.end(), 0U);
  // The map of a row's ports to the ports of its representative in the search.
  const auto to_representative = [&](const Row& row) -> const std::vector<unsigned>& {
    return row.witness < 0 ? identity : section.symmetry[static_cast<std::size_t>(row.witness)].port;
  };
  struct Line {
    const Row* row = nullptr;
    std::string joined;
    Key representative;
  };
  std::vector<Line> lines;
  for (const Row& row : section.rows) {
    const std::vector<unsigned>& to = to_representative(row);
    lines.push_back({&row, row.key.joined.text(), {permute(row.key.ports, to), row.key.joined.moved(to)}});
  }
  // By P, then by J as a number.
  std::sort(lines.begin(), lines.end(), [](const Line& x, const Line& y) {
    return std::tuple{x.row->key.ports, x.joined.size(), std::string_view(x.joined)} <
           std::tuple{y.row->key.ports, y.joined.size(), std::string_view(y.joined)};
  });
  std::optional<Reasoner> reasoner;
  if (has_reasons(operation)) reasoner.emplace(operation);
  // The rule row of an orbit is its first line, whichever row the search started with.
  std::map<Key, const Row*> rule_of;
  Progress progress("finding reasons", section.rows.size(), watched);
  for (const auto& [line_row, joined, representative] : lines) {
    const Row& row = *line_row;
    const auto [rule, is_rule] = rule_of.try_emplace(representative, &row);
    text +=
        fmt::format("{} {:x} {} {:x} {:x}", is_rule ? "rule" : "copy", row.key.ports, joined, row.recoloring, row.kept);
    if (!is_rule) {
      const std::vector<unsigned> back = inverse(to_representative(*rule->second));
      std::vector<unsigned> ports;
      for (const unsigned port : to_representative(row)) ports.push_back(back[port]);
      text += fmt::format(" by {}", fmt::join(ports, " "));
    } else if (reasoner) {
      text += fmt::format(" because {}", reasoner->find(row.key.ports, row.key.joined.masks(), row).reason.text());
    }
    text += '\n';
    progress.step();
  }
  return text;
}

}  // namespace

std::size_t Certificate::rows() const {
  std::size_t n = 0;
  for (const Section& section : sections) n += section.rows.size();
  return n;
}

std::vector<Certificate> certify(std::vector<Section> sections, unsigned threads, bool with_texts) {
  std::vector<std::string> texts(sections.size());
  if (with_texts)
    share_sections(sections, threads, "certifying",
                   [&](std::size_t i, Watched watched) { texts[i] = section_text(sections[i], watched); });
  std::vector<Certificate> all;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string& name = sections[i].certificate;
    if (all.empty() || all.back().name != name)
      all.push_back({name, {}, fmt::format("restrip-certificate 3\noperation {}\n", name)});
    all.back().text += texts[i];
    all.back().sections.push_back(std::move(sections[i]));
  }
  for (Certificate& certificate : all)
    certificate.text = with_texts ? sealed(std::move(certificate.text), certificate.rows()) : "";
  return all;
}

std::string sealed(std::string text, std::size_t rows) {
  std::uint64_t sum = 0;
  std::uint64_t weighted = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    sum += byte;
    weighted += (i + 1) * byte;
  }
  return text + fmt::format("end {} {} {}\n", rows, sum, weighted);
}

}  // namespace restrip::generator
