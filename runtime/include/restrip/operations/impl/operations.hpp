// Split, collapse and flip: read the patch, ask the rule, change the mesh, write the colours. Included by
// operations.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "restrip/operations/impl/answer.hpp"
#include "restrip/operations/impl/interior_fan.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/impl/patch_walk.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/precondition.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip {
namespace detail {

template <class Bits>
Layout layout_after_split(const Fan<Bits>& fan, bool both) noexcept {
  const auto [low, high] = std::minmax({fan.left, fan.right});
  if (fan.closed) return ring_with_chord(fan.k, fan.right);
  return both ? path_with_chord(fan.k, low, high) : path(fan.k, low);
}

/// `name`: the new vertex, for meshes that let the caller name it; else nothing.
template <class Mesh, class Bits, class... Name>
Rewrite<typename Mesh::Halfedge> apply_split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                             Fan<Bits>& fan, bool both, Name... name) {
  const auto rule = answer_split(fan, both);
  const Layout after = layout_after_split(fan, both);
  const bool from_right = where.spokes == VertexSplit<typename Mesh::Halfedge>::Spokes::right_only;
  walk_fan(mesh, from_right ? where.right : where.left, fan.closed, fan.k, fan.left, [&](std::size_t i, auto h) {
    const std::size_t edge = after.element(i);
    const bool is_cut = i + 1 == fan.k || after.element(i + 1) != edge + 1;
    if (!is_cut && fan.loop.get(i) && !rule.colors.get(edge)) mesh.set_solid(h, false);
  });
  const auto chord = mesh.insert_vertex(where, name...);
  walk_patch(
      mesh, chord,
      [&](std::size_t j, auto h) {
        if (rule.colors.get(j) != mesh.solid(h)) mesh.set_solid(h, rule.colors.get(j));
      },
      [](std::size_t, auto) {});
  return {chord, static_cast<std::uint32_t>(fan.k), rule.strips, rule.isolated};
}

/// Where the operations on interior fans get their rules from; linked.hpp has another source.
struct LocalRules {
  template <class Mesh, class Halfedge>
  Rule split(const Mesh& /*mesh*/, Halfedge /*left*/, const InteriorFan<Halfedge>& fan) const noexcept {
    return split_rule({fan.k, fan.a}, fan.loop, fan.ports);
  }
  template <class Mesh, class Halfedge>
  Rule collapse(const Mesh& /*mesh*/, Halfedge /*chord*/, const InteriorFan<Halfedge>& fan, Word ring) const noexcept {
    return collapse_rule({fan.k, fan.a}, ring, fan.ports);
  }
};

template <class Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> apply_split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                             const InteriorFan<typename Mesh::Halfedge>& fan, const Rule& rule,
                                             Name... name) {
  const std::size_t k = fan.k;
  const std::size_t a = fan.a;
  const int isolated =
      count_difference(isolated_ring(k, a, rule.colors, fan.ports), isolated_closed(k, fan.loop, fan.ports));
  fan.dash(mesh, kept_loop(k, a, rule.colors));
  const auto chord = [&] {
    // A mesh that can use the walk we have done already need not turn around the vertex again.
    const std::span<const typename Mesh::Halfedge> moved(fan.spokes + a - 1, k - a);
    if constexpr (requires { mesh.insert_vertex(where.left, where.right, moved, name...); })
      return mesh.insert_vertex(where.left, where.right, moved, name...);
    else
      return mesh.insert_vertex(where, name...);
  }();
  light_ring(mesh, fan, chord, rule.colors);
  return {chord, static_cast<std::uint32_t>(k), rule.strips, isolated};
}

template <class Rules, class Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_with(const Rules& rules, Mesh& mesh,
                                            const VertexSplit<typename Mesh::Halfedge>& where, Name... name) {
  const bool both = where.spokes == VertexSplit<typename Mesh::Halfedge>::Spokes::both;
  InteriorFan<typename Mesh::Halfedge> interior;
  if (both && read_interior_fan(mesh, where.left, where.right, interior))
    return apply_split(mesh, where, interior, rules.split(mesh, where.left, interior), name...);
  auto fan = read_fan<WordBits>(mesh, where);
  if (fan.k <= max_word_valence) return apply_split(mesh, where, fan, both, name...);
  auto long_fan = read_fan<LongBits>(mesh, where);
  return apply_split(mesh, where, long_fan, both, name...);
}

template <class Bits, class Mesh>
PatchPlace read_patch(const Mesh& mesh, typename Mesh::Halfedge chord, Bits& inner, Bits& ports) {
  return walk_patch(
      mesh, chord, [&](std::size_t j, auto h) { inner.put(j, mesh.solid(h)); },
      [&](std::size_t i, auto h) { ports.put(i, mesh.solid(h)); });
}

inline Layout layout_before_collapse(const PatchPlace& at) noexcept {
  switch (at.kind) {
    case PatchPlace::Kind::ring:
      return ring_with_chord(at.k, at.a);
    case PatchPlace::Kind::path_with_chord:
      return path_with_chord(at.k, at.i, at.j);
    case PatchPlace::Kind::path:
      break;
  }
  return path(at.k, at.i);
}

template <class Mesh, class Bits>
Rewrite<typename Mesh::Halfedge> apply_collapse(Mesh& mesh, typename Mesh::Halfedge chord, const PatchPlace& at,
                                                Bits& inner, Bits& ports) {
  const auto rule = answer_collapse(at, inner, ports);
  const Layout before = layout_before_collapse(at);
  walk_patch(
      mesh, chord,
      [&](std::size_t j, auto h) {
        const bool stays = j + 1 < before.size() && before.is_fan(j) && before.is_fan(j + 1);
        if (stays && inner.get(j) && !rule.colors.get(before.port(j))) mesh.set_solid(h, false);
      },
      [](std::size_t, auto) {});
  const auto spoke = mesh.remove_vertex(chord);
  walk_fan(mesh, spoke, at.kind == PatchPlace::Kind::ring, at.k, at.left, [&](std::size_t i, auto h) {
    if (rule.colors.get(i) != mesh.solid(h)) mesh.set_solid(h, rule.colors.get(i));
  });
  return {spoke, static_cast<std::uint32_t>(at.k), rule.strips, rule.isolated};
}

template <class Rules, class Mesh>
Rewrite<typename Mesh::Halfedge> collapse_with(const Rules& rules, Mesh& mesh, typename Mesh::Halfedge chord) {
  InteriorFan<typename Mesh::Halfedge> interior;
  if (Word ring = 0; read_ring(mesh, chord, interior, ring)) {
    const std::size_t k = interior.k;
    const std::size_t a = interior.a;
    const Rule rule = rules.collapse(mesh, chord, interior, ring);
    const int isolated =
        count_difference(isolated_closed(k, rule.colors, interior.ports), isolated_ring(k, a, ring, interior.ports));
    interior.dash(mesh, rule.colors);
    const auto left = [&] {
      const std::span<const typename Mesh::Halfedge> moved(interior.spokes + a - 1, k - a);
      if constexpr (requires { mesh.remove_vertex(chord, moved); })
        return mesh.remove_vertex(chord, moved);
      else
        return mesh.remove_vertex(chord);
    }();
    light_fan(mesh, interior, left, rule.colors);
    return {left, static_cast<std::uint32_t>(k), rule.strips, isolated};
  }
  WordBits inner;
  WordBits ports;
  const auto at = read_patch(mesh, chord, inner, ports);
  if (at.k <= max_word_valence) return apply_collapse(mesh, chord, at, inner, ports);
  LongBits long_inner;
  LongBits long_ports;
  read_patch(mesh, chord, long_inner, long_ports);
  return apply_collapse(mesh, chord, at, long_inner, long_ports);
}

/// Isolated triangles behind the ports that a flip gives up: those left without a solid edge when the dual edges of
/// `given_up` (halfedges of triangles outside the patch) are dashed.
template <class Mesh>
int isolated_behind(const Mesh& mesh, std::span<const typename Mesh::Halfedge> given_up) {
  int isolated = 0;
  for (std::size_t i = 0; i < given_up.size(); ++i) {
    bool counts = true;
    for (auto side = mesh.next(given_up[i]); !(side == given_up[i]); side = mesh.next(side)) {
      const auto found = std::find(given_up.begin(), given_up.end(), side) - given_up.begin();
      const bool goes_too = static_cast<std::size_t>(found) < given_up.size();
      if (goes_too ? static_cast<std::size_t>(found) < i : bool{mesh.solid(side)}) counts = false;
    }
    isolated += counts ? 1 : 0;  // a triangle behind two of them once, for the first
  }
  return isolated;
}

}  // namespace detail

template <SplittableMesh Mesh>
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where) {
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where) == Refusal::granted, "split",
                 describe(detail::refusal_of_split(mesh, where)));
  return detail::split_with(detail::LocalRules{}, mesh, where);
}

template <SplittableMesh Mesh, class Vertex>
requires requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where, Vertex v) { mesh.insert_vertex(where, v); }
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                       Vertex new_vertex) {
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where, new_vertex) == Refusal::granted, "split",
                 describe(detail::refusal_of_split(mesh, where, new_vertex)));
  return detail::split_with(detail::LocalRules{}, mesh, where, new_vertex);
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(detail::refusal_of_collapse(mesh, chord) == Refusal::granted, "collapse",
                 describe(detail::refusal_of_collapse(mesh, chord)));
  return detail::collapse_with(detail::LocalRules{}, mesh, chord);
}

template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::refusal_of_flip(mesh, h) == Refusal::granted, "flip",
                 describe(detail::refusal_of_flip(mesh, h)));
  using Halfedge = typename Mesh::Halfedge;
  const Halfedge g = mesh.opposite(h);
  const Halfedge first = mesh.next(h);
  const Halfedge third = mesh.next(g);
  const Halfedge port[4] = {first, mesh.next(first), third, mesh.next(third)};
  unsigned ports = 0;
  for (unsigned i = 0; i < 4; ++i) ports |= static_cast<unsigned>(mesh.solid(port[i])) << i;
  const bool inner = mesh.solid(h);
  const FlipRule rule = flip_rule(inner, ports);
  const auto isolated_one = [](bool edge, unsigned p, unsigned one, unsigned other) {
    return edge || (p >> one & 1U) != 0 || (p >> other & 1U) != 0 ? 0 : 1;
  };
  // The new triangles own ports 1, 2 and 3, 0.
  int isolated = isolated_one(rule.inner, rule.ports, 1, 2) + isolated_one(rule.inner, rule.ports, 3, 0) -
                 isolated_one(inner, ports, 0, 1) - isolated_one(inner, ports, 2, 3);
  if (const unsigned given_up = ports & ~rule.ports; given_up != 0) {
    Halfedge outer[4];
    std::size_t n = 0;
    for (unsigned i = 0; i < 4; ++i)
      if ((given_up >> i & 1U) != 0) outer[n++] = mesh.opposite(port[i]);
    isolated += detail::isolated_behind(mesh, std::span<const Halfedge>(outer, n));
    for (std::size_t i = 0; i < n; ++i) mesh.set_solid(outer[i], false);
  }
  if (inner && !rule.inner) mesh.set_solid(h, false);
  h = mesh.turn_edge(h);
  if (rule.inner) mesh.set_solid(h, true);
  return {h, 4, rule.strips, isolated};
}

}  // namespace restrip
