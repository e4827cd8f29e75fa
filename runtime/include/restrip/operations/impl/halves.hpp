// Every operation in two halves, with the change of the mesh between them. The first reads the patch, looks the rule up
// and clears edges; the second sets edges. split(), collapse() and flip() do both, hooks.hpp offers them separately.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "restrip/operations/impl/answer.hpp"
#include "restrip/operations/impl/interior_fan.hpp"
#include "restrip/operations/impl/patch_walk.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::detail {

/// The source of rules for the operations; linked.hpp has another one. split() and collapse() are for interior fans of
/// ordinary valence, answer_split() and answer_collapse() for others.
struct LocalRules {
  template <class Mesh, class Halfedge>
  Rule split(const Mesh& /*mesh*/, Halfedge /*left*/, const InteriorFan<Halfedge>& fan) const noexcept {
    return split_rule({fan.k, fan.a}, fan.loop, fan.ports);
  }
  template <class Mesh, class Halfedge>
  Rule collapse(const Mesh& /*mesh*/, Halfedge /*chord*/, const InteriorFan<Halfedge>& fan, Word ring) const noexcept {
    return collapse_rule({fan.k, fan.a}, ring, fan.ports);
  }
  template <class Mesh, class Halfedge, class Bits>
  Answer<Bits> answer_split(const Mesh& /*mesh*/, const VertexSplit<Halfedge>& where, Fan<Bits>& fan) const {
    return detail::answer_split(fan, where.spokes == VertexSplit<Halfedge>::Spokes::both);
  }
  template <class Mesh, class Halfedge, class Bits>
  Answer<Bits> answer_collapse(const Mesh& /*mesh*/, Halfedge /*chord*/, const PatchPlace& at, Bits& inner,
                               Bits& ports) const {
    return detail::answer_collapse(at, inner, ports);
  }
};

/// Between the halves, at an interior vertex of ordinary valence.
template <class Halfedge>
struct InteriorChange {
  InteriorFan<Halfedge> fan;
  Word before = 0;  ///< colours of the loop before a split, of the inner edges before a collapse
  Word colors = 0;  ///< of the inner edges after a split, of the loop after a collapse
  int strips = 0;
  int isolated = 0;

  /// The spokes that go from one vertex to the other.
  [[nodiscard]] std::span<const Halfedge> moved() const { return {fan.spokes + fan.a - 1, fan.k - fan.a}; }
};

/// Between the halves, anywhere else.
template <class Bits>
struct PatchChange {
  Answer<Bits> rule;
  PatchPlace at;  ///< of a split k alone
};

/// Between the halves of a flip.
struct FlipChange {
  bool inner = false;
  int strips = 0;
  int isolated = 0;
};

// ---- split

template <class Bits>
Layout layout_after_split(const Fan<Bits>& fan, bool both) noexcept {
  const std::size_t low = fan.left < fan.right ? fan.left : fan.right;
  const std::size_t high = fan.left < fan.right ? fan.right : fan.left;
  if (fan.closed) return ring_with_chord(fan.k, fan.right);
  return both ? path_with_chord(fan.k, low, high) : path(fan.k, low);
}

template <class Rules, class Mesh, class Bits>
PatchChange<Bits> begin_split(Rules&& rules, Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                              Fan<Bits>& fan) {
  using Spokes = typename VertexSplit<typename Mesh::Halfedge>::Spokes;
  const bool both = where.spokes == Spokes::both;
  PatchChange<Bits> change{rules.answer_split(std::as_const(mesh), where, fan), {}};
  change.at.k = fan.k;
  const Layout after = layout_after_split(fan, both);
  walk_fan(mesh, where.spokes == Spokes::right_only ? where.right : where.left, fan.closed, fan.k, fan.left,
           [&](std::size_t i, auto h) {
             const std::size_t edge = after.element(i);
             const bool is_cut = i + 1 == fan.k || after.element(i + 1) != edge + 1;
             if (!is_cut && fan.loop.get(i) && !change.rule.colors.get(edge)) mesh.set_solid(h, false);
           });
  return change;
}

/// The first half of a split, for any size and kind of fan; then do_rest(change).
template <class Rules, class Mesh, class Rest>
auto with_split_begun(Rules&& rules, Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where, Rest&& do_rest) {
  using Halfedge = typename Mesh::Halfedge;
  InteriorChange<Halfedge> change;
  InteriorFan<Halfedge>& interior = change.fan;
  if (where.spokes == VertexSplit<Halfedge>::Spokes::both &&
      read_interior_fan(mesh, where.left, where.right, interior)) {
    const auto [k, a] = std::pair{interior.k, interior.a};
    const Rule rule = rules.split(mesh, where.left, interior);
    change.before = interior.loop;
    change.colors = rule.colors;
    change.strips = rule.strips;
    change.isolated = count_difference(isolated_ring(k, a, rule.colors, interior.ports),
                                       isolated_closed(k, interior.loop, interior.ports));
    interior.clear(mesh, kept_loop(k, a, rule.colors));
    return do_rest(change);
  }
  if (auto fan = read_fan<WordBits>(mesh, where); fan.k <= max_word_valence) {
    auto general = begin_split(rules, mesh, where, fan);
    return do_rest(general);
  }
  auto fan = read_fan<LongBits>(mesh, where);
  auto general = begin_split(rules, mesh, where, fan);
  return do_rest(general);
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_split(Mesh& mesh, const InteriorChange<typename Mesh::Halfedge>& change,
                                              typename Mesh::Halfedge chord) {
  light_ring(mesh, change.fan, chord, change.colors);
  return {chord, static_cast<std::uint32_t>(change.fan.k), change.strips, change.isolated};
}

template <class Mesh, class Bits>
Rewrite<typename Mesh::Halfedge> finish_split(Mesh& mesh, const PatchChange<Bits>& change,
                                              typename Mesh::Halfedge chord) {
  const Answer<Bits>& rule = change.rule;
  walk_patch(
      mesh, chord,
      [&](std::size_t j, auto h) {
        if (rule.colors.get(j) != mesh.solid(h)) mesh.set_solid(h, rule.colors.get(j));
      },
      [](std::size_t, auto) {});
  return {chord, static_cast<std::uint32_t>(change.at.k), rule.strips, rule.isolated};
}

// ---- collapse

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

template <class Rules, class Mesh, class Bits>
PatchChange<Bits> begin_collapse(Rules&& rules, Mesh& mesh, typename Mesh::Halfedge chord, const PatchPlace& at,
                                 Bits& inner, Bits& ports) {
  PatchChange<Bits> change{rules.answer_collapse(std::as_const(mesh), chord, at, inner, ports), at};
  const Layout before = layout_before_collapse(at);
  walk_patch(
      mesh, chord,
      [&](std::size_t j, auto h) {
        const bool stays = j + 1 < before.size() && before.is_fan(j) && before.is_fan(j + 1);
        if (stays && inner.get(j) && !change.rule.colors.get(before.port(j))) mesh.set_solid(h, false);
      },
      [](std::size_t, auto) {});
  return change;
}

/// The first half of a collapse, for any size and kind of patch; then do_rest(change).
template <class Rules, class Mesh, class Rest>
auto with_collapse_begun(Rules&& rules, Mesh& mesh, typename Mesh::Halfedge chord, Rest&& do_rest) {
  InteriorChange<typename Mesh::Halfedge> change;
  InteriorFan<typename Mesh::Halfedge>& interior = change.fan;
  if (Word ring = 0; read_ring(mesh, chord, interior, ring)) {
    const auto [k, a] = std::pair{interior.k, interior.a};
    const Rule rule = rules.collapse(mesh, chord, interior, ring);
    change.before = ring;
    change.colors = rule.colors;
    change.strips = rule.strips;
    change.isolated =
        count_difference(isolated_closed(k, rule.colors, interior.ports), isolated_ring(k, a, ring, interior.ports));
    interior.clear(mesh, rule.colors);
    return do_rest(change);
  }
  WordBits inner;
  WordBits ports;
  const auto at = read_patch(mesh, chord, inner, ports);
  if (at.k <= max_word_valence) {
    auto general = begin_collapse(rules, mesh, chord, at, inner, ports);
    return do_rest(general);
  }
  LongBits long_inner;
  LongBits long_ports;
  read_patch(mesh, chord, long_inner, long_ports);
  auto general = begin_collapse(rules, mesh, chord, at, long_inner, long_ports);
  return do_rest(general);
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_collapse(Mesh& mesh, const InteriorChange<typename Mesh::Halfedge>& change,
                                                 typename Mesh::Halfedge left) {
  light_fan(mesh, change.fan, left, change.colors);
  return {left, static_cast<std::uint32_t>(change.fan.k), change.strips, change.isolated};
}

template <class Mesh, class Bits>
Rewrite<typename Mesh::Halfedge> finish_collapse(Mesh& mesh, const PatchChange<Bits>& change,
                                                 typename Mesh::Halfedge spoke) {
  const auto& [rule, at] = change;
  walk_fan(mesh, spoke, at.kind == PatchPlace::Kind::ring, at.k, at.left, [&, &rule = rule](std::size_t i, auto h) {
    if (rule.colors.get(i) != mesh.solid(h)) mesh.set_solid(h, rule.colors.get(i));
  });
  return {spoke, static_cast<std::uint32_t>(at.k), rule.strips, rule.isolated};
}

// ---- flip

/// Isolated triangles outside the ports that a flip clears: the triangles left without a solid edge when the dual edges
/// of `given_up` (halfedges of triangles outside the patch) are cleared.
template <class Mesh>
int isolated_outside(const Mesh& mesh, std::span<const typename Mesh::Halfedge> given_up) {
  int isolated = 0;
  for (std::size_t i = 0; i < given_up.size(); ++i) {
    bool counts = true;
    for (auto side = mesh.next(given_up[i]); !(side == given_up[i]); side = mesh.next(side)) {
      std::size_t found = 0;
      while (found < given_up.size() && !(given_up[found] == side)) ++found;
      if (found < given_up.size() ? found < i : bool{mesh.solid(side)}) counts = false;
    }
    isolated += counts ? 1 : 0;  // a triangle outside two of them counts once
  }
  return isolated;
}

/// The change in the number of isolated triangles among the two triangles of a flip.
constexpr int isolated_by_flip(bool inner, unsigned ports, const FlipRule& rule) noexcept {
  const auto isolated_one = [](bool edge, unsigned p, unsigned one, unsigned other) {
    return edge || (p >> one & 1U) != 0 || (p >> other & 1U) != 0 ? 0 : 1;
  };
  // The new triangles own ports 1, 2 and 3, 0.
  return isolated_one(rule.inner, rule.ports, 1, 2) + isolated_one(rule.inner, rule.ports, 3, 0) -
         isolated_one(inner, ports, 0, 1) - isolated_one(inner, ports, 2, 3);
}

template <class Mesh>
FlipChange begin_flip(Mesh& mesh, typename Mesh::Halfedge h) {
  using Halfedge = typename Mesh::Halfedge;
  const Halfedge g = mesh.opposite(h);
  const Halfedge first = mesh.next(h);
  const Halfedge third = mesh.next(g);
  const Halfedge port[4] = {first, mesh.next(first), third, mesh.next(third)};
  unsigned ports = 0;
  for (unsigned i = 0; i < 4; ++i) ports |= static_cast<unsigned>(mesh.solid(port[i])) << i;
  const bool inner = mesh.solid(h);
  const FlipRule rule = flip_rule(inner, ports);
  int isolated = isolated_by_flip(inner, ports, rule);
  if (const unsigned given_up = ports & ~rule.ports; given_up != 0) {
    Halfedge outer[4];
    std::size_t n = 0;
    for (unsigned i = 0; i < 4; ++i)
      if ((given_up >> i & 1U) != 0) outer[n++] = mesh.opposite(port[i]);
    isolated += detail::isolated_outside(mesh, std::span<const Halfedge>(outer, n));
    for (std::size_t i = 0; i < n; ++i) mesh.set_solid(outer[i], false);
  }
  if (inner && !rule.inner) mesh.set_solid(h, false);
  return {rule.inner, rule.strips, isolated};
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_flip(Mesh& mesh, const FlipChange& change, typename Mesh::Halfedge h) {
  if (change.inner) mesh.set_solid(h, true);
  return {h, 4, change.strips, change.isolated};
}

}  // namespace restrip::detail
