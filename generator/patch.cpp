#include "patch.hpp"

#include <numeric>
#include <stdexcept>
#include <utility>

namespace restrip::generator {
namespace {

/// Consecutive elements of `order` joined by inner edges; a ring closes.
std::vector<Edge> chain(const std::vector<unsigned>& order, bool ring) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) edges.push_back({order[i], order[i + 1]});
  if (ring) edges.push_back({order.back(), order.front()});
  return edges;
}

/// Ports 0 … k-1 on nodes 0 … k-1.
std::vector<unsigned> one_port_each(unsigned k) {
  std::vector<unsigned> owner(k);
  std::iota(owner.begin(), owner.end(), 0U);
  return owner;
}

/// t_0 … t_{k-1} as nodes 0 … k-1.
Side fan(unsigned k, bool closed) {
  const auto order = one_port_each(k);
  return {k, chain(order, closed), order};
}

/// The fan with A (node k) and, when there is a second place, D (node k + 1) inserted in front of t_at and t_to.
Side fan_with_new_triangles(const Position& position, bool closed) {
  const bool two = position.family != Family::boundary_split;
  const unsigned k = position.k;
  const unsigned first = closed ? 0 : position.at;
  const unsigned second = closed ? position.at : position.to;
  std::vector<unsigned> order;
  for (unsigned i = 0; i <= k; ++i) {
    if (i == first) order.push_back(k);
    if (two && i == second) order.push_back(k + 1);
    if (i < k) order.push_back(i);
  }
  Side side{k + (two ? 2U : 1U), chain(order, closed), one_port_each(k)};
  if (two) side.edges.push_back({k, k + 1});
  return side;
}

Family matching_split(Family family) {
  switch (family) {
    case Family::collapse:
      return Family::split;
    case Family::open_collapse:
      return Family::open_split;
    case Family::boundary_collapse:
      return Family::boundary_split;
    default:
      return family;
  }
}

}  // namespace

std::string name_of(Family family) {
  switch (family) {
    case Family::split:
      return "split";
    case Family::collapse:
      return "collapse";
    case Family::open_split:
      return "open-split";
    case Family::open_collapse:
      return "open-collapse";
    case Family::boundary_split:
      return "boundary-split";
    case Family::boundary_collapse:
      return "boundary-collapse";
    case Family::flip:
      return "flip";
  }
  throw std::logic_error("a family without a name");
}

bool closed(Family family) { return matching_split(family) == Family::split; }

bool collapses(Family family) { return matching_split(family) != family; }

unsigned smallest_valence(Family family) { return closed(family) ? 3 : 1; }

std::vector<Position> positions(Family family, unsigned k) {
  if (family == Family::flip) return {{family, 4, 0, 0}};
  std::vector<Position> list;
  if (k < smallest_valence(family)) return list;
  switch (matching_split(family)) {
    case Family::split:
      for (unsigned a = 1; a <= k / 2; ++a) list.push_back({family, k, a, 0});
      break;
    case Family::open_split:
      for (unsigned i = 0; i <= k; ++i)
        for (unsigned j = i + 1; i + j <= k; ++j) list.push_back({family, k, i, j});
      break;
    default:
      for (unsigned i = 0; i <= k / 2; ++i) list.push_back({family, k, i, 0});
  }
  return list;
}

Patch make_patch(const Position& position) {
  if (position.family == Family::flip) return {{2, {{0, 1}}, {0, 0, 1, 1}}, {2, {{0, 1}}, {1, 0, 0, 1}}};
  Position split = position;
  split.family = matching_split(position.family);
  const bool ring = closed(position.family);
  Patch patch{fan(position.k, ring), fan_with_new_triangles(split, ring)};
  if (collapses(position.family)) std::swap(patch.before, patch.after);
  return patch;
}

Patch make_fan_patch(unsigned k, bool closed) { return {fan(k, closed), fan(k, closed)}; }

}  // namespace restrip::generator
