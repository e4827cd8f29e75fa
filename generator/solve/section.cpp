#include "solve/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace restrip::generator {
namespace {

/// The values of the criteria for a colouring after the operation whose ports `kept`, out of `ports`, are solid.
/// Depends on the patch alone, never on the machine.
CriterionValues values_of(const Operation& operation, const Coloring& coloring, const Outcome& outcome, Mask ports,
                          Mask kept) {
  const Side& after = operation.patch.after;
  std::vector<int> inner_degree(after.nodes, 0);
  for (std::size_t e = 0; e < after.edges.size(); ++e) {
    if ((coloring.inner >> e & 1U) == 0) continue;
    ++inner_degree[after.edges[e].u];
    ++inner_degree[after.edges[e].v];
  }
  std::vector<int> degree = inner_degree;
  for (std::size_t p = 0; p < after.owner.size(); ++p) degree[after.owner[p]] += (kept >> p & 1U) != 0 ? 1 : 0;
  const auto end = [&](unsigned node) { return degree[node] == 1; };
  const auto nodes_where = [&](Mask of, const auto& holds) {
    int count = 0;
    for (unsigned node = 0; node < after.nodes; ++node) count += (of >> node & 1U) != 0 && holds(node) ? 1 : 0;
    return count;
  };
  const auto counted = [&](const Term& term) -> int {
    switch (term.count) {
      case Count::strips:
        return static_cast<int>(after.nodes - outcome.solid) - std::popcount(kept);
      case Count::isolated:
        return static_cast<int>(outcome.isolated);
      case Count::given_up:
        return std::popcount(ports & ~kept);
      case Count::kept:
        return std::popcount(kept & term.of);
      case Count::joined:
        return static_cast<int>(outcome.joined.size());
      case Count::solid:
        return std::popcount(coloring.inner & term.of);
      case Count::ends:
        return nodes_where(term.of, end);
      case Count::ends_at_port:
        return nodes_where(term.of, [&](unsigned node) { return end(node) && inner_degree[node] == 0; });
      case Count::neighbouring_ends: {
        int count = 0;
        for (const auto& [u, v] : after.edges) count += end(u) && end(v) ? 1 : 0;
        return count;
      }
      case Count::squares: {
        int sum = 0;
        for (const Mask strip : coloring.strips) sum += std::popcount(strip) * std::popcount(strip);
        return sum;
      }
    }
    throw std::logic_error("a count without a meaning");
  };
  CriterionValues values{};
  for (std::size_t i = 0; i < operation.preference.size(); ++i)
    for (const Term& term : operation.preference[i]) values[i] += term.weight * counted(term);
  for (const Term& term : operation.tie_break) values.back() += term.weight * counted(term);
  return values;
}

/// Calls visit for every valid recolouring with its colouring, kept ports and outcome.
template <class Visit>
void for_each_recoloring(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports,
                         Visit&& visit) {
  const Mask may_give_up = ports & operation.may_give_up;
  for (const Coloring& coloring : colorings)
    for (Mask given_up = may_give_up;; given_up = (given_up - 1) & may_give_up) {
      const Mask kept = ports & ~given_up;
      if (const auto outcome = with_ports(coloring, kept)) visit(coloring, kept, *outcome);
      if (given_up == 0) break;
    }
}

}  // namespace

std::vector<PortPairs> relevant_pairs(const Operation& operation) {
  const std::vector<Coloring> colorings = legal_colorings(operation.patch.after, operation.constraint);
  std::vector<PortPairs> joined;
  for (Mask ports = 0; ports <= operation.patch.after.all_ports(); ++ports) {
    joined.emplace_back();
    for_each_recoloring(operation, colorings, ports,
                        [&](const Coloring&, Mask, const Outcome& outcome) { joined.back() |= outcome.joined; });
  }
  return joined;
}

std::vector<Candidate> candidates_for(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports) {
  std::vector<Candidate> candidates;
  for_each_recoloring(operation, colorings, ports, [&](const Coloring& coloring, Mask kept, const Outcome& outcome) {
    const auto lost = static_cast<unsigned>(std::popcount(ports & ~kept));
    candidates.push_back({{coloring.inner, kept, outcome.solid, outcome.isolated + lost},
                          outcome.joined,
                          values_of(operation, coloring, outcome, ports, kept)});
  });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.values, x.recoloring, x.kept) < std::tie(y.values, y.recoloring, y.kept);
  });
  return candidates;
}

namespace {

/// The keys of valid configurations, in ascending order. The configurations are too many to be stored (26 million at
/// one position of k = 12).
void find_keys(Section& section, const Operation& rows_of) {
  section.relevant = relevant_pairs(rows_of);
  std::vector<std::vector<Coloring>> before;
  for (const PositionWithPatch& position : section.serves)
    before.push_back(legal_colorings(position.patch.before, rows_of.constraint));
  std::vector<PortPairs> joined;
  for (Mask ports = 0; ports <= rows_of.patch.after.all_ports(); ++ports) {
    joined.clear();
    for (const auto& colorings : before) {
      for (const Coloring& coloring : colorings)
        if (const auto outcome = with_ports(coloring, ports)) {
          joined.push_back(outcome->joined);
          joined.back() &= section.relevant[ports];
        }
      std::sort(joined.begin(), joined.end());
      joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    }
    for (const PortPairs& pairs : joined) section.rows.push_back({{}, {ports, pairs}, -1});
  }
}

/// The index of the row with this key; the number of rows if it does not exist.
std::size_t row_with(const Key& key, const std::vector<Row>& rows) {
  const auto at = std::lower_bound(rows.begin(), rows.end(), key,
                                   [](const Row& row, const Key& wanted) { return row.key < wanted; });
  return at == rows.end() || at->key != key ? rows.size() : static_cast<std::size_t>(at - rows.begin());
}

/// Names the first configuration that has the key.
[[noreturn]] void refuse_without_rule(const Section& section, const Key& key) {
  for (const PositionWithPatch& position : section.serves) {
    std::optional<Configuration> first;
    for_each_valid(operation_at(position, position.patch), [&](const Configuration& c) {
      PortPairs joined = c.outcome.joined;
      joined &= section.relevant.at(c.ports);
      if (!first && Key{c.ports, joined} == key) first = c;
    });
    if (!first) continue;
    std::string joined;
    for (const Mask pair : first->outcome.joined.masks())
      joined += fmt::format("{} {} and {}", joined.empty() ? ", which joins the ports" : ",", std::countr_zero(pair),
                            std::bit_width(pair) - 1);
    throw std::runtime_error(
        fmt::format("{}operation {}: the configuration {:x} {:x} (inner edges and ports that are solid before, as in a "
                    "dump{}) has no sound recolouring that keeps the ports that must stay; list more of its ports "
                    "under \"give_up\"",
                    position.family->in_file, name_of(position), first->before, key.ports, joined));
  }
  throw std::logic_error("no configuration has this key");
}

/// Finds the rules of representatives, each the smallest key of its orbit, and passes their choices to their copies.
void find_rules(Section& section, const Operation& rows_of, Watched watched) {
  const std::vector<Coloring> after = legal_colorings(rows_of.patch.after, rows_of.constraint);
  find_keys(section, rows_of);
  const Symmetries symmetry = symmetries(rows_of);
  const std::vector<PatchMap>& maps = symmetry.maps;
  section.symmetries = symmetry.order;
  std::vector<std::vector<unsigned>> port_backwards;
  port_backwards.reserve(maps.size());
  for (const PatchMap& map : maps) port_backwards.push_back(inverse(map.port));
  PatchMap identity = maps.at(0);
  for (auto* images : {&identity.port, &identity.before, &identity.after})
    std::iota(images->begin(), images->end(), 0U);
  std::map<std::pair<std::vector<unsigned>, std::vector<unsigned>>, int> number_of;  // of maps, by port and after
  struct Reached {
    Key key;
    PatchMap map;  ///< from this image of a representative's key to it
  };
  std::vector<Row>& rows = section.rows;
  std::vector<bool> done(rows.size(), false);
  std::vector<Candidate> candidates;
  std::optional<Mask> candidates_of;
  Progress progress("finding rules", rows.size(), watched);
  for (std::size_t representative = 0; representative < rows.size(); ++representative) {
    progress.step();
    if (done[representative]) continue;
    const Key& smallest = rows[representative].key;
    if (candidates_of != smallest.ports) candidates = candidates_for(rows_of, after, smallest.ports);
    candidates_of = smallest.ports;
    const auto best = std::find_if(candidates.begin(), candidates.end(),
                                   [&](const Candidate& one) { return one.joins.within(smallest.joined); });
    if (best == candidates.end()) refuse_without_rule(section, smallest);
    static_cast<Choice&>(rows[representative]) = *best;
    done[representative] = true;

    // Images that are not rows are traversed too: a section that serves several positions need not have all keys of an
    // orbit.
    std::vector<Reached> orbit{{smallest, identity}};
    std::set<Key> no_rows;
    for (std::size_t i = 0; i < orbit.size(); ++i)
      for (std::size_t s = 0; s < maps.size(); ++s) {
        const std::vector<unsigned>& back = port_backwards[s];
        const Key key{permute(orbit[i].key.ports, back), orbit[i].key.joined.moved(back)};
        const std::size_t row = row_with(key, rows);
        if (row == rows.size() ? !no_rows.insert(key).second : done[row]) continue;
        orbit.push_back({key, then(maps[s], orbit[i].map)});
        if (row == rows.size()) continue;
        done[row] = true;
        const PatchMap& map = orbit.back().map;
        const auto [number, is_new] =
            number_of.try_emplace({map.port, map.after}, static_cast<int>(section.symmetry.size()));
        if (is_new) section.symmetry.push_back(map);
        static_cast<Choice&>(rows[row]) = *best;
        rows[row].recoloring = permute(best->recoloring, inverse(map.after));
        rows[row].kept = permute(best->kept, inverse(map.port));
        rows[row].witness = number->second;
      }
  }
}

void make_claims(Section& section) {
  for (const PositionWithPatch& position : section.serves) {
    const Operation operation = operation_at(position, position.patch);
    const Patch& patch = operation.patch;
    const bool matching = operation.constraint.most_edges == 1;
    const std::vector<bool> larger = larger_in_orbits(patch, symmetries(operation).generators);
    Claims claims;
    claims.configurations = larger.size();
    claims.orbits = static_cast<std::size_t>(std::count(larger.begin(), larger.end(), false));
    for_each_valid(operation, [&](const Configuration& c) {
      const Change change = change_of(patch, c, row_of(section, c.ports, c.outcome.joined));
      ++claims.valid;
      claims.valid_orbits += larger[std::size_t{c.before} << patch.before.ports() | c.ports] ? 0U : 1U;
      claims.costing += (matching ? change.isolated : change.strips) >= 1 ? 1U : 0U;
      claims.worst_strips = std::max(claims.worst_strips, change.strips);
      claims.worst_isolated = std::max(claims.worst_isolated, change.isolated);
    });
    section.claims.push_back(claims);
  }
}

/// Throws std::runtime_error if the rows are not valid for this position, or a user's is too large for a table.
void expect_served(const PositionWithPatch& position, const Position& rows) {
  const Description& family = *position.family;
  const Description& first = *rows.family;
  const Patch& patch = position.patch;
  for (const Side* side : {&patch.before, &patch.after})
    if (family.author == Author::user &&
        (side->nodes > most_nodes || side->owner.empty() || side->ports() > most_ports ||
         side->edges.size() + side->owner.size() > most_edges_and_ports))
      throw std::runtime_error(fmt::format(
          "{}{}: expected 1 to {} triangles, 1 to {} ports, and at most {} edges and ports together on each "
          "side, found {}, {} and {}; a smaller --max-k leaves large positions out",
          family.in_file, name_of(position), most_nodes, most_ports, most_edges_and_ports, side->nodes, side->ports(),
          side->edges.size() + side->owner.size()));
  if (patch.after != patch_of_rows(rows).after || family.constraint != first.constraint ||
      family.may_give_up != first.may_give_up || family.preference != first.preference)
    throw std::runtime_error(
        fmt::format("{}section {} cannot serve {}: its positions differ after the operation, or in what is "
                    "best; name more numbers in \"section\"",
                    family.in_file, position_text(rows), name_of(position)));
}

}  // namespace

Claims sum(const std::vector<Claims>& parts) {
  Claims total;
  for (const Claims& part : parts) {
    total.configurations += part.configurations;
    total.valid += part.valid;
    total.orbits += part.orbits;
    total.valid_orbits += part.valid_orbits;
    total.costing += part.costing;
    total.worst_strips = std::max(total.worst_strips, part.worst_strips);
    total.worst_isolated = std::max(total.worst_isolated, part.worst_isolated);
  }
  return total;
}

std::vector<std::string> certificates_of(const std::vector<Description>& descriptions) {
  std::vector<std::string> names;
  for (const Description& description : descriptions) {
    std::erase(names, description.certificate);
    names.push_back(description.certificate);
  }
  return names;
}

std::vector<Patches> patches_of(const std::vector<Description>& descriptions, unsigned max_k) {
  std::vector<Patches> sections;
  for (const std::string& certificate : certificates_of(descriptions)) {
    const std::size_t of_others = sections.size();
    for (const Description& description : descriptions) {
      if (description.certificate != certificate) continue;
      const std::vector<Position> all = positions_up_to(description, max_k);
      if (all.empty())
        throw std::runtime_error(
            fmt::format("{}{} has no position up to {}", description.in_file, description.name, max_k));
      for (const Position& position : all) {
        auto section = std::find_if(
            sections.begin() + static_cast<std::ptrdiff_t>(of_others), sections.end(),
            [&](const Patches& other) { return position_text(other.position) == position_text(position); });
        if (section == sections.end()) {
          const Position rows = position_of_rows(position);
          section = sections.insert(section, {certificate, rows, {}});
        }
        section->serves.push_back({position, make_patch(position)});
        expect_served(section->serves.back(), section->position);
      }
    }
  }
  return sections;
}

Section solve(Patches patches, Watched watched) {
  Section section{{std::move(patches)}, {}, {}, 1, {}, {}};
  find_rules(section, operation_of_rows(section.position), watched);
  make_claims(section);
  return section;
}

std::vector<Section> solve_all(const std::vector<Patches>& patches, unsigned threads) {
  std::vector<Section> sections(patches.size());
  share_sections(patches, threads, "solving",
                 [&](std::size_t i, Watched watched) { sections[i] = solve(patches[i], watched); });
  return sections;
}

Answers answers_of(const Description& description, const std::vector<Section>& known, unsigned max_k) {
  std::vector<Description> every{description};
  every[0].listed.clear();
  every[0].section = description.place.empty() ? description.name : description.place;
  const std::vector<Patches> patches = patches_of(every, max_k);
  Answers answers;
  answers.images.reserve(patches.size());
  for (const Patches& one : patches) {
    PositionWithPatch position = one.serves[0];
    position.family = &description;
    const auto found = std::find_if(known.begin(), known.end(), [&](const Section& other) {
      return std::find(other.serves.begin(), other.serves.end(), position) != other.serves.end();
    });
    if (found == known.end()) answers.images.push_back(solve(one, Watched::yes));
    answers.positions.push_back({position, found == known.end() ? &answers.images.back() : &*found});
  }
  return answers;
}

const Row& row_of(const Section& section, Mask ports, const PortPairs& joined) {
  Key key{ports, joined};
  key.joined &= section.relevant.at(ports);
  const std::size_t row = row_with(key, section.rows);
  if (row == section.rows.size()) throw std::logic_error("no row for this key");
  return section.rows[row];
}

Change change_of(const Patch& patch, const Configuration& configuration, const Row& row) {
  const auto given_up = std::popcount(configuration.ports & ~row.kept);
  const int nodes = static_cast<int>(patch.after.nodes) - static_cast<int>(patch.before.nodes);
  return {nodes - (static_cast<int>(row.solid) - given_up - static_cast<int>(configuration.outcome.solid)),
          static_cast<int>(row.isolated) - static_cast<int>(configuration.outcome.isolated)};
}

}  // namespace restrip::generator
