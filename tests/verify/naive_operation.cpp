#include "naive_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace restrip::verify::test {
namespace {

bool has(int mask, int i) { return mask / (1 << i) % 2 == 1; }
int bits(int mask) { return mask == 0 ? 0 : mask % 2 + bits(mask / 2); }

int pair_bit(int i, int j) { return 1 << (std::max(i, j) * (std::max(i, j) - 1) / 2 + std::min(i, j)); }

constexpr std::size_t most_nodes = 40;

/// A number for each node of a graph, equal for nodes that its edges connect.
class Components {
 public:
  explicit Components(int nodes) : nodes_(nodes) { std::iota(number_.begin(), number_.end(), 0); }
  void connect(int one, int other) {
    ++edges_;
    const int from = number_[static_cast<std::size_t>(one)];
    const int to = number_[static_cast<std::size_t>(other)];
    if (from == to) return;
    --components_;
    std::replace(number_.begin(), number_.begin() + nodes_, from, to);
  }
  /// Whether the number of edges is the nodes minus the components.
  bool acyclic() const { return edges_ == -components_; }
  int of(unsigned node) const { return number_[node]; }

 private:
  int nodes_;
  std::array<int, most_nodes> number_{};
  int edges_ = 0;
  int components_ = 0;  ///< minus the nodes
};

/// The triangles of a side, connected by its solid edges, and further nodes.
Components connected(const Side& side, int inner, int further = 0) {
  Components found(static_cast<int>(side.triangles) + further);
  for (std::size_t i = 0; i < side.edges.size(); ++i)
    if (has(inner, static_cast<int>(i)))
      found.connect(static_cast<int>(side.edges[i][0]), static_cast<int>(side.edges[i][1]));
  return found;
}

bool is_named(const Side& side, unsigned triangle, const char* name) {
  return triangle < side.names.size() && side.names[triangle] == name;
}

}  // namespace

NaiveOperation::NaiveOperation(Operation operation) : operation_(std::move(operation)) {
  const int all = 1 << ports();
  for (int ports = 0; ports < all; ++ports) worlds_.push_back(worlds_of(ports));
  std::vector<int> joined_with(static_cast<std::size_t>(all));
  for (int kept = 0; kept < all; ++kept)
    for (int inner = 0; inner < 1 << operation_.after.edges.size(); ++inner)
      if (valid(true, {inner, kept})) joined_with[static_cast<std::size_t>(kept)] |= joined(true, {inner, kept});
  joinable_.resize(joined_with.size());
  for (int ports = 0; ports < all; ++ports)
    for (int kept = 0; kept <= ports; ++kept)
      if (may_keep(ports, kept))
        joinable_[static_cast<std::size_t>(ports)] |= joined_with[static_cast<std::size_t>(kept)];
}

bool NaiveOperation::may_keep(int ports, int kept) const {
  const int lost = ports - kept;
  return (ports & kept) == kept && (lost & static_cast<int>(operation_.may_give_up)) == lost;
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

/// Whether the chord is part of a cycle: a patch of a fan cannot have two cycles at once.
bool NaiveOperation::cycle_allowed(bool after, int inner, Dropped dropped) const {
  if (dropped == Dropped::all_cycles) return true;
  const Side& patch = side(after);
  if (patch.edges.empty()) return false;
  const auto& [one, other] = patch.edges.back();
  const bool has_chord = is_named(patch, one, "A") && is_named(patch, other, "D");
  const bool uses_chord = has_chord && has(inner, static_cast<int>(patch.edges.size()) - 1);
  return dropped == Dropped::outer_cycle ? has_chord && !uses_chord : dropped == Dropped::chord_cycles && uses_chord;
}

bool NaiveOperation::valid(bool after, NaiveColors colors, Dropped dropped) const {
  const int most = operation_.constraint == Constraint::strips ? 2 : 1;
  const std::vector<int> degree = degrees(after, colors);
  for (unsigned triangle = 0; triangle < degree.size(); ++triangle) {
    const bool is_new = is_named(side(after), triangle, "A") || is_named(side(after), triangle, "D");
    if (degree[triangle] > most && dropped != Dropped::degrees && !(dropped == Dropped::new_degrees && is_new))
      return false;
  }
  return fits(after, {colors.inner, 0}, {}) || cycle_allowed(after, colors.inner, dropped);
}

int NaiveOperation::joined(bool after, NaiveColors colors) const {
  const Components component = connected(side(after), colors.inner);
  const std::vector<unsigned>& owner = side(after).owner_of_port;
  int pairs = 0;
  for (int j = 0; j < static_cast<int>(operation_.ports()); ++j)
    for (int i = 0; i < j; ++i)
      if (has(colors.ports, i) && has(colors.ports, j) &&
          component.of(owner[static_cast<std::size_t>(i)]) == component.of(owner[static_cast<std::size_t>(j)]))
        pairs += pair_bit(i, j);
  return pairs;
}

int NaiveOperation::isolated(bool after, NaiveColors colors) const {
  const std::vector<int> degree = degrees(after, colors);
  return static_cast<int>(std::count(degree.begin(), degree.end(), 0));
}

NaiveKey NaiveOperation::key(NaiveColors configuration) const {
  return {configuration.ports, joined(false, configuration) & joinable_[static_cast<std::size_t>(configuration.ports)]};
}

/// No port is in two of them.
std::vector<Pairs> NaiveOperation::worlds_of(int ports) const {
  std::vector<std::pair<int, int>> all;
  for (int j = 0; j < static_cast<int>(operation_.ports()); ++j)
    for (int i = 0; i < j; ++i)
      if (has(ports, i) && has(ports, j)) all.emplace_back(i, j);
  if (operation_.constraint == Constraint::matching) all.clear();
  std::vector<Pairs> worlds;
  for (int chosen = 0; chosen < 1 << all.size(); ++chosen) {
    Pairs world;
    std::set<int> ends;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (has(chosen, static_cast<int>(i))) {
        world.insert(all[i]);
        ends.insert({all[i].first, all[i].second});
      }
    if (ends.size() == 2 * world.size()) worlds.push_back(world);
  }
  return worlds;
}

bool NaiveOperation::fits(bool after, NaiveColors colors, const Pairs& world) const {
  const int triangles = static_cast<int>(side(after).triangles);
  Components found = connected(side(after), colors.inner, ports());
  // A node for each port's block: the node of the smallest port connected with it.
  for (int port = 0; port < ports(); ++port) {
    if (!has(colors.ports, port)) continue;
    int block = port;
    for (const auto& [i, j] : world)
      if (j == port) block = std::min(block, i);
    found.connect(static_cast<int>(side(after).owner_of_port[static_cast<std::size_t>(port)]), triangles + block);
  }
  return found.acyclic();
}

long NaiveOperation::counted(const Term& term, NaiveColors configuration, NaiveColors after) const {
  const Side& patch = operation_.after;
  const std::vector<int> degree = degrees(true, after);
  const Components component = connected(patch, after.inner);
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
      count += component.of(patch.owner_of_port[i]) == component.of(patch.owner_of_port[j]) ? 1 : 0;
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

std::vector<NaiveCandidate> NaiveOperation::sound(NaiveColors configuration, Dropped dropped) const {
  std::vector<const Pairs*> fitted;
  for (const Pairs& world : worlds(configuration.ports))
    if (fits(false, configuration, world)) fitted.push_back(&world);
  const int joined_before = joined(false, configuration);
  std::vector<NaiveCandidate> found;
  for (int inner = 0; inner < 1 << operation_.after.edges.size(); ++inner)
    for (int kept = 0; kept <= configuration.ports; ++kept) {
      const NaiveColors after{inner, kept};
      if (!may_keep(configuration.ports, kept) || !valid(true, after, dropped)) continue;
      const bool is_sound =
          dropped == Dropped::nothing
              ? std::all_of(fitted.begin(), fitted.end(), [&](const Pairs* world) { return fits(true, after, *world); })
              : dropped == Dropped::pairing || (joined(true, after) | joined_before) == joined_before;
      if (is_sound) found.push_back({after, cost(configuration, after)});
    }
  return found;
}

NaiveKey NaiveOperation::moved(const NaiveSymmetry& symmetry, NaiveKey key) const {
  NaiveKey result{0, 0};
  for (int j = 0; j < ports(); ++j) {
    const int to = symmetry.ports[static_cast<std::size_t>(j)];
    if (has(key.first, j)) result.first += 1 << to;
    for (int i = 0; i < j; ++i)
      if ((key.second & pair_bit(i, j)) != 0)
        result.second += pair_bit(symmetry.ports[static_cast<std::size_t>(i)], to);
  }
  return result;
}

NaiveColors NaiveOperation::moved(const NaiveSymmetry& symmetry, bool after, NaiveColors colors) const {
  return {moved_edges(symmetry, after, colors.inner), moved(symmetry, NaiveKey{colors.ports, 0}).first};
}

/// -1 if some edge is not mapped to an edge.
int NaiveOperation::moved_edges(const NaiveSymmetry& symmetry, bool after, int inner) const {
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

/// Each criterion keeps its terms when edges, triangles and ports are mapped.
bool NaiveOperation::cost_stays(const NaiveSymmetry& symmetry) const {
  for (const Criterion& criterion : operation_.cost) {
    std::multiset<std::tuple<Count, long, int>> terms;
    std::multiset<std::tuple<Count, long, int>> images;
    for (const Term& term : criterion) {
      const int among = static_cast<int>(term.among);
      int image = 0;
      if (term.count == Count::solid) image = moved_edges(symmetry, true, among);
      if (term.count == Count::kept) image = moved(symmetry, NaiveKey{among, 0}).first;
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

std::vector<NaiveSymmetry> NaiveOperation::symmetries(bool before_too) const {
  const auto identity = [](std::size_t size) {
    std::vector<int> permutation(size);
    std::iota(permutation.begin(), permutation.end(), 0);
    return permutation;
  };
  std::vector<NaiveSymmetry> found;
  NaiveSymmetry symmetry{identity(operation_.ports()), {}, {}};
  const auto keeps_side = [&](bool after) {
    const std::vector<int>& move = after ? symmetry.after : symmetry.before;
    const std::vector<unsigned>& owner = side(after).owner_of_port;
    for (std::size_t port = 0; port < owner.size(); ++port)
      if (move[owner[port]] != static_cast<int>(owner[static_cast<std::size_t>(symmetry.ports[port])])) return false;
    return moved_edges(symmetry, after, (1 << side(after).edges.size()) - 1) >= 0;
  };
  const int may = static_cast<int>(operation_.may_give_up);
  do {
    if (moved(symmetry, NaiveKey{may, 0}).first != may) continue;
    symmetry.before = identity(operation_.before.triangles);
    do {
      if (before_too && !keeps_side(false)) continue;
      symmetry.after = identity(operation_.after.triangles);
      do {
        if (keeps_side(true) && cost_stays(symmetry)) found.push_back(symmetry);
      } while (std::next_permutation(symmetry.after.begin(), symmetry.after.end()));
    } while (before_too && std::next_permutation(symmetry.before.begin(), symmetry.before.end()));
  } while (std::next_permutation(symmetry.ports.begin(), symmetry.ports.end()));
  return found;
}

long NaiveOperation::change(NaiveColors after, NaiveColors configuration, Count count) const {
  const long lost = bits(configuration.ports) - bits(after.ports);
  if (count == Count::isolated) return isolated(true, after) - isolated(false, configuration) + lost;
  return static_cast<long>(operation_.after.triangles) - static_cast<long>(operation_.before.triangles) -
         bits(after.inner) + bits(configuration.inner) + lost;
}

}  // namespace restrip::verify::test
