#include "patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace restrip::generator {
namespace {

/// t_i is node i, and the others follow in the order in which they stand.
Side side_at(const SidePattern& pattern, const PositionNumbers& numbers) {
  Side side;
  for (const Stretch& stretch : pattern.stretches)
    if (stretch.name == "t") side.nodes += stretch.to.at(numbers) - stretch.from.at(numbers);
  for (unsigned t = 0; pattern.ports.empty() && t < side.nodes; ++t) side.owner.push_back(t);
  std::vector<unsigned> order;
  std::map<std::string, unsigned> named;
  for (const Stretch& stretch : pattern.stretches) {
    if (stretch.name == "t") {
      for (unsigned t = stretch.from.at(numbers); t < stretch.to.at(numbers); ++t) order.push_back(t);
      continue;
    }
    named[stretch.name] = side.nodes;
    order.push_back(side.nodes++);
  }
  for (std::size_t i = 0; i + 1 < order.size(); ++i) side.edges.push_back({order[i], order[i + 1]});
  if (pattern.ring) side.edges.push_back({order.back(), order.front()});
  if (!pattern.chord.empty()) side.edges.push_back({named.at(pattern.chord[0]), named.at(pattern.chord[1])});
  for (const std::string& triangle : pattern.ports) side.owner.push_back(named.at(triangle));
  return side;
}

}  // namespace

bool closed(const Family& family) { return family.before.ring; }

bool serves_every_position(const Family& family) {
  return std::any_of(family.numbers.begin(), family.numbers.end(), [&](const std::string& number) {
    return family.section.find(fmt::format("{{{}}}", number)) == std::string::npos;
  });
}

unsigned smallest_valence(const Family& family) {
  for (unsigned k = 1; k < 64; ++k)
    if (!positions(family, k).empty()) return k;
  throw std::logic_error("a family without a position: " + family.name);
}

std::vector<Position> positions(const Family& family, unsigned k) {
  if (family.numbers.empty()) return {{&family, static_cast<unsigned>(family.before.ports.size()), 0, 0}};
  const unsigned last_at = family.numbers.size() > 1 ? k : 0;
  const unsigned last_to = family.numbers.size() > 2 ? k : 0;
  std::vector<Position> list;
  for (unsigned at = 0; at <= last_at; ++at)
    for (unsigned to = 0; to <= last_to; ++to)
      if (hold(family.where, {k, at, to}) && hold(family.listed, {k, at, to})) list.push_back({&family, k, at, to});
  return list;
}

Patch make_patch(const Position& position) {
  const PositionNumbers numbers = position.numbers();
  return {side_at(position.family->before, numbers), side_at(position.family->after, numbers)};
}

Patch patch_of_rows(const Position& position) {
  if (!serves_every_position(*position.family)) return make_patch(position);
  const Side after = side_at(position.family->after, position.numbers());
  return {after, after};
}

}  // namespace restrip::generator
