#include "solve/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace restrip::generator {
namespace {

/// The keys of valid configurations, in ascending order. The configurations are too many to be stored (26 million at
/// one position of k = 12).
void find_keys(Section& section, const Operation& rows_of) {
  section.relevant = relevant_pairs(rows_of);
  std::vector<std::vector<Coloring>> before;
  for (const Position& position : section.serves)
    before.push_back(legal_colorings(make_patch(position).before, rows_of.constraint));
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

std::vector<Row>::iterator find_row(std::vector<Row>& rows, const Key& key) {
  const auto at = std::lower_bound(rows.begin(), rows.end(), key,
                                   [](const Row& row, const Key& wanted) { return row.key < wanted; });
  return at == rows.end() || at->key != key ? rows.end() : at;
}

/// Traverses orbits of rows and passes their representatives' choices to their copies.
class Copier {
 public:
  explicit Copier(Section& section, const std::vector<PatchMap>& maps) : section_(section), maps_(maps) {
    for (const PatchMap& map : maps) port_backwards_.push_back(inverse(map.port));
    done_.resize(section.rows.size(), false);
  }

  [[nodiscard]] bool done(std::size_t row) const { return done_[row]; }

  /// Images that are not rows are traversed too: a section that serves several positions need not have all keys of an
  /// orbit.
  void copy(std::size_t representative) {
    std::vector<Row>& rows = section_.rows;
    struct Reached {
      Key key;
      PatchMap map;  ///< from the image to the representative
    };
    done_[representative] = true;
    std::vector<Reached> orbit{{rows[representative].key, identity(maps_.empty() ? PatchMap{} : maps_[0])}};
    std::set<Key> no_rows;
    for (std::size_t i = 0; i < orbit.size(); ++i)
      for (std::size_t s = 0; s < maps_.size(); ++s) {
        const std::vector<unsigned>& back = port_backwards_[s];
        const Key key{permute(orbit[i].key.ports, back), orbit[i].key.joined.moved(back)};
        const auto row = find_row(rows, key);
        const auto place = static_cast<std::size_t>(row - rows.begin());
        if (row == rows.end() ? !no_rows.insert(key).second : done_[place]) continue;
        orbit.push_back({key, then(maps_[s], orbit[i].map)});
        if (row == rows.end()) continue;
        done_[place] = true;
        const PatchMap& map = orbit.back().map;
        static_cast<Choice&>(*row) = rows[representative];
        row->recoloring = permute(row->recoloring, inverse(map.after));
        row->kept = permute(row->kept, inverse(map.port));
        row->witness = number_of(map);
      }
  }

 private:
  static PatchMap identity(PatchMap map) {
    for (auto* images : {&map.port, &map.before, &map.after}) std::iota(images->begin(), images->end(), 0U);
    return map;
  }
  int number_of(const PatchMap& map) {
    const auto [place, fresh] = number_.try_emplace({map.port, map.after}, static_cast<int>(section_.symmetry.size()));
    if (fresh) section_.symmetry.push_back(map);
    return place->second;
  }

  Section& section_;
  const std::vector<PatchMap>& maps_;
  std::vector<std::vector<unsigned>> port_backwards_;
  std::vector<bool> done_;
  std::map<std::pair<std::vector<unsigned>, std::vector<unsigned>>, int> number_;
};

/// Names the first configuration that has the key.
[[noreturn]] void refuse_without_rule(const Section& section, const Key& key) {
  for (const Position& position : section.serves) {
    std::optional<Configuration> first;
    for_each_valid(operation_at(position), [&](const Configuration& c) {
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

void find_rules(Section& section, const Operation& rows_of, Watched watched) {
  const std::vector<Coloring> after = legal_colorings(rows_of.patch.after, rows_of.constraint);
  find_keys(section, rows_of);
  const Symmetries symmetry = symmetries(rows_of);
  section.symmetries = symmetry.order;
  Copier copier(section, symmetry.maps);
  std::optional<Candidates> candidates;
  std::optional<Mask> candidates_of;
  Progress progress("finding rules", section.rows.size(), watched);
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    progress.step();
    if (copier.done(i)) continue;
    // The representative is the orbit's smallest key.
    Row& row = section.rows[i];
    if (candidates_of != row.key.ports) candidates.emplace(rows_of, after, row.key.ports);
    candidates_of = row.key.ports;
    const Choice* const best = candidates->best(row.key.joined);
    if (best == nullptr) refuse_without_rule(section, row.key);
    static_cast<Choice&>(row) = *best;
    copier.copy(i);
  }
}

void find_alternatives(Section& section, const Operation& rows_of) {
  const std::vector<Coloring> after = legal_colorings(rows_of.patch.after, rows_of.constraint);
  for (Mask ports = 0; ports <= rows_of.patch.after.all_ports(); ++ports)
    for (const auto& [choice, joins] : Candidates(rows_of, after, ports).uncovered())
      section.rows.push_back({choice, {ports, joins}, -1});
}

void make_claims(Section& section) {
  for (const Position& position : section.serves) {
    const Operation operation = operation_at(position);
    const Patch& patch = operation.patch;
    const bool matching = operation.constraint.most_edges == 1;
    const Orbits orbits(patch, symmetries(operation).generators);
    Claims claims;
    claims.configurations = std::size_t{1} << (patch.before.edges.size() + patch.before.owner.size());
    claims.orbits = orbits.count();
    for_each_valid(operation, [&](const Configuration& c) {
      const Change change = change_of(patch, c, row_of(section, c.ports, c.outcome.joined));
      claims.count(change.strips, change.isolated, (matching ? change.isolated : change.strips) >= 1,
                   orbits.is_smallest(c.before, c.ports));
    });
    section.claims.push_back(claims);
  }
}

/// Throws std::runtime_error if the rows are not valid for this position.
void expect_served(const Position& position, const Position& rows) {
  const Description& family = *position.family;
  const Description& first = *rows.family;
  if (make_patch(position).after != patch_of_rows(rows).after || family.constraint != first.constraint ||
      family.gives_all_up != first.gives_all_up || family.may_give_up != first.may_give_up ||
      family.preference != first.preference)
    throw std::runtime_error(
        fmt::format("{}section {} cannot serve {}: its positions differ after the operation, or in what is "
                    "best; name more numbers in \"section\"",
                    family.in_file, position_text(rows), name_of(position)));
}

}  // namespace

Claims sum(const std::vector<Claims>& parts) {
  Claims total = parts.at(0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Claims& part = parts[i];
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
  std::vector<Patches> linked;
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
          section = sections.insert(section, {certificate, rows, {}, false});
          if (description.linked) linked.push_back({"linked-" + certificate, rows, {}, true});
        }
        expect_served(position, section->position);
        section->serves.push_back(position);
      }
    }
  }
  sections.insert(sections.end(), std::make_move_iterator(linked.begin()), std::make_move_iterator(linked.end()));
  return sections;
}

Section solve(Patches patches, Watched watched) {
  Section section{{std::move(patches)}, {}, {}, 1, {}, {}};
  const Operation rows_of = operation_of_rows(section.position, section.linked ? Sight::outside : Sight::patch);
  if (section.linked) {
    find_alternatives(section, rows_of);
  } else {
    find_rules(section, rows_of, watched);
    make_claims(section);
  }
  return section;
}

std::vector<Section> solve_all(const std::vector<Patches>& patches, unsigned threads, Watched watched) {
  std::vector<Section> sections(patches.size());
  share_sections(patches, threads, watched, "solving", [&](std::size_t i) { sections[i] = solve(patches[i]); });
  return sections;
}

std::vector<Section> solved(const std::string& certificate, unsigned max_k, unsigned threads) {
  std::vector<Patches> patches = patches_of(families(), max_k);
  std::erase_if(patches, [&](const Patches& one) { return one.certificate != certificate; });
  if (patches.empty()) throw std::invalid_argument("unknown certificate " + certificate);
  return solve_all(patches, threads, Watched::no);
}

const Row& row_of(const Section& section, Mask ports, const PortPairs& joined) {
  Key key{ports, joined};
  key.joined &= section.relevant.at(ports);
  const auto at = std::lower_bound(section.rows.begin(), section.rows.end(), key,
                                   [](const Row& row, const Key& wanted) { return row.key < wanted; });
  if (at == section.rows.end() || at->key != key) throw std::logic_error("no row for this key");
  return *at;
}

Change change_of(const Patch& patch, const Configuration& configuration, const Row& row) {
  const auto given_up = std::popcount(configuration.ports & ~row.kept);
  const int nodes = static_cast<int>(patch.after.nodes) - static_cast<int>(patch.before.nodes);
  return {nodes - (static_cast<int>(row.solid) - given_up - static_cast<int>(configuration.outcome.solid)),
          static_cast<int>(row.isolated) - static_cast<int>(configuration.outcome.isolated)};
}

}  // namespace restrip::generator
