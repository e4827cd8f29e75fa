#include "section.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

#include "search.hpp"

namespace restrip::generator {
namespace {

Family family_named(const std::string& name) {
  for (const Family family :
       {Family::split, Family::collapse, Family::open_split, Family::boundary_split, Family::flip})
    if (name_of(family) == name) return family;
  if (name == "fan-collapse") return Family::open_collapse;
  throw std::invalid_argument("no family is named " + name);
}

/// The image of a key: the symmetry moves the ports, and the pairs that `joined` stands for.
Key image_of(const Key& key, const Symmetry& symmetry, const Position& position) {
  if (position.family == Family::flip) return {permute(key.ports, symmetry.port), key.joined};
  const Mask ports = permute(key.ports, symmetry.port);
  std::vector<Mask> pairs;
  const auto bit = [](unsigned i) { return Mask{1} << i; };
  for (unsigned i = 0; i < position.k; ++i) {
    if ((key.joined & bit(i)) == 0) continue;
    const Mask below = key.ports & (bit(i) - 1);
    const Mask previous = std::bit_floor(below != 0 ? below : key.ports & ~bit(i));
    pairs.push_back(permute(previous | bit(i), symmetry.port));
  }
  return {ports, joined_to_previous(pairs, ports, position.k, closed(position.family))};
}

std::vector<unsigned> inverse(const std::vector<unsigned>& to) {
  std::vector<unsigned> from(to.size());
  for (unsigned i = 0; i < to.size(); ++i) from[to[i]] = i;
  return from;
}

/// Orbits of all configurations, or of the valid ones, each found by its smallest member.
void count_orbits(const Patch& patch, const std::vector<Symmetry>& group,
                  const std::vector<std::pair<Mask, Mask>>& valid, Claims& claims) {
  const auto images = [](std::size_t bits, const std::vector<unsigned>& to) {
    std::vector<Mask> image(std::size_t{1} << bits);
    for (Mask mask = 0; mask < image.size(); ++mask) image[mask] = permute(mask, to);
    return image;
  };
  std::vector<std::vector<Mask>> before;
  std::vector<std::vector<Mask>> ports;
  for (const Symmetry& s : group) {
    before.push_back(images(patch.before.edges.size(), s.before));
    ports.push_back(images(patch.before.owner.size(), s.port));
  }
  const auto smallest = [&](Mask b, Mask p) {
    for (std::size_t s = 0; s < group.size(); ++s)
      if (std::pair{before[s][b], ports[s][p]} < std::pair{b, p}) return false;
    return true;
  };
  for (Mask b = 0; b < before[0].size(); ++b)
    for (Mask p = 0; p < ports[0].size(); ++p) claims.orbits += smallest(b, p) ? 1U : 0U;
  for (const auto& [b, p] : valid) claims.valid_orbits += smallest(b, p) ? 1U : 0U;
}

void find_rows(Section& section, const std::vector<std::vector<Configuration>>& configurations) {
  std::set<Key> keys;
  for (const auto& list : configurations)
    for (const Configuration& c : list) keys.insert(c.key);

  const Side after = patch_of_rows(section.position).after;
  const std::vector<Coloring> colorings = legal_colorings(after);
  std::map<Key, Row> rows;
  for (auto key = keys.begin(); key != keys.end();) {
    const Candidates candidates(section.position, after, colorings, key->ports);
    const Mask ports = key->ports;
    for (; key != keys.end() && key->ports == ports; ++key) {
      // The representative is the orbit's smallest key, so it has been answered when a copy comes up.
      int witness = -1;
      Key representative = *key;
      for (std::size_t s = 0; s < section.symmetry.size(); ++s) {
        const Key image = image_of(*key, section.symmetry[s], section.position);
        if (image < representative) {
          representative = image;
          witness = static_cast<int>(s);
        }
      }
      if (witness < 0) {
        rows[*key] = candidates.best(*key);
        continue;
      }
      const Symmetry& symmetry = section.symmetry[static_cast<std::size_t>(witness)];
      Row row = rows.at(representative);
      row.key = *key;
      row.recoloring = permute(row.recoloring, inverse(symmetry.after));
      row.kept = permute(row.kept, inverse(symmetry.port));
      row.witness = witness;
      rows[*key] = row;
    }
  }
  for (const auto& [key, row] : rows) section.rows.push_back(row);
}

void make_claims(Section& section, const std::vector<std::vector<Configuration>>& configurations,
                 const std::vector<std::vector<Symmetry>>& groups) {
  for (std::size_t i = 0; i < section.serves.size(); ++i) {
    const Patch patch = make_patch(section.serves[i]);
    Claims claims;
    claims.configurations = std::size_t{1} << (patch.before.edges.size() + patch.before.owner.size());
    claims.valid = configurations[i].size();
    claims.worst_strips = claims.worst_isolated = std::numeric_limits<int>::min();
    std::vector<std::pair<Mask, Mask>> valid;
    for (const Configuration& c : configurations[i]) {
      const Cost cost = cost_of(patch, c, row_of(section, c.key));
      claims.costing += cost.strips >= 1 ? 1U : 0U;
      claims.worst_strips = std::max(claims.worst_strips, cost.strips);
      claims.worst_isolated = std::max(claims.worst_isolated, cost.isolated);
      valid.emplace_back(c.before, c.ports);
    }
    count_orbits(patch, groups[i], valid, claims);
    section.claims.push_back(claims);
  }
}

}  // namespace

const std::vector<std::string>& certificate_families() {
  static const std::vector<std::string> families{"split",          "collapse",     "open-split",
                                                 "boundary-split", "fan-collapse", "flip"};
  return families;
}

Patch patch_of_rows(const Position& position) {
  return collapses(position.family) ? make_fan_patch(position.k, closed(position.family)) : make_patch(position);
}

std::vector<Section> solve(const std::string& certificate_family, unsigned max_k, unsigned threads) {
  const Family family = family_named(certificate_family);
  std::vector<Section> sections;
  if (family == Family::flip) {
    sections.push_back({{family, 4, 0, 0}, positions(family, 4), {}, {}, {}});
  } else {
    for (unsigned k = smallest_valence(family); k <= max_k; ++k) {
      if (!collapses(family)) {
        for (const Position& p : positions(family, k)) sections.push_back({p, {p}, {}, {}, {}});
        continue;
      }
      std::vector<Position> serves = positions(family, k);
      if (family == Family::open_collapse)
        for (const Position& p : positions(Family::boundary_collapse, k)) serves.push_back(p);
      sections.push_back({{family, k, 0, 0}, serves, {}, {}, {}});
    }
  }
  // nauty keeps state of its own between calls, so the symmetries are found before the threads start.
  std::vector<std::vector<std::vector<Symmetry>>> groups(sections.size());
  for (std::size_t i = 0; i < sections.size(); ++i) {
    sections[i].symmetry = symmetries(patch_of_rows(sections[i].position));
    for (const Position& p : sections[i].serves) groups[i].push_back(symmetries(make_patch(p)));
  }

  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < sections.size(); i = next++) {
      // The largest valences take longest: start with them.
      Section& section = sections[sections.size() - 1 - i];
      std::vector<std::vector<Configuration>> configurations;
      for (const Position& p : section.serves) {
        auto& list = configurations.emplace_back();
        for_each_valid(p, make_patch(p).before, [&](const Configuration& c) { list.push_back(c); });
      }
      find_rows(section, configurations);
      make_claims(section, configurations, groups[sections.size() - 1 - i]);
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned t = 1; t < threads; ++t) pool.emplace_back(work);
  work();
  pool.clear();
  return sections;
}

const Row& row_of(const Section& section, const Key& key) {
  const auto at = std::lower_bound(section.rows.begin(), section.rows.end(), key,
                                   [](const Row& row, const Key& wanted) { return row.key < wanted; });
  if (at == section.rows.end() || at->key != key) throw std::logic_error("no row for this key");
  return *at;
}

Cost cost_of(const Patch& patch, const Configuration& configuration, const Row& row) {
  const auto given_up = std::popcount(configuration.ports & ~row.kept);
  const int nodes = static_cast<int>(patch.after.nodes) - static_cast<int>(patch.before.nodes);
  return {nodes - (static_cast<int>(row.solid) - given_up - static_cast<int>(configuration.solid)),
          static_cast<int>(row.isolated) - static_cast<int>(configuration.isolated)};
}

}  // namespace restrip::generator
