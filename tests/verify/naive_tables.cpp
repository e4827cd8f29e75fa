// Rows, symmetries, claims and text of certificates.

#include "naive_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace restrip::verify::test {
namespace {

/// A turn or mirror with what it does to ports, and to the edges of one patch.
struct Motion {
  std::string name;
  std::vector<int> ports;
};

std::vector<Motion> motions(int k) {
  std::vector<Motion> result;
  for (int n = 0; n < k; ++n) result.push_back({fmt::format("turn {}", n), {}});
  for (int n = 0; n < k; ++n) result.push_back({fmt::format("mirror {}", n), {}});
  for (int m = 0; m < 2 * k; ++m)
    for (int i = 0; i < k; ++i)
      result[static_cast<std::size_t>(m)].ports.push_back(m < k ? (i + m) % k : (m - k + k - i) % k);
  return result;
}

/// Edge permutations of the patch that go with the motion; the new triangles stay, or trade places.
std::vector<std::vector<int>> edge_motions(const NaivePatch& patch, const Motion& motion) {
  std::set<std::vector<int>> result;
  for (const bool trade : {false, true}) {
    std::map<int, int> image{{triangle_a, trade ? triangle_d : triangle_a},
                             {triangle_d, trade ? triangle_a : triangle_d}};
    bool consistent = true;
    for (std::size_t port = 0; port < motion.ports.size(); ++port) {
      const int to = patch.port_owner[static_cast<std::size_t>(motion.ports[port])];
      consistent = image.emplace(patch.port_owner[port], to).first->second == to && consistent;
    }
    std::vector<int> edges;
    for (const auto& [one, other] : patch.edges)
      for (std::size_t i = 0; i < patch.edges.size(); ++i)
        if (patch.edges[i] == Pair{image[one], image[other]} || patch.edges[i] == Pair{image[other], image[one]})
          edges.push_back(static_cast<int>(i));
    if (consistent && edges.size() == patch.edges.size()) result.insert(edges);
  }
  return {result.begin(), result.end()};
}

int moved(int mask, const std::vector<int>& permutation) {
  int result = 0;
  for (std::size_t i = 0; i < permutation.size(); ++i)
    if ((mask >> i) % 2 != 0) result += 1 << permutation[i];
  return result;
}

/// Orbits of configurations, all and valid ones, by collecting the smallest member of each.
std::pair<int, int> orbits(const NaiveOperation& operation) {
  std::set<NaiveColors> all;
  std::set<NaiveColors> valid;
  const int k = static_cast<int>(operation.before.port_owner.size());
  for (int inner = 0; inner < 1 << operation.before.edges.size(); ++inner)
    for (int ports = 0; ports < 1 << k; ++ports) {
      NaiveColors smallest{inner, ports};
      for (const Motion& motion : motions(k)) {
        if (edge_motions(operation.after, motion).empty()) continue;
        for (const std::vector<int>& edges : edge_motions(operation.before, motion))
          smallest = std::min(smallest, NaiveColors{moved(inner, edges), moved(ports, motion.ports)});
      }
      all.insert(smallest);
      if (anatomy(operation.before, {inner, ports})) valid.insert(smallest);
    }
  return {static_cast<int>(all.size()), static_cast<int>(valid.size())};
}

void add_claims(const NaiveSection& section, NaiveTable& table) {
  int configurations = 0;
  int all_orbits = 0;
  int valid_orbits = 0;
  for (const NaiveOperation& operation : section.operations) {
    configurations += 1 << (operation.before.edges.size() + operation.before.port_owner.size());
    const auto [all, valid] = orbits(operation);
    all_orbits += all;
    valid_orbits += valid;
  }
  int valid = 0;
  int costing = 0;
  int worst_strips = -100;
  int worst_isolated = -100;
  for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
    ++valid;
    const Anatomy old = *anatomy(operation.before, before);
    const NaiveColors after = table.rows.at(naive_key(operation, before)).after;
    const Anatomy now = *anatomy(operation.after, after);
    const int strips = static_cast<int>(operation.after.triangles.size()) -
                       static_cast<int>(operation.before.triangles.size()) - (now.solid - old.solid);
    const int given_up = __builtin_popcount(static_cast<unsigned>(before.ports)) -
                         __builtin_popcount(static_cast<unsigned>(after.ports));
    costing += strips >= 1 ? 1 : 0;
    worst_strips = std::max(worst_strips, strips);
    worst_isolated = std::max(worst_isolated, now.isolated - old.isolated + given_up);
  });
  table.claims = {{"configurations", configurations}, {"valid", valid},     {"orbits", all_orbits},
                  {"valid-orbits", valid_orbits},     {"costing", costing}, {"worst-strips", worst_strips},
                  {"worst-isolated", worst_isolated}};
}

/// A valid configuration for each key, with its operation.
struct Example {
  const NaiveOperation* operation = nullptr;
  NaiveColors colors;
};

/// The key that the motion takes a configuration's key to, found through a moved table of pairs.
NaiveKey moved_key(const NaiveSection& section, NaiveKey key, const Motion& motion,
                   const std::map<NaiveKey, Example>& examples) {
  const Example& example = examples.at(key);
  const NaiveOperation& operation = *example.operation;
  const int ports = moved(key.first, motion.ports);
  if (operation.flip) return {ports, key.second};
  // Whoever is joined the same way after the motion has the moved key.
  const std::set<Pair> joined = anatomy(operation.before, example.colors)->joined;
  std::set<Pair> pairs;
  for (const auto& [i, j] : joined) {
    const int x = motion.ports[static_cast<std::size_t>(i)];
    const int y = motion.ports[static_cast<std::size_t>(j)];
    pairs.insert({std::min(x, y), std::max(x, y)});
  }
  std::vector<int> solid;
  for (int port = 0; port < static_cast<int>(motion.ports.size()); ++port)
    if ((ports >> port) % 2 != 0) solid.push_back(port);
  int mask = 0;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (i == 0 && !section.operations.front().before.closed) continue;
    const int preceding = i == 0 ? solid.back() : solid[i - 1];
    if (pairs.contains({std::min(preceding, solid[i]), std::max(preceding, solid[i])})) mask += 1 << solid[i];
  }
  return {ports, mask};
}

}  // namespace

NaiveTable naive_table(const NaiveFamily& family, const NaiveSection& section) {
  NaiveTable table{family.name, section.position, section.operations.front().flip, {}, {}};
  std::map<NaiveKey, Example> examples;
  for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
    examples.emplace(naive_key(operation, before), Example{&operation, before});
  });
  const NaiveOperation& first = section.operations.front();
  for (const auto& [key, example] : examples) {
    NaiveRow row;
    for (const Motion& motion : motions(static_cast<int>(first.after.port_owner.size()))) {
      if (!section.whole_fan_symmetry && edge_motions(first.before, motion).empty()) continue;
      if (edge_motions(first.after, motion).empty()) continue;
      const NaiveKey image = moved_key(section, key, motion, examples);
      if (image >= key || !table.rows.contains(image) || !table.rows.at(image).by.empty()) continue;
      const NaiveRow& rule = table.rows.at(image);
      // The recolouring that the motion takes to the rule's.
      for (int inner = 0; inner < 1 << first.after.edges.size(); ++inner)
        for (int ports = 0; ports < 1 << motion.ports.size(); ++ports)
          if (row.by.empty() && moved(inner, edge_motions(first.after, motion).front()) == rule.after.inner &&
              moved(ports, motion.ports) == rule.after.ports)
            row = {{inner, ports}, motion.name};
    }
    if (row.by.empty()) {
      const std::vector<Candidate> sound = sound_recolorings(*example.operation, example.colors);
      row.after = std::max_element(sound.begin(), sound.end(), [](const Candidate& x, const Candidate& y) {
                    return x.merit < y.merit;
                  })->colors;
    }
    row.because = naive_reason(*example.operation, example.colors, row.after).value();
    table.rows[key] = row;
  }
  add_claims(section, table);
  return table;
}

std::string certificate_text(const std::string& family, const std::vector<NaiveTable>& tables) {
  std::string text = fmt::format("restrip-certificate 2\nfamily {}\n", family);
  std::size_t rows = 0;
  for (const NaiveTable& table : tables) {
    text += fmt::format("section {}\n", table.position);
    for (const auto& [word, number] : table.claims) text += fmt::format("claim {} {}\n", word, number);
    for (const auto& [key, row] : table.rows) {
      text += fmt::format("{} {:x} {:x} ", row.by.empty() ? "rule" : "copy", key.first, key.second);
      if (table.flip) text += fmt::format("{:x} ", row.after.ports);
      text += fmt::format("{:x} {}\n", row.after.inner, row.by.empty() ? "because " + row.because : "by " + row.by);
    }
    rows += table.rows.size();
  }
  return with_sums(text + fmt::format("end {}\n", rows));
}

std::string with_sums(const std::string& text) {
  if (text.empty() || text.back() != '\n') return text;
  const std::size_t end = text.find_last_of('\n', text.size() - 2) + 1;
  std::istringstream words(text.substr(end));
  std::string word;
  std::string rows;
  if (!(words >> word >> rows) || word != "end") return text;
  unsigned long long sum = 0;
  unsigned long long weighted = 0;
  for (std::size_t i = end; i-- > 0;) {
    sum += static_cast<unsigned char>(text[i]);
    weighted += sum;  // a byte is counted once for each place up to its own
  }
  // The sum of all sums of tails counts the byte at place n n times.
  return text.substr(0, end) + fmt::format("end {} {} {}\n", rows, sum, weighted);
}

}  // namespace restrip::verify::test
