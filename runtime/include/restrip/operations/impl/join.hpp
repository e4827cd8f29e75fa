// Finds, follows and joins strip ends. Included by join.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "restrip/operations/impl/operations.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

/// Whether h is one of the three halfedges of the triangle to the left of g.
template <class Mesh>
bool in_same_triangle(const Mesh& mesh, typename Mesh::Halfedge g, typename Mesh::Halfedge h) {
  const auto second = mesh.next(g);
  return g == h || second == h || mesh.next(second) == h;
}

/// A walk along a strip, in one direction.
template <class Mesh>
struct StripWalker {
  using Halfedge = typename Mesh::Halfedge;
  Halfedge at{};  ///< of the triangle reached, which was entered over this edge unless it is isolated
  bool ended = false;

  /// From the strip end to the left of h. An isolated triangle is its own other end.
  static StripWalker from_end(const Mesh& mesh, Halfedge h) {
    for (int side = 0; side < 3; ++side, h = mesh.next(h))
      if (mesh.solid(h)) return {mesh.opposite(h), false};
    return {h, true};
  }
  /// Steps to the next triangle.
  void step(const Mesh& mesh) {
    const auto step = strip_step(mesh, at);
    ended = !step.continues;
    if (step.continues) at = step.in;
  }
};

/// Calls a function for some triangles, each named by a halfedge.
template <class Mesh>
using Visit = FunctionRef<void(typename Mesh::Halfedge)>;
template <class Mesh>
using Each = FunctionRef<void(Visit<Mesh>)>;
template <class Mesh>
using EachCut = FunctionRef<void(FunctionRef<void(StripWalker<Mesh>)>)>;

/// Steps 1 and 2 of join.hpp: each_cut(follow) calls follow(walker) for each strip that has been cut, each_near(visit)
/// visits the triangles, and perhaps boundary halfedges, where strips may end.
template <class Mesh>
void join_ends(Mesh& mesh, ColoringChange& sum, EachCut<Mesh> each_cut, Each<Mesh> each_near) {
  using Halfedge = typename Mesh::Halfedge;
  constexpr std::size_t most = 16;
  // It is enough to find one of two ends that a cut has separated, so all strips are followed in parallel until at most
  // one continues. There are few of them; strips beyond the first `most` are followed one by one.
  std::array<StripWalker<Mesh>, most> walkers;
  std::size_t count = 0;
  each_cut([&](StripWalker<Mesh> walker) {
    if (count < most) {
      walkers[count++] = walker;
      return;
    }
    while (!walker.ended) walker.step(mesh);
    sum += join_end(mesh, walker.at);
  });
  std::array<Halfedge, most> found;
  std::size_t ended = 0;
  while (count > 1) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!walkers[i].ended) walkers[i].step(mesh);
      if (walkers[i].ended)
        found[ended++] = walkers[i].at;
      else
        walkers[left++] = walkers[i];
    }
    count = left;
  }
  for (std::size_t i = 0; i < ended; ++i) sum += join_end(mesh, found[i]);
  each_near([&](Halfedge h) {
    if (!mesh.on_boundary(h)) sum += join_end(mesh, h);
  });
}

/// The same without a list of cut strips: for the strips that end in the triangles that each(visit) names.
template <class Mesh>
void join_at_ends(Mesh& mesh, ColoringChange& sum, Each<Mesh> each) {
  using Halfedge = typename Mesh::Halfedge;
  const auto each_cut = [&](FunctionRef<void(StripWalker<Mesh>)> follow) {
    each([&](Halfedge h) {
      if (!mesh.on_boundary(h) && solid_degree(mesh, h) == 1) follow(StripWalker<Mesh>::from_end(mesh, h));
    });
  };
  join_ends<Mesh>(mesh, sum, each_cut, each);
}

/// Step 3 of join.hpp, for the triangles that each(visit) names.
template <class Mesh>
void absorb_and_join(Mesh& mesh, ColoringChange& sum, Each<Mesh> each) {
  using Halfedge = typename Mesh::Halfedge;
  each([&](Halfedge h) {
    std::array<Halfedge, default_absorptions + 2> ends;
    std::size_t count = 0;
    const ColoringChange absorbed = absorb_with<Mesh>(
        mesh, h, default_absorptions, [&](Halfedge g, bool solid) { mesh.set_solid(g, solid); },
        [&](Halfedge end) { ends[count++] = end; });
    if (absorbed.isolated == 0) return;
    sum += absorbed;
    join_at_ends<Mesh>(mesh, sum, [&](Visit<Mesh> visit) {
      for (std::size_t i = 0; i < count; ++i) visit(ends[i]);
    });
  });
}

/// Steps 1 to 3 for those triangles.
template <class Mesh>
ColoringChange join_and_absorb(Mesh& mesh, Each<Mesh> each) {
  ColoringChange sum;
  join_at_ends<Mesh>(mesh, sum, each);
  absorb_and_join<Mesh>(mesh, sum, each);
  return sum;
}

/// The same for the triangles to the left of some halfedges, each once; boundary halfedges are skipped.
template <class Mesh, class Halfedge>
ColoringChange join_in(Mesh& mesh, std::span<Halfedge> nearby) {
  std::size_t count = 0;
  for (const Halfedge h : nearby) {
    const auto met = nearby.first(count);
    if (mesh.on_boundary(h) ||
        std::any_of(met.begin(), met.end(), [&](Halfedge g) { return in_same_triangle(mesh, h, g); }))
      continue;
    nearby[count++] = h;
  }
  return join_and_absorb<Mesh>(mesh, [&](Visit<Mesh> visit) {
    for (const Halfedge h : nearby.first(count)) visit(h);
  });
}

/// Steps 1 to 3 in the triangles that a table's operation has made, of which `first` is the first side, and in their
/// neighbours, which may have lost a port.
template <class Mesh, class Table>
ColoringChange join_patch(Mesh& mesh, const Table& table, typename Mesh::Halfedge first) {
  const auto patch = read_sides(mesh, table.triangles_after, first);
  std::array<typename Mesh::Halfedge, 4 * std::tuple_size_v<decltype(patch.side)>> nearby;
  std::size_t count = 0;
  for (const auto& triangle : patch.sides()) nearby[count++] = triangle[0];
  for (std::size_t t = 0; t < patch.sides().size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (table.triangles_after[t].side[s] >= tables::PatchTriangle::port_side)
        nearby[count++] = mesh.opposite(patch.side[t][s]);
  return join_in(mesh, std::span(nearby).first(count));
}

// ---- Around an interior vertex bits name the strip ends, and the ports joined before but not now.

/// The triangles of a ring with chord that `elements` names, each by its halfedge that leaves the vertex of the fan,
/// for A and D by the chord.
template <class Mesh>
void visit_ring(const Mesh& mesh, const InteriorFan<typename Mesh::Halfedge>& fan, typename Mesh::Halfedge chord,
                Word elements, Visit<Mesh> visit) {
  for (; elements != 0; elements &= elements - 1) {
    const auto element = static_cast<std::size_t>(std::countr_zero(elements));
    const bool second = element > fan.a;  // D, and the triangles of the second arc
    const auto side = second ? mesh.opposite(chord) : chord;
    const std::size_t after = second ? element - (fan.a + 1) : element;
    if (after == 0)
      visit(side);
    else if (after == 1)
      visit(mesh.opposite(mesh.next(mesh.next(side))));
    else
      visit(fan.spokes[(second ? fan.a : 0) + after - 2]);
  }
}
/// The triangles of the fan that a collapse leaves; `left` is its spoke to v_l.
template <class Mesh>
void visit_fan(const Mesh& mesh, const InteriorFan<typename Mesh::Halfedge>& fan, typename Mesh::Halfedge left,
               Word triangles, Visit<Mesh> visit) {
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(triangles));
    if (i == 0)
      visit(left);
    else if (i == fan.a)
      visit(turn_ccw(mesh, i > 1 ? fan.spokes[i - 2] : left));
    else
      visit(fan.spokes[i - 1]);
  }
}

/// The ports of pairs that were joined inside a closed fan before but not now.
constexpr Word parted_ports(std::size_t k, Word ports, const InnerPairs& before, const InnerPairs& after) noexcept {
  Word parted = 0;
  if ((before.joined & before.over_chord) == 0) parted = before.over_chord & ~after.over_chord;
  if (count_bits(ports) == 2) return before.joined != 0 && after.joined == 0 ? ports : parted;
  for (Word rest = before.joined & ~after.joined; rest != 0; rest &= rest - 1) {
    const Word port = rest & -rest;
    const Word below = ports & (port - 1);
    parted |= port | std::bit_floor(below != 0 ? below : ports & low_bits(k));
  }
  return parted;
}

/// Steps 1 to 3 after an operation: visit(bits, each) calls each(h) for the triangles that these bits name.
template <class Mesh, class Halfedge>
Rewrite<Halfedge> join_in_fan(Mesh& mesh, const Rewrite<Halfedge>& done, Word ends, Word parted, Word all,
                              FunctionRef<void(Word, Visit<Mesh>)> visit) {
  ColoringChange sum;
  const auto each_cut = [&](FunctionRef<void(StripWalker<Mesh>)> follow) {
    visit(parted, [&](Halfedge h) { follow(StripWalker<Mesh>{mesh.opposite(mesh.next(h)), false}); });
  };
  if ((ends | parted) != 0) join_ends<Mesh>(mesh, sum, each_cut, [&](Visit<Mesh> each) { visit(ends, each); });
  if (done.isolated > 0) absorb_and_join<Mesh>(mesh, sum, [&](Visit<Mesh> each) { visit(all, each); });
  return with(done, sum);
}

// Elsewhere a turn around the vertices finds them.

template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_split_and_join(Mesh& mesh, const FanChange<typename Mesh::Halfedge>& change,
                                                       typename Mesh::Halfedge chord) {
  const auto done = finish_split(mesh, change, chord);
  if (!change.interior)
    return with(done, join_and_absorb<Mesh>(mesh, [&](Visit<Mesh> visit) {
                  for_each_around(mesh, chord, visit);
                  // A and D have been visited.
                  for_each_around(mesh, mesh.opposite(chord), [&](auto h) {
                    if (!(h == mesh.opposite(chord)) && (mesh.on_boundary(chord) || !(h == mesh.next(chord)))) visit(h);
                  });
                }));
  const auto& fan = change.fan;
  const Word colors = change.colors.word();
  const Word parted = parted_ports(fan.k, fan.ports, {closed_fan(fan.k).joined(change.before, fan.ports), 0},
                                   inner_pairs(ring_with_chord(fan.k, fan.a), colors, fan.ports));
  return join_in_fan<Mesh>(mesh, done, ends_ring(fan.k, fan.a, colors, fan.ports), ring_ports(fan.a, parted),
                           low_bits(fan.k + 2),
                           [&](Word elements, Visit<Mesh> each) { visit_ring(mesh, fan, chord, elements, each); });
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> finish_collapse_and_join(Mesh& mesh, const FanChange<typename Mesh::Halfedge>& change,
                                                          typename Mesh::Halfedge left) {
  const auto done = finish_collapse(mesh, change, left);
  if (!change.interior)
    return with(done, join_and_absorb<Mesh>(mesh, [&](Visit<Mesh> visit) { for_each_around(mesh, left, visit); }));
  const auto& fan = change.fan;
  const Word colors = change.colors.word();
  const Word parted =
      parted_ports(fan.k, fan.ports, inner_pairs(ring_with_chord(fan.k, fan.a), change.before, fan.ports),
                   {closed_fan(fan.k).joined(colors, fan.ports), 0});
  return join_in_fan<Mesh>(mesh, done, ends_closed(fan.k, colors, fan.ports), parted, low_bits(fan.k),
                           [&](Word triangles, Visit<Mesh> each) { visit_fan(mesh, fan, left, triangles, each); });
}

}  // namespace detail

template <ColoredMesh Mesh>
bool same_strip(const Mesh& mesh, typename Mesh::Halfedge g, typename Mesh::Halfedge h) {
  auto from_g = detail::StripWalker<Mesh>::from_end(mesh, g);
  auto from_h = detail::StripWalker<Mesh>::from_end(mesh, h);
  if (from_g.ended || from_h.ended) return detail::in_same_triangle(mesh, g, h);
  while (true) {
    from_g.step(mesh);
    if (from_g.ended) return detail::in_same_triangle(mesh, from_g.at, h);
    from_h.step(mesh);
    if (from_h.ended) return false;  // in one strip, the walk from g would have ended by now
  }
}

template <ColoredMesh Mesh>
ColoringChange join_end(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "join_end", describe(Refusal::no_such_edge));
  unsigned degree = detail::solid_degree(mesh, h);
  ColoringChange done;
  for (int side = 0; side < 3 && degree < 2; ++side, h = mesh.next(h)) {
    if (mesh.solid(h)) continue;
    const auto across = mesh.opposite(h);
    if (mesh.on_boundary(across)) continue;
    const unsigned there = detail::solid_degree(mesh, across);
    if (there > 1 || same_strip(mesh, h, across)) continue;
    mesh.set_solid(h, true);
    done += {-1, 0, -int{degree == 0} - int{there == 0}};
    ++degree;
  }
  return done;
}

template <ColoredMesh Mesh>
ColoringChange join_around(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "join_around", describe(Refusal::no_such_edge));
  return detail::join_and_absorb<Mesh>(mesh, [&](detail::Visit<Mesh> visit) { for_each_around(mesh, h, visit); });
}

template <ColoredMesh Mesh>
ColoringChange join_at_edge(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "join_at_edge", describe(Refusal::no_such_edge));
  std::array<typename Mesh::Halfedge, 6> nearby;
  std::size_t count = 0;
  for (const auto inner : {h, mesh.opposite(h)}) {
    if (mesh.on_boundary(inner)) continue;
    const auto second = mesh.next(inner);
    for (const auto g : {inner, mesh.opposite(second), mesh.opposite(mesh.next(second))}) nearby[count++] = g;
  }
  return detail::join_in(mesh, std::span(nearby).first(count));
}

template <NumberedMesh Mesh>
ColoringChange join_all(Mesh& mesh) {
  ColoringChange sum;
  const auto bound = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::uint32_t t = 0; t < bound; ++t)
    if (mesh.has_triangle(t)) sum += join_end(mesh, mesh.halfedge(t));
  return sum;
}

template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_and_join(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                                Name... name) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where, name...), "split_and_join");
  const auto change = detail::begin_split(detail::LocalRules{}, mesh, where);
  return detail::finish_split_and_join(mesh, change, detail::change_by_split(mesh, where, change, name...));
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_and_join(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "collapse_and_join");
  const auto change = detail::begin_collapse(detail::LocalRules{}, mesh, chord);
  return detail::finish_collapse_and_join(mesh, change, detail::change_by_collapse(mesh, chord, change));
}

template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip_and_join(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_flip(mesh, h), "flip_and_join");
  const auto done = flip(mesh, h);
  return detail::with(done, join_at_edge(mesh, done.halfedge));
}

}  // namespace restrip
