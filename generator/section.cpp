#include "section.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <stdexcept>

#include "search.hpp"
#include "share.hpp"

namespace restrip::generator {
namespace {

/// The families whose rules a certificate has.
std::vector<const Family*> families_of(const std::string& certificate) {
  std::vector<const Family*> of_certificate;
  for (const Family& family : families())
    if (family.certificate == certificate) of_certificate.push_back(&family);
  if (of_certificate.empty()) throw std::invalid_argument("no certificate is named " + certificate);
  return of_certificate;
}

/// The image of a key: the symmetry moves the ports, and the pairs that `joined` stands for.
Key image_of(const Key& key, const Symmetry& symmetry, const Position& position) {
  const Mask ports = permute(key.ports, symmetry.port);
  if (position.family->keyed_by_inner) return {ports, key.joined};
  std::vector<Mask> pairs = pairs_before(position, key);
  for (Mask& pair : pairs) pair = permute(pair, symmetry.port);
  return {ports, joined_to_previous(pairs, ports, position.k, closed(*position.family))};
}

/// The keys that some valid configuration has, in ascending order. Configurations are many (26 million at one position
/// of k = 12) and are not kept.
std::vector<Key> keys_of(const Section& section) {
  const auto bits = static_cast<unsigned>(make_patch(section.serves[0]).before.owner.size());
  std::vector<bool> has(std::size_t{1} << (2 * bits), false);
  for (const Position& p : section.serves)
    for_each_valid(p, make_patch(p).before,
                   [&](const Configuration& c) { has[std::size_t{c.key.ports} << bits | c.key.joined] = true; });
  std::vector<Key> keys;
  for (std::size_t i = 0; i < has.size(); ++i)
    if (has[i]) keys.push_back({static_cast<Mask>(i >> bits), static_cast<Mask>(i & ((std::size_t{1} << bits) - 1))});
  return keys;
}

void find_rows(Section& section) {
  const std::vector<Key> keys = keys_of(section);
  const Operation operation = operation_of(section.position, Sight::patch, section.goal);
  const std::vector<Coloring> colorings = legal_colorings(operation.patch.after);
  std::map<Key, Row> rows;
  for (auto key = keys.begin(); key != keys.end();) {
    const Candidates candidates(operation, colorings, key->ports);
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
        const Choice* const best = candidates.best(port_pairs(pairs_before(section.position, *key)));
        if (best == nullptr) throw std::logic_error("a configuration of a family has no sound recolouring");
        rows[*key] = {*best, *key};
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

void make_claims(Section& section) {
  for (const Position& position : section.serves) {
    const Patch patch = make_patch(position);
    const Smallest smallest(patch, symmetries(patch));
    Claims claims;
    claims.configurations = std::size_t{1} << (patch.before.edges.size() + patch.before.owner.size());
    claims.orbits = smallest.orbits();
    for_each_valid(position, patch.before, [&](const Configuration& c) {
      const Change change = change_of(patch, c, row_of(section, c.key));
      claims.count(change.strips, change.isolated, change.strips >= 1, smallest(c.before, c.ports));
    });
    section.claims.push_back(claims);
  }
}

}  // namespace

const std::vector<std::string>& certificate_families() {
  // A certificate stands where the last of its families does.
  static const std::vector<std::string> certificates = [] {
    std::vector<std::string> names;
    for (const Family& family : families()) {
      std::erase(names, family.certificate);
      names.push_back(family.certificate);
    }
    return names;
  }();
  return certificates;
}

std::vector<Mask> pairs_before(const Position& position, const Key& key) {
  if (position.family->keyed_by_inner) {
    // The key is the configuration itself; its pairing follows from it.
    const Side before = make_patch(position).before;
    for (const Coloring& coloring : legal_colorings(before))
      if (coloring.inner == key.joined) return with_ports(coloring, key.ports).value().pairs;
  }
  std::vector<Mask> pairs;
  for (unsigned i = 0; i < position.k; ++i) {
    const Mask port = Mask{1} << i;
    if ((key.joined & port) == 0) continue;
    const Mask below = key.ports & (port - 1);
    pairs.push_back(port | std::bit_floor(below != 0 ? below : key.ports & ~port));
  }
  return pairs;
}

std::vector<Section> sections_of(const std::string& certificate_family, unsigned max_k) {
  const std::vector<const Family*> served = families_of(certificate_family);
  const Family& first = *served.front();
  const unsigned last = first.numbers.empty() ? smallest_valence(first) : max_k;
  std::vector<Section> sections;
  for (unsigned k = smallest_valence(first); k <= last; ++k) {
    const std::size_t of_smaller = sections.size();
    for (const Family* family : served)
      for (const Position& position : positions(*family, k)) {
        const bool shared = serves_every_position(*family) && sections.size() > of_smaller;
        if (!shared) {
          const Position of_rows = serves_every_position(*family) ? Position{&first, k, 0, 0} : position;
          sections.push_back({of_rows, {}, {}, {}, {}});
        }
        sections.back().serves.push_back(position);
      }
  }
  return sections;
}

void solve(Section& section) {
  section.symmetry = symmetries(patch_of_rows(section.position));
  find_rows(section);
  make_claims(section);
}

std::vector<Section> solve(const std::string& certificate_family, unsigned max_k, unsigned threads) {
  std::vector<Section> sections = sections_of(certificate_family, max_k);
  // The largest valences take longest: start with them.
  share(sections.size(), threads, [&](std::size_t i) { solve(sections[sections.size() - 1 - i]); });
  return sections;
}

const Row& row_of(const Section& section, const Key& key) {
  const auto at = std::lower_bound(section.rows.begin(), section.rows.end(), key,
                                   [](const Row& row, const Key& wanted) { return row.key < wanted; });
  if (at == section.rows.end() || at->key != key) throw std::logic_error("no row for this key");
  return *at;
}

Change change_of(const Patch& patch, const Configuration& configuration, const Row& row) {
  const auto given_up = std::popcount(configuration.ports & ~row.kept);
  const int nodes = static_cast<int>(patch.after.nodes) - static_cast<int>(patch.before.nodes);
  return {nodes - (static_cast<int>(row.solid) - given_up - static_cast<int>(configuration.solid)),
          static_cast<int>(row.isolated) - static_cast<int>(configuration.isolated)};
}

}  // namespace restrip::generator
