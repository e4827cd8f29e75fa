#include "judge/worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace restrip::verify {
namespace {

/// With blocks numbered in the order of their first ports, and without the pairs of which one port is left.
World renumbered(const World& world, bool pairs) {
  std::array<unsigned, most_ports + 1> size{};
  for (const std::uint8_t block : world.block_of) ++size[block];
  std::array<std::uint8_t, most_ports + 1> number{};
  std::uint8_t blocks = 0;
  World result;
  for (unsigned port = 0; port < most_ports; ++port) {
    const std::uint8_t block = world.block_of[port];
    if (block == 0 || (pairs && size[block] == 1)) continue;
    if (number[block] == 0) number[block] = ++blocks;
    result.block_of[port] = number[block];
  }
  return result;
}

std::optional<unsigned> partner(PortPairs pairs, unsigned port, unsigned ports) {
  for (unsigned other = 0; other < ports; ++other)
    if (other != port && pairs.has(port, other)) return other;
  return {};
}

}  // namespace

Worlds::Worlds(Constraint constraint, unsigned ports)
    : constraint_(constraint), ports_(ports), worlds_(mask_count(ports)) {
  for (Mask mask = 0; mask < mask_count(ports); ++mask) {
    extend({}, mask, 0, 0);
    std::sort(worlds_[mask].begin(), worlds_[mask].end());
  }
}

void Worlds::extend(World world, Mask ports, unsigned port, unsigned blocks) {
  while (port < ports_ && !is_solid(ports, port)) ++port;
  if (port == ports_) {
    worlds_[ports].push_back(world);
    return;
  }
  const bool partner_came_before = world.block_of[port] != 0;
  if (constraint_ != Constraint::forest) extend(world, ports, port + 1, blocks);
  if (constraint_ == Constraint::matching || partner_came_before) return;
  if (constraint_ == Constraint::strips) {
    for (unsigned partner = port + 1; partner < ports_; ++partner) {
      if (!is_solid(ports, partner) || world.block_of[partner] != 0) continue;
      World next = world;
      next.block_of[port] = next.block_of[partner] = static_cast<std::uint8_t>(blocks + 1);
      extend(next, ports, port + 1, blocks + 1);
    }
    return;
  }
  for (unsigned block = 1; block <= blocks + 1; ++block) {
    world.block_of[port] = static_cast<std::uint8_t>(block);
    extend(world, ports, port + 1, std::max(blocks, block));
  }
}

std::vector<std::uint32_t> Worlds::restrictions(Mask ports, Mask kept) const {
  std::vector<std::uint32_t> result;
  result.reserve(of(ports).size());
  for (World world : of(ports)) {
    for (unsigned port = 0; port < most_ports; ++port)
      if (!is_solid(kept, port)) world.block_of[port] = 0;
    world = renumbered(world, constraint_ == Constraint::strips);
    const auto place = std::lower_bound(of(kept).begin(), of(kept).end(), world);
    if (place == of(kept).end() || *place != world) throw std::logic_error("a world without some ports is no world");
    result.push_back(static_cast<std::uint32_t>(place - of(kept).begin()));
  }
  return result;
}

std::string Worlds::text_of(const World& world) const {
  std::string text;
  for (unsigned block = 1; block <= most_ports; ++block) {
    std::string ports;
    for (unsigned port = 0; port < ports_; ++port)
      if (world.block_of[port] == block) ports += fmt::format("{}{}", ports.empty() ? "" : "-", port);
    if (ports.size() > 1) text += ' ' + ports;
  }
  return text.empty() ? "no ports connected outside" : fmt::format("ports{} connected outside", text);
}

bool fits(const Side& side, const SolidGraph& inner, Mask ports, const World& world) {
  SolidGraph graph = inner;
  for (unsigned port = 0; port < side.ports(); ++port)
    if (is_solid(ports, port) && world.block_of[port] != 0 &&
        !graph.join(side.owner_of_port[port], SolidGraph::outside(world.block_of[port] - 1U)))
      return false;
  return true;
}

PortPairs pairs_of(const World& world) {
  PortPairs pairs;
  for (unsigned j = 1; j < most_ports; ++j)
    for (unsigned i = 0; i < j; ++i)
      if (world.block_of[i] != 0 && world.block_of[i] == world.block_of[j]) pairs.add(i, j);
  return pairs;
}

bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports) {
  for (unsigned start = 0; start < ports; ++start)
    for (std::optional<unsigned> at = start; at;) {
      at = partner(one, *at, ports);
      if (at) at = partner(other, *at, ports);
      if (at == start) return true;
    }
  return false;
}

}  // namespace restrip::verify
