// Every operation in two halves, with the change of the mesh between them. The first reads the patch, looks the rule up
// and clears edges; the second sets edges. split(), collapse() and flip() do both, hooks.hpp offers them separately.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "restrip/operations/impl/patch_walk.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::detail {

// ---- rules. Fans of at most max_word_valence triangles are answered on words, longer ones on bit strings.

/// The colours of a rule and the changes that it makes.
struct Answer {
  FanBits colors;
  ColoringChange change;
};

/// For colours that no valid stripification has, all edges are dashed, as in Rule.
inline Answer answer_by_rule(SeenPatch& patch) {
  const Patch before = patch.before;
  const Patch after = patch.after;
  if (before.k <= max_word_valence) {
    const Word ports = patch.ports.word();
    const Rule rule = restrip::rule(before, after, patch.inner.word(), ports);
    const int isolated_now = isolated(after, rule.colors, ports);
    return {FanBits(rule.colors), {rule.strips, 0, isolated_now - isolated(before, patch.inner.word(), ports)}};
  }
  const BitSpan inner = patch.inner.span(before.colors());
  const BitSpan ports = patch.ports.span(before.k);
  Answer result;
  const BitSpan colors = result.colors.span(after.colors());
  if (const Walker walker{before, inner, ports}; walker.valid()) {
    FanBits joined;
    walker.joined(joined.span(before.k));
    exact::best(after, ports, joined.span(before.k), result.colors.span(after.colors()));
  }
  const int nodes = static_cast<int>(after.size()) - static_cast<int>(before.size());
  result.change.strips = nodes - (result.colors.count() - patch.inner.count());
  result.change.isolated = isolated(after, colors, ports) - isolated(before, inner, ports);
  return result;
}

template <class Halfedge>
using WalkPorts = FunctionRef<void(VisitEdge<Halfedge>)>;

/// The source of rules for the operations; a Keeper has another one. split() and collapse() are for interior fans of
/// ordinary valence, answer() for others: walk_ports(port) calls port(i, h) for every port.
struct LocalRules {
  template <class Mesh, class Halfedge>
  Rule split(const Mesh& /*mesh*/, Halfedge /*left*/, const InteriorFan<Halfedge>& fan) const noexcept {
    return split_rule({fan.k, fan.a}, fan.loop, fan.ports);
  }
  template <class Mesh, class Halfedge>
  Rule collapse(const Mesh& /*mesh*/, Halfedge /*chord*/, const InteriorFan<Halfedge>& fan, Word ring) const noexcept {
    return collapse_rule({fan.k, fan.a}, ring, fan.ports);
  }
  template <class Mesh>
  Answer answer(const Mesh& /*mesh*/, SeenPatch& patch, WalkPorts<typename Mesh::Halfedge> /*walk_ports*/) const {
    return answer_by_rule(patch);
  }
};

// ---- what is known between the halves

/// A split or a collapse that has begun.
template <class Halfedge>
struct FanChange {
  /// At an interior vertex of ordinary valence. Elsewhere only k of `fan` is known.
  bool interior = false;
  InteriorFan<Halfedge> fan;
  Word before = 0;      ///< interior: colours of the loop before a split, of the inner edges before a collapse
  FanBits colors;       ///< of the inner edges after a split, of the loop after a collapse
  Patch layout;         ///< elsewhere: of the fan
  std::size_t gap = 0;  ///< elsewhere: see SeenPatch
  ColoringChange counts;

  /// Takes the rule of an interior fan. The masks are of isolated triangles.
  void take(const Rule& rule, Word colors_before, Word isolated_after, Word isolated_before) {
    before = colors_before;
    colors = FanBits(rule.colors);
    counts = {rule.strips, 0, count_difference(isolated_after, isolated_before)};
  }
  /// Takes the rule of another patch, whose layout without the inserted triangles is `at`.
  void take(Answer&& rule, const Patch& at, std::size_t gap_of_spoke) {
    fan.k = at.k;
    colors = std::move(rule.colors);
    layout = at;
    gap = gap_of_spoke;
    counts = rule.change;
  }
  /// Interior: the spokes that go from one vertex to the other.
  [[nodiscard]] std::span<const Halfedge> moved() const { return {fan.spokes + fan.a - 1, fan.k - fan.a}; }
  [[nodiscard]] Rewrite<Halfedge> done(Halfedge at) const { return {counts, at, static_cast<std::uint32_t>(fan.k)}; }
};

/// Of a flip.
struct FlipChange {
  bool inner = false;
  ColoringChange counts;
};

// ---- split

/// The first half of a split, for any size and kind of fan.
template <class Rules, class Mesh>
FanChange<typename Mesh::Halfedge> begin_split(Rules&& rules, Mesh& mesh,
                                               const VertexSplit<typename Mesh::Halfedge>& where) {
  using Halfedge = typename Mesh::Halfedge;
  FanChange<Halfedge> change;
  InteriorFan<Halfedge>& interior = change.fan;
  change.interior =
      where.spokes == VertexSplit<Halfedge>::Spokes::both && read_interior_fan(mesh, where.left, where.right, interior);
  if (change.interior) {
    const auto [k, a] = std::pair{interior.k, interior.a};
    const Rule rule = rules.split(mesh, where.left, interior);
    change.take(rule, interior.loop, isolated_ring(k, a, rule.colors, interior.ports),
                isolated_closed(k, interior.loop, interior.ports));
    interior.write(mesh, interior.loop & ~kept_loop(k, a, rule.colors), false);
    return change;
  }
  SeenPatch fan = read_fan(mesh, where);
  change.take(rules.answer(std::as_const(mesh), fan,
                           [&](VisitEdge<Halfedge> port) { walk_ports(std::as_const(mesh), where, fan, port); }),
              fan.before, fan.gap);
  walk_fan(mesh, where.spoke(), fan.before, fan.gap, [&](std::size_t i, Halfedge h) {
    const std::size_t edge = fan.after.element(i);
    const bool is_cut = i + 1 == fan.before.k || fan.after.element(i + 1) != edge + 1;
    if (!is_cut && fan.inner.get(i) && !change.colors.get(edge)) mesh.set_solid(h, false);
  });
  return change;
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_split(Mesh& mesh, const FanChange<typename Mesh::Halfedge>& change,
                                              typename Mesh::Halfedge chord) {
  if (!change.interior) {
    walk_patch(
        mesh, chord,
        [&](std::size_t j, auto h) {
          if (change.colors.get(j) != mesh.solid(h)) mesh.set_solid(h, change.colors.get(j));
        },
        [](std::size_t, auto) {});
    return change.done(chord);
  }
  const auto& fan = change.fan;
  const Word inner = change.colors.word();
  fan.write(mesh, kept_loop(fan.k, fan.a, inner) & ~fan.loop, true);
  const auto back = mesh.opposite(chord);
  const auto above_left = mesh.next(chord);
  const auto below_right = mesh.next(back);
  mesh.set_solid(above_left, has(inner, fan.k + 1));
  mesh.set_solid(mesh.next(above_left), has(inner, 0));
  mesh.set_solid(below_right, has(inner, fan.a));
  mesh.set_solid(mesh.next(below_right), has(inner, fan.a + 1));
  mesh.set_solid(chord, has(inner, fan.k + 2));
  return change.done(chord);
}

// ---- collapse

template <class Mesh>
SeenPatch read_patch(const Mesh& mesh, typename Mesh::Halfedge chord) {
  SeenPatch patch;
  std::tie(patch.before, patch.gap) = walk_patch(
      mesh, chord, [&](std::size_t j, auto h) { patch.inner.put(j, mesh.solid(h)); },
      [&](std::size_t i, auto h) { patch.ports.put(i, mesh.solid(h)); });
  patch.after = patch.before.ring ? closed_fan(patch.before.k) : open_fan(patch.before.k);
  return patch;
}

/// The first half of a collapse, for any size and kind of patch.
template <class Rules, class Mesh>
FanChange<typename Mesh::Halfedge> begin_collapse(Rules&& rules, Mesh& mesh, typename Mesh::Halfedge chord) {
  using Halfedge = typename Mesh::Halfedge;
  FanChange<Halfedge> change;
  InteriorFan<Halfedge>& interior = change.fan;
  Word ring = 0;
  change.interior = read_ring(mesh, chord, interior, ring);
  if (change.interior) {
    const auto [k, a] = std::pair{interior.k, interior.a};
    const Rule rule = rules.collapse(mesh, chord, interior, ring);
    change.take(rule, ring, isolated_closed(k, rule.colors, interior.ports), isolated_ring(k, a, ring, interior.ports));
    interior.write(mesh, interior.loop & ~rule.colors, false);
    return change;
  }
  SeenPatch patch = read_patch(mesh, chord);
  const Patch& before = patch.before;
  change.take(rules.answer(std::as_const(mesh), patch,
                           [&](VisitEdge<Halfedge> port) {
                             walk_patch(
                                 std::as_const(mesh), chord, [](std::size_t, Halfedge) {}, port);
                           }),
              patch.after, patch.gap);
  walk_patch(
      mesh, chord,
      [&](std::size_t j, Halfedge h) {
        const bool stays = j + 1 < before.size() && before.is_fan(j) && before.is_fan(j + 1);
        if (stays && patch.inner.get(j) && !change.colors.get(before.port(j))) mesh.set_solid(h, false);
      },
      [](std::size_t, Halfedge) {});
  return change;
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_collapse(Mesh& mesh, const FanChange<typename Mesh::Halfedge>& change,
                                                 typename Mesh::Halfedge left) {
  if (!change.interior) {
    walk_fan(mesh, left, change.layout, change.gap, [&](std::size_t i, auto h) {
      if (change.colors.get(i) != mesh.solid(h)) mesh.set_solid(h, change.colors.get(i));
    });
    return change.done(left);
  }
  const auto& fan = change.fan;
  const Word colors = change.colors.word();
  fan.write(mesh, colors & ~fan.loop, true);
  mesh.set_solid(left, has(colors, fan.k - 1));
  mesh.set_solid(turn_ccw(mesh, fan.a > 1 ? fan.spokes[fan.a - 2] : left), has(colors, fan.a - 1));
  return change.done(left);
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
  return {rule.inner, {rule.strips, 0, isolated}};
}

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_flip(Mesh& mesh, const FlipChange& change, typename Mesh::Halfedge h) {
  if (change.inner) mesh.set_solid(h, true);
  return {change.counts, h, 4};
}

}  // namespace restrip::detail
