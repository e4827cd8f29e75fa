// The colours that an operation with a table writes under a policy that searches: its rule, or cheaper colours that
// join two ports only if they were joined before. Included by rule_choice.hpp.
//
// Such colours are sound for every surrounding mesh: a strip that closes over them would have closed before the
// operation. A patch of up to six inner edges has at most 64 colourings, which are priced before anything is written.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "restrip/mesh/cost.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/search/impl/descent.hpp"

namespace restrip::detail {

/// The most inner edges of a patch for which all colours are tried.
inline constexpr unsigned most_tried_edges = 6;

/// Finds the port at the other end of each port's strip in the patch: partner[p], or p if the strip ends inside.
/// `solid`: inner edges and ports. Returns false if the colours are not valid.
template <class Triangles>
bool strip_partners(const Triangles& triangles, PatchEdges solid, std::array<std::uint8_t, 32>& partner) {
  using tables::PatchTriangle;
  std::array<std::uint8_t, tables::most_patch_triangles> strip;  // of the triangles
  std::array<std::uint8_t, 32> first;                            // triangle of an inner edge met before
  std::iota(strip.begin(), strip.end(), std::uint8_t{0});
  PatchEdges met = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    int degree = 0;
    for (const std::uint8_t side : triangles[t].side) {
      const PatchEdges edge = edge_of(side);
      if ((solid & edge) == 0) continue;
      ++degree;
      if (side >= PatchTriangle::port_side) continue;
      if ((met & edge) == 0) {
        first[side] = static_cast<std::uint8_t>(t);
      } else {
        const std::uint8_t one = strip[first[side]];
        const std::uint8_t other = strip[t];
        if (one == other) return false;
        std::replace(strip.begin(), strip.end(), other, one);
      }
      met |= edge;
    }
    if (degree > 2) return false;
  }
  std::array<std::uint8_t, tables::most_patch_triangles> port_of;
  port_of.fill(PatchTriangle::boundary_side);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::uint8_t side : triangles[t].side) {
      if (side < PatchTriangle::port_side || (solid & edge_of(side)) == 0) continue;
      const auto port = static_cast<std::uint8_t>(side - PatchTriangle::port_side);
      std::uint8_t& other = port_of[strip[t]];
      partner[port] = port;
      if (other == PatchTriangle::boundary_side) {
        other = port;
      } else {
        partner[port] = other;
        partner[other] = port;
      }
    }
  return true;
}

/// Strips, swaps and isolated triangles of a patch with these colours, up to a constant. `outside[p]`: how the strip
/// turns outside port p.
template <class Triangles>
ColoringChange tally(const Triangles& triangles, PatchEdges solid, const std::array<std::uint8_t, 32>& outside) {
  using tables::PatchTriangle;
  ColoringChange sum{-std::popcount(solid), 0, tables::isolated_among(triangles, solid)};
  std::array<std::uint8_t, 32> turn;  // at an inner edge met before
  PatchEdges met = 0;
  for (const PatchTriangle& triangle : triangles) {
    unsigned sides = 0;
    for (unsigned s = 0; s < 3; ++s) sides |= (solid & edge_of(triangle.side[s])) != 0 ? 1U << s : 0;
    for (unsigned s = 0; s < 3; ++s) {
      const std::uint8_t side = triangle.side[s];
      if ((sides >> s & 1) == 0) continue;
      const unsigned here = other_sides(sides, s);
      if (side >= PatchTriangle::port_side)
        sum.swaps += is_swap(here, outside[side - PatchTriangle::port_side]);
      else if ((met & edge_of(side)) != 0)
        sum.swaps += is_swap(here, turn[side]);
      else
        turn[side] = static_cast<std::uint8_t>(here);
      met |= edge_of(side);
    }
  }
  return sum;
}

/// The cheapest of the rule and the colours that join only ports that `solid` joined. Of equal prices the one with the
/// most strips, because a search begins at their ends; then the rule.
template <class Mesh, class Table, class Sides>
tables::OperationRule cheapest_for_patch(const Mesh& mesh, const Table& table, const Sides& patch, PatchEdges solid,
                                         const tables::OperationRule& rule, const Cost& cost) {
  using tables::PatchTriangle;
  std::array<std::uint8_t, 32> outside{};
  std::array<std::uint8_t, 32> before{};
  std::array<std::uint8_t, 32> now{};
  if (!strip_partners(table.triangles_before, solid, before)) return rule;
  const PatchEdges ports = solid & all_ports;
  int cleared = 0;  // swaps outside ports that the rule clears
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s) {
      const std::uint8_t side = patch.triangles[t].side[s];
      if (side < PatchTriangle::port_side || (ports & edge_of(side)) == 0) continue;
      const auto outer = mesh.opposite(patch.side[t][s]);
      const unsigned turn = other_solid_sides(mesh, outer);
      outside[side - PatchTriangle::port_side] = static_cast<std::uint8_t>(turn);
      if (turn != 0 && (rule.ports >> (side - PatchTriangle::port_side) & 1) == 0)
        cleared += swap_beyond(mesh, outer, turn);
    }
  ColoringChange by_rule = tally(table.triangles_after, patch_edges(rule.colors, rule.ports), outside);
  by_rule.swaps -= cleared;
  const auto order = [&cost](const ColoringChange& change) { return std::pair(change.price(cost), -change.strips); };
  auto least = order(by_rule);
  tables::OperationRule best = rule;
  for (std::uint32_t colors = 0; colors < std::uint32_t{1} << table.after.edges; ++colors) {
    const PatchEdges tried = ports | colors;
    const ColoringChange change = tally(table.triangles_after, tried, outside);
    if (order(change) >= least || !strip_partners(table.triangles_after, tried, now)) continue;
    bool joins = false;
    for (PatchEdges rest = ports >> 32; rest != 0; rest &= rest - 1) {
      const auto port = static_cast<std::size_t>(std::countr_zero(rest));
      joins |= now[port] != port && now[port] != before[port];
    }
    if (joins) continue;
    least = order(change);
    best = {colors, static_cast<std::uint32_t>(ports >> 32), rule.strips + change.strips - by_rule.strips, true};
  }
  return best;
}

}  // namespace restrip::detail
