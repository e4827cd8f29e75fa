// The table of a custom operation, given by a caller, and checked so completely that no mesh can be spoiled by it.
//
// A rule is sound in every surrounding mesh if it leaves a valid colouring of the patch, sets no port, and joins two
// ports inside the patch only if they were joined there before: a cycle through the new patch would then have been one
// through the old patch. joined() finds which ports a colouring joins, with union-find over the triangles.
//
// The mesh stays a manifold if on both sides the triangles at each vertex are one fan: a vertex at ports has the same
// ports on both sides, so its fan begins and ends at the same mesh edges, or on the boundary before and after.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "restrip.h"
#include "restrip/restrip.hpp"

struct restrip_table {
  std::vector<restrip::tables::PatchTriangle> before;
  std::vector<restrip::tables::PatchTriangle> after;
  std::vector<std::uint32_t> entries;
  restrip::OperationView view;  // of the above
  std::size_t new_vertices = 0;
};

namespace restrip::c {

using tables::PatchTriangle;
using Side = std::span<const restrip_patch_triangle>;

constexpr std::size_t most_entries = std::size_t{1} << 22;

/// Which ports a colouring joins inside a patch: the partner of each, itself without one. Not valid: a triangle has
/// more than two solid sides, or solid edges close a cycle.
struct Joined {
  bool valid = true;
  std::array<std::uint8_t, tables::most_patch_ports> partner{};
};
inline Joined joined(Side triangles, std::uint32_t colors, std::uint32_t ports) noexcept {
  constexpr std::uint8_t unknown = 255;
  std::array<std::uint8_t, tables::most_patch_triangles> root{};
  std::array<std::uint8_t, 32> triangle_of{};  // by inner edge: the first triangle at it
  triangle_of.fill(unknown);
  const auto find = [&root](std::uint8_t t) {
    while (root[t] != t) t = root[t];
    return t;
  };
  Joined out;
  std::array<std::uint8_t, tables::most_patch_ports> at{};  // by port: its triangle
  const auto triangle_count = static_cast<std::uint8_t>(triangles.size());
  for (std::uint8_t t = 0; t < triangle_count; ++t) {
    root[t] = t;
    int solid = 0;
    for (const std::uint8_t side : triangles[t].side) {
      if (side == PatchTriangle::boundary_side) continue;
      if (side >= PatchTriangle::port_side) {
        const auto port = static_cast<std::uint8_t>(side - PatchTriangle::port_side);
        at[port] = t;
        solid += static_cast<int>(ports >> port & 1U);
      } else if ((colors >> side & 1U) != 0) {
        ++solid;
        if (triangle_of[side] == unknown) {
          triangle_of[side] = t;
          continue;
        }
        const std::uint8_t other = find(triangle_of[side]);
        if (other == find(t)) out.valid = false;
        root[other] = find(t);
      }
    }
    if (solid > 2) out.valid = false;
  }
  if (!out.valid) return out;
  constexpr auto port_count = static_cast<std::uint8_t>(tables::most_patch_ports);
  for (std::uint8_t p = 0; p < port_count; ++p) out.partner[p] = p;
  for (std::uint8_t p = 0; p < port_count; ++p)
    for (std::uint8_t q = 0; q < p; ++q)
      if ((ports >> p & 1U) != 0 && (ports >> q & 1U) != 0 && find(at[p]) == find(at[q])) {
        out.partner[p] = q;
        out.partner[q] = p;
      }
  return out;
}

/// Where a port or an inner edge is: from vertex to vertex, once for each triangle at it.
using Ends = std::vector<std::array<std::uint8_t, 2>>;

/// Whether the triangles at a vertex are one fan, open or closed.
inline bool one_fan(Side triangles, std::uint8_t vertex) {
  constexpr std::uint8_t nothing = 255;
  std::array<std::uint8_t, nothing + 1> after{};  // by vertex: the next one around `vertex`, counter-clockwise
  std::array<std::uint8_t, nothing + 1> before{};
  after.fill(nothing);
  before.fill(nothing);
  std::size_t corners = 0;
  std::uint8_t first = nothing;
  for (const restrip_patch_triangle& t : triangles)
    for (unsigned s = 0; s < 3; ++s) {
      if (t.vertex[s] != vertex) continue;
      first = t.vertex[(s + 1) % 3];
      const std::uint8_t last = t.vertex[(s + 2) % 3];
      if (after[first] != nothing || before[last] != nothing) return false;
      after[first] = last;
      before[last] = first;
      ++corners;
    }
  for (std::size_t i = 0; i < corners && before[first] != nothing; ++i) first = before[first];
  std::size_t met = 0;
  for (std::uint8_t at = first; at != nothing && after[at] != nothing && (met == 0 || at != first); ++met)
    at = after[at];
  return met == corners;
}

/// What is wrong with the triangles of one side; empty if nothing is. Fills the ends of its ports.
inline std::string fault_of(const std::string& name, Side triangles, std::uint32_t edges, std::uint32_t ports,
                            std::uint32_t vertices, std::vector<Ends>& ends_of_ports) {
  if (triangles.empty() || triangles.size() > tables::most_patch_triangles)
    return name + ": " + std::to_string(triangles.size()) + " triangles; 1 to 16 are allowed";
  std::vector<Ends> inner(edges);
  ends_of_ports.assign(ports, {});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const restrip_patch_triangle& t = triangles[i];
    const std::string what = name + ": triangle " + std::to_string(i);
    for (unsigned s = 0; s < 3; ++s) {
      if (t.vertex[s] >= vertices)
        return what + " has vertex " + std::to_string(t.vertex[s]) + " of " + std::to_string(vertices);
      if (t.vertex[s] == t.vertex[(s + 1) % 3]) return what + " has vertex " + std::to_string(t.vertex[s]) + " twice";
      const std::uint8_t side = t.side[s];
      if (side == PatchTriangle::boundary_side) continue;
      const bool port = side >= PatchTriangle::port_side;
      const std::size_t number = port ? side - PatchTriangle::port_side : side;
      std::vector<Ends>& all = port ? ends_of_ports : inner;
      if (number >= all.size()) return what + " has a side that is neither an edge, nor a port, nor a boundary";
      all[number].push_back({t.vertex[s], t.vertex[(s + 1) % 3]});
    }
    if (i == 0) continue;
    if (t.from >= i || t.from_side > 2) return what + " is not met from one before it";
    const restrip_patch_triangle& from = triangles[t.from];
    if (from.vertex[t.from_side] != t.vertex[1] || from.vertex[(t.from_side + 1) % 3] != t.vertex[0] ||
        from.side[t.from_side] != t.side[0] || t.side[0] >= PatchTriangle::port_side)
      return what + " does not share its first side with the triangle that it is met from";
  }
  for (const Ends& ends : inner)
    if (ends.size() != 2 || ends[0][0] != ends[1][1] || ends[0][1] != ends[1][0])
      return name + ": an inner edge is not one side of two triangles each";
  for (const Ends& ends : ends_of_ports)
    if (ends.size() != 1) return name + ": a port is not a side of one triangle";
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (!one_fan(triangles, static_cast<std::uint8_t>(v)))
      return name + ": the triangles at vertex " + std::to_string(v) + " are not one fan";
  return {};
}

/// What is wrong with a table; empty if nothing is.
inline std::string fault_of(const restrip_operation& given) {
  const Side before(given.before, given.before_count);
  const Side after(given.after, given.after_count);
  if (given.matching != 0) return "it is a table for matchings; a mesh keeps strips";
  if (given.ports > tables::most_patch_ports || given.edges_before > 31 || given.edges_after > 31 ||
      given.vertices > 2 * NewVertices::most)
    return "it has more ports, edges or vertices than an operation can have";
  if (given.edges_before + given.ports > 22 || given.entry_count != std::size_t{1}
                                                                        << (given.edges_before + given.ports))
    return std::to_string(given.entry_count) + " entries; one is needed for each colouring";
  std::vector<Ends> ports;
  std::vector<Ends> ports_after;
  std::string fault = fault_of("before", before, given.edges_before, given.ports, given.vertices, ports);
  if (fault.empty()) fault = fault_of("after", after, given.edges_after, given.ports, given.vertices, ports_after);
  if (fault.empty() && ports != ports_after) fault = "a port has other vertices after the operation";
  if (!fault.empty()) return fault;
  const std::uint32_t port_count = (1U << given.ports) - 1;
  for (std::uint32_t at = 0; at < given.entry_count; ++at) {
    const std::uint32_t entry = given.entries[at];
    if (entry == RESTRIP_NONE) continue;
    const Joined then = joined(before, at >> given.ports, at & port_count);
    if (!then.valid) continue;  // no mesh has it
    const std::uint32_t kept = entry & port_count;
    const bool known = entry >> given.ports >> given.edges_after == 0 && (kept & ~at) == 0;
    const Joined now = known ? joined(after, entry >> given.ports, kept) : Joined{false, {}};
    bool sound = now.valid;
    for (std::uint8_t p = 0; sound && p < given.ports; ++p)
      sound = now.partner[p] == p || now.partner[p] == then.partner[p];
    if (!sound)
      return "entry " + std::to_string(at) + " is not a sound rule: in some mesh it closes a cycle or branches";
  }
  return {};
}

}  // namespace restrip::c
