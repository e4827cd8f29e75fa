#include "judge/fit_table.hpp"

namespace restrip::verify {
namespace {

/// The ports, and for each one a digit: the number of the set of connected triangles that it leads to, 0 if it is
/// dashed.
std::uint64_t connections(const Side& side, const SolidGraph& inner, Mask ports) {
  std::array<unsigned, most_triangles + most_ports> number{};
  unsigned sets = 0;
  std::uint64_t graph = ports;
  for (unsigned port = 0; port < side.ports(); ++port) {
    graph *= 16;
    if (!is_solid(ports, port)) continue;
    unsigned& own = number[inner.root(side.owner_of_port[port])];
    if (own == 0) own = ++sets;
    graph += own;
  }
  return graph;
}

}  // namespace

FitTable::FitTable(Constraint constraint, unsigned ports)
    : worlds_(constraint, ports), known_sets_(mask_count(ports)) {}

FitTable::Found FitTable::class_of(const Side& side, const SolidGraph& inner, Mask ports) {
  const auto [place, is_new] = known_graphs_.try_emplace(connections(side, inner, ports));
  Found& found = place->second;
  if (!is_new) return found;
  NumberSet fitted(worlds_.of(ports).size());
  for (std::size_t world = 0; world < worlds_.of(ports).size(); ++world)
    if (fits(side, inner, ports, worlds_.of(ports)[world])) fitted.add(world);
  found.joined = joined_ports(side, inner, ports);
  const auto [known, is_new_set] = known_sets_[ports].try_emplace(fitted, static_cast<std::uint32_t>(classes_.size()));
  if (is_new_set) classes_.push_back({ports, fitted, found.joined});
  found.fit_class = known->second;
  return found;
}

const std::vector<std::uint32_t>& FitTable::restriction(Mask ports, Mask kept) {
  const auto [place, is_new] = restrictions_.try_emplace({ports, kept});
  if (is_new) place->second = worlds_.restrictions(ports, kept);
  return place->second;
}

std::size_t FitTable::refuting_world(std::uint32_t before, std::uint32_t after) {
  const FitClass& one = classes_[before];
  const FitClass& other = classes_[after];
  const std::vector<std::uint32_t>& left = restriction(one.ports, other.ports);
  std::size_t world = 0;
  while (world < left.size() && !(one.worlds.has(world) && !other.worlds.has(left[world]))) ++world;
  return world;
}

bool FitTable::sound(std::uint32_t before, std::uint32_t after) {
  const FitClass& one = classes_[before];
  const FitClass& other = classes_[after];
  return one.ports == other.ports ? one.worlds.within(other.worlds)
                                  : refuting_world(before, after) == worlds_.of(one.ports).size();
}

}  // namespace restrip::verify
