#include "naive_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace restrip::verify::operations::test {
namespace {

bool has(int mask, int i) { return mask / (1 << i) % 2 == 1; }

int pair_bit(int i, int j) { return 1 << (std::max(i, j) * (std::max(i, j) - 1) / 2 + std::min(i, j)); }

/// A graph of nodes 0 … nodes - 1: has no cycle when its edges are the nodes minus the components.
bool acyclic(int nodes, const std::vector<std::pair<int, int>>& edges) {
  std::vector<int> component(static_cast<std::size_t>(nodes));
  std::iota(component.begin(), component.end(), 0);
  for (const auto& [a, b] : edges) {
    const int from = component[static_cast<std::size_t>(a)];
    const int to = component[static_cast<std::size_t>(b)];
    std::replace(component.begin(), component.end(), from, to);
  }
  const std::set<int> different(component.begin(), component.end());
  return edges.size() + different.size() == static_cast<std::size_t>(nodes);
}

}  // namespace

std::string NaiveRow::text() const {
  const std::string masks = fmt::format("{:x} {:x} {:x} {:x}", ports, joined, after.inner, after.ports);
  return by.empty() ? "rule " + masks : fmt::format("copy {} by {}", masks, fmt::join(by, " "));
}

std::string with_end(const std::string& above, std::size_t rows) {
  unsigned long plain = 0;
  unsigned long weighted = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    plain += static_cast<unsigned char>(above[i]);
    weighted += (i + 1) * static_cast<unsigned char>(above[i]);
  }
  return fmt::format("{}end {} {} {}\n", above, rows, plain, weighted);
}

std::string NaiveCertificate::text() const {
  std::string above = fmt::format("{}\noperation {}\n", title, name);
  for (const auto& [word, number] : claims) above += fmt::format("claim {} {}\n", word, number);
  for (const NaiveRow& row : rows) above += row.text() + '\n';
  return with_end(above, rows.size());
}

std::vector<NaiveColors> NaiveOperation::configurations() const {
  std::vector<NaiveColors> all;
  for (int inner = 0; inner < 1 << operation_.before.edges.size(); ++inner)
    for (int ports = 0; ports < 1 << operation_.ports(); ++ports) all.push_back({inner, ports});
  return all;
}

std::vector<int> NaiveOperation::degrees(bool after, NaiveColors colors) const {
  std::vector<int> count(side(after).triangles);
  for (std::size_t i = 0; i < side(after).edges.size(); ++i)
    if (has(colors.inner, static_cast<int>(i))) {
      ++count[side(after).edges[i][0]];
      ++count[side(after).edges[i][1]];
    }
  for (std::size_t i = 0; i < side(after).owner_of_port.size(); ++i)
    if (has(colors.ports, static_cast<int>(i))) ++count[side(after).owner_of_port[i]];
  return count;
}

bool NaiveOperation::valid(bool after, NaiveColors colors) const {
  const int most = operation_.constraint == Constraint::strips     ? 2
                   : operation_.constraint == Constraint::matching ? 1
                                                                   : 3;
  for (const int degree : degrees(after, colors))
    if (degree > most) return false;
  return fits(after, colors, {});
}

/// The number of the component of each triangle.
std::vector<int> NaiveOperation::components(bool after, int inner) const {
  std::vector<int> component(side(after).triangles);
  std::iota(component.begin(), component.end(), 0);
  for (std::size_t i = 0; i < side(after).edges.size(); ++i)
    if (has(inner, static_cast<int>(i))) {
      const int from = component[side(after).edges[i][0]];
      const int to = component[side(after).edges[i][1]];
      std::replace(component.begin(), component.end(), from, to);
    }
  return component;
}

int NaiveOperation::joined(bool after, NaiveColors colors) const {
  const std::vector<int> component = components(after, colors.inner);
  int pairs = 0;
  for (int j = 0; j < static_cast<int>(operation_.ports()); ++j)
    for (int i = 0; i < j; ++i)
      if (has(colors.ports, i) && has(colors.ports, j) &&
          component[side(after).owner_of_port[static_cast<std::size_t>(i)]] ==
              component[side(after).owner_of_port[static_cast<std::size_t>(j)]])
        pairs += pair_bit(i, j);
  return pairs;
}

/// As sets of pairs of ports that are connected: no port in two of them, or with a-b and b-c always a-c.
std::vector<NaiveOperation::Pairs> NaiveOperation::worlds(int ports) const {
  std::vector<std::pair<int, int>> all;
  for (int j = 0; j < static_cast<int>(operation_.ports()); ++j)
    for (int i = 0; i < j; ++i)
      if (has(ports, i) && has(ports, j)) all.emplace_back(i, j);
  if (operation_.constraint == Constraint::matching) all.clear();
  std::vector<Pairs> worlds;
  for (int chosen = 0; chosen < 1 << all.size(); ++chosen) {
    Pairs world;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (has(chosen, static_cast<int>(i))) world.insert(all[i]);
    bool is_world = true;
    for (const std::pair<int, int>& one : world)
      for (const std::pair<int, int>& other : world) {
        const std::set<int> ends = {one.first, one.second, other.first, other.second};
        if (ends.size() != 3) continue;
        // Two pairs with one port in common: the other two have to be connected as well, if that is a world at all.
        std::vector<int> rest;
        for (const int port : ends)
          if ((port == one.first || port == one.second) != (port == other.first || port == other.second))
            rest.push_back(port);
        is_world = is_world && operation_.constraint == Constraint::forest && world.contains({rest[0], rest[1]});
      }
    if (is_world) worlds.push_back(world);
  }
  return worlds;
}

bool NaiveOperation::fits(bool after, NaiveColors colors, const Pairs& world) const {
  std::vector<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < side(after).edges.size(); ++i)
    if (has(colors.inner, static_cast<int>(i))) edges.emplace_back(side(after).edges[i][0], side(after).edges[i][1]);
  // A node for each port's block: that of the smallest port connected with it.
  const int triangles = static_cast<int>(side(after).triangles);
  for (int port = 0; port < static_cast<int>(operation_.ports()); ++port) {
    if (!has(colors.ports, port)) continue;
    int block = port;
    for (const auto& [i, j] : world)
      if (j == port) block = std::min(block, i);
    edges.emplace_back(side(after).owner_of_port[static_cast<std::size_t>(port)], triangles + block);
  }
  return acyclic(triangles + static_cast<int>(operation_.ports()), edges);
}

long NaiveOperation::counted(const Term& term, NaiveColors configuration, NaiveColors after) const {
  const Side& patch = operation_.after;
  const std::vector<int> degree = degrees(true, after);
  const std::vector<int> component = components(true, after.inner);
  const auto bits = [](int mask) {
    long count = 0;
    for (; mask != 0; mask /= 2) count += mask % 2;
    return count;
  };
  long count = 0;
  switch (term.count) {
    case Count::strips:
      return static_cast<long>(patch.triangles) - bits(after.inner) - bits(after.ports);
    case Count::isolated:
      return std::count(degree.begin(), degree.end(), 0);
    case Count::given_up:
      return bits(configuration.ports) - bits(after.ports);
    case Count::kept:
      return bits(after.ports & static_cast<int>(term.among));
    case Count::joined:
      return bits(joined(true, after));
    case Count::solid:
      return bits(after.inner & static_cast<int>(term.among));
    case Count::ends:
      for (std::size_t i = 0; i < degree.size(); ++i)
        count += has(static_cast<int>(term.among), static_cast<int>(i)) && degree[i] == 1 ? 1 : 0;
      return count;
    case Count::ends_at_port:
      for (std::size_t port = 0; port < patch.owner_of_port.size(); ++port) {
        const unsigned owner = patch.owner_of_port[port];
        count += has(after.ports, static_cast<int>(port)) && degree[owner] == 1 &&
                         has(static_cast<int>(term.among), static_cast<int>(owner))
                     ? 1
                     : 0;
      }
      return count;
    case Count::neighbouring_ends:
      for (const auto& edge : patch.edges) count += degree[edge[0]] == 1 && degree[edge[1]] == 1 ? 1 : 0;
      return count;
    case Count::squares:
      break;
  }
  for (std::size_t i = 0; i < patch.owner_of_port.size(); ++i)  // ordered pairs of ports of one component
    for (std::size_t j = 0; j < patch.owner_of_port.size(); ++j)
      count += component[patch.owner_of_port[i]] == component[patch.owner_of_port[j]] ? 1 : 0;
  return count;
}

std::vector<long> NaiveOperation::cost(NaiveColors configuration, NaiveColors after) const {
  std::vector<long> values;
  for (const Criterion& criterion : operation_.cost) {
    values.push_back(0);
    for (const Term& term : criterion)
      values.back() += static_cast<long>(term.weight) * counted(term, configuration, after);
  }
  return values;
}

std::vector<NaiveCandidate> NaiveOperation::sound(NaiveColors configuration) const {
  std::vector<NaiveCandidate> found;
  const std::vector<Pairs> all = worlds(configuration.ports);
  for (int inner = 0; inner < 1 << operation_.after.edges.size(); ++inner)
    for (int kept = 0; kept <= configuration.ports; ++kept) {
      const int lost = configuration.ports - kept;
      if ((configuration.ports & kept) != kept || (lost & static_cast<int>(operation_.may_give_up)) != lost) continue;
      const NaiveColors after{inner, kept};
      if (!valid(true, after)) continue;
      if (std::all_of(all.begin(), all.end(), [&](const Pairs& world) {
            return !fits(false, configuration, world) || fits(true, after, world);
          }))
        found.push_back({after, cost(configuration, after)});
    }
  return found;
}

int NaiveOperation::moved_ports(const Symmetry& symmetry, int ports) {
  int result = 0;
  for (std::size_t i = 0; i < symmetry.ports.size(); ++i)
    if (has(ports, static_cast<int>(i))) result += 1 << symmetry.ports[i];
  return result;
}

int NaiveOperation::moved_pairs(const Symmetry& symmetry, int joined) {
  int result = 0;
  for (int j = 0; j < static_cast<int>(symmetry.ports.size()); ++j)
    for (int i = 0; i < j; ++i)
      if ((joined & pair_bit(i, j)) != 0)
        result += pair_bit(symmetry.ports[static_cast<std::size_t>(i)], symmetry.ports[static_cast<std::size_t>(j)]);
  return result;
}

/// -1 when some edge is taken to none.
int NaiveOperation::moved_edges(const Symmetry& symmetry, bool after, int inner) const {
  const std::vector<int>& move = after ? symmetry.after : symmetry.before;
  int result = 0;
  for (std::size_t i = 0; i < side(after).edges.size(); ++i) {
    if (!has(inner, static_cast<int>(i))) continue;
    const std::set<int> image = {move[side(after).edges[i][0]], move[side(after).edges[i][1]]};
    bool found = false;
    for (std::size_t j = 0; j < side(after).edges.size(); ++j)
      if (image ==
          std::set<int>{static_cast<int>(side(after).edges[j][0]), static_cast<int>(side(after).edges[j][1])}) {
        result += 1 << j;
        found = true;
      }
    if (!found) return -1;
  }
  return result;
}

/// Each criterion has the same terms when edges, triangles and ports are taken to their images.
bool NaiveOperation::cost_stays(const Symmetry& symmetry) const {
  for (const Criterion& criterion : operation_.cost) {
    std::multiset<std::tuple<Count, long, int>> terms;
    std::multiset<std::tuple<Count, long, int>> images;
    for (const Term& term : criterion) {
      const int among = static_cast<int>(term.among);
      int image = 0;
      if (term.count == Count::solid) image = moved_edges(symmetry, true, among);
      if (term.count == Count::kept) image = moved_ports(symmetry, among);
      if (term.count == Count::ends || term.count == Count::ends_at_port)
        for (std::size_t i = 0; i < symmetry.after.size(); ++i)
          if (has(among, static_cast<int>(i))) image += 1 << symmetry.after[i];
      terms.insert({term.count, static_cast<long>(term.weight), among});
      images.insert({term.count, static_cast<long>(term.weight), image});
    }
    if (terms != images) return false;
  }
  return true;
}

std::vector<NaiveOperation::Symmetry> NaiveOperation::symmetries() const {
  const auto identity = [](std::size_t size) {
    std::vector<int> permutation(size);
    std::iota(permutation.begin(), permutation.end(), 0);
    return permutation;
  };
  std::vector<Symmetry> found;
  Symmetry symmetry{identity(operation_.ports()), {}, {}};
  const auto keeps_side = [&](bool after) {
    const std::vector<int>& move = after ? symmetry.after : symmetry.before;
    const std::vector<unsigned>& owner = side(after).owner_of_port;
    for (std::size_t port = 0; port < owner.size(); ++port)
      if (move[owner[port]] != static_cast<int>(owner[static_cast<std::size_t>(symmetry.ports[port])])) return false;
    return moved_edges(symmetry, after, (1 << side(after).edges.size()) - 1) >= 0;
  };
  const int may = static_cast<int>(operation_.may_give_up);
  do {
    if (moved_ports(symmetry, may) != may) continue;
    symmetry.before = identity(operation_.before.triangles);
    do {
      if (!keeps_side(false)) continue;
      symmetry.after = identity(operation_.after.triangles);
      do {
        if (keeps_side(true) && cost_stays(symmetry)) found.push_back(symmetry);
      } while (std::next_permutation(symmetry.after.begin(), symmetry.after.end()));
    } while (std::next_permutation(symmetry.before.begin(), symmetry.before.end()));
  } while (std::next_permutation(symmetry.ports.begin(), symmetry.ports.end()));
  return found;
}

long NaiveOperation::change(const NaiveRow& row, NaiveColors configuration, Count count) const {
  const auto bits = [](int mask) { return static_cast<long>(__builtin_popcount(static_cast<unsigned>(mask))); };
  if (count == Count::strips)
    return static_cast<long>(operation_.after.triangles) - static_cast<long>(operation_.before.triangles) -
           bits(row.after.inner) + bits(configuration.inner) - bits(row.after.ports) + bits(configuration.ports);
  const std::vector<int> before = degrees(false, configuration);
  const std::vector<int> after = degrees(true, row.after);
  return std::count(after.begin(), after.end(), 0) - std::count(before.begin(), before.end(), 0) +
         bits(configuration.ports) - bits(row.after.ports);
}

std::optional<NaiveCertificate> NaiveOperation::certificate() const {
  const std::vector<Symmetry> group = symmetries();
  std::map<std::pair<int, int>, NaiveRow> rows;
  std::set<NaiveColors> smallest;
  std::set<NaiveColors> smallest_valid;
  long valid_ones = 0;
  long costing = 0;
  std::vector<long> strips;
  std::vector<long> isolated;
  for (const NaiveColors& configuration : configurations()) {
    NaiveColors least = configuration;
    for (const Symmetry& symmetry : group)
      least = std::min(least, NaiveColors{moved_edges(symmetry, false, configuration.inner),
                                          moved_ports(symmetry, configuration.ports)});
    smallest.insert(least);
    if (!valid(false, configuration)) continue;
    smallest_valid.insert(least);
    ++valid_ones;
    const std::pair key(configuration.ports, joined(false, configuration));
    rows.try_emplace(key, NaiveRow{key.first, key.second, {-1, 0}, {}});
  }
  // Keys in ascending order: the first of an orbit is searched for, the others are its images.
  for (auto& [key, row] : rows) {
    if (row.after.inner >= 0) continue;
    NaiveColors example;
    for (const NaiveColors& configuration : configurations())
      if (valid(false, configuration) && std::pair(configuration.ports, joined(false, configuration)) == key)
        example = configuration;
    const std::vector<NaiveCandidate> candidates = sound(example);
    if (candidates.empty()) return {};
    row.after = std::min_element(candidates.begin(), candidates.end(), [](const auto& one, const auto& other) {
                  return one.cost < other.cost;
                })->after;
    for (const Symmetry& symmetry : group) {
      NaiveRow& image = rows.at({moved_ports(symmetry, key.first), moved_pairs(symmetry, key.second)});
      if (image.after.inner >= 0) continue;
      image.after = {moved_edges(symmetry, true, row.after.inner), moved_ports(symmetry, row.after.ports)};
      for (std::size_t port = 0; port < symmetry.ports.size(); ++port)  // the way back
        image.by.push_back(static_cast<int>(
            std::find(symmetry.ports.begin(), symmetry.ports.end(), static_cast<int>(port)) - symmetry.ports.begin()));
    }
  }
  const Count what = operation_.constraint == Constraint::matching ? Count::isolated : Count::strips;
  for (const NaiveColors& configuration : configurations()) {
    if (!valid(false, configuration)) continue;
    const NaiveRow& row = rows.at({configuration.ports, joined(false, configuration)});
    strips.push_back(change(row, configuration, Count::strips));
    isolated.push_back(change(row, configuration, Count::isolated));
    costing += change(row, configuration, what) > 0 ? 1 : 0;
  }
  NaiveCertificate certificate;
  certificate.name = operation_.name;
  certificate.claims = {{"configurations", static_cast<long>(configurations().size())},
                        {"valid", valid_ones},
                        {"orbits", static_cast<long>(smallest.size())},
                        {"valid-orbits", static_cast<long>(smallest_valid.size())},
                        {"keys", static_cast<long>(rows.size())},
                        {"costing", costing},
                        {"worst-strips", *std::max_element(strips.begin(), strips.end())},
                        {"worst-isolated", *std::max_element(isolated.begin(), isolated.end())}};
  for (const auto& [key, row] : rows) certificate.rows.push_back(row);
  return certificate;
}

std::string NaiveOperation::dump(const NaiveCertificate& certificate) const {
  std::string text = fmt::format("restrip-operation-dump 1\noperation {}\n", operation_.name);
  std::size_t entries = 0;
  for (const NaiveColors& configuration : configurations()) {
    if (operation_.constraint == Constraint::matching && configuration.inner != 0) break;
    ++entries;
    std::string answer = "-";
    if (valid(false, configuration))
      for (const NaiveRow& row : certificate.rows)
        if (row.ports == configuration.ports && row.joined == joined(false, configuration))
          answer = fmt::format("{:x} {:x}", row.after.inner, row.after.ports);
    text += fmt::format("{:x} {:x} {}\n", configuration.inner, configuration.ports, answer);
  }
  return text + fmt::format("end {}\n", entries);
}

}  // namespace restrip::verify::operations::test
