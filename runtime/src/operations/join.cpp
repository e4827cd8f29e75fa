// Joins of adjacent strip ends: steps 1 to 3 of join.hpp.
//
// Outline. Around an interior vertex of ordinary valence, bits of the fan name the triangles in which strips end and
// the ports that were joined before the operation but not now; elsewhere a turn around the vertices finds them. Strips
// that were cut are followed from there, all at once (join_ends). Two ends that meet are joined if a walk from both at
// once shows that they belong to different strips (same_strip).
//
// Invariant. No join closes a cycle, and each lowers the number of strips by one.
//
// Cost. Linear in the patch, and for each pair of ends that meet in the shorter of their strips.
#include "operations/join.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <tuple>

#include "operations/absorb.hpp"
#include "restrip/precondition.hpp"

namespace restrip::detail {

/// Whether h is one of the three halfedges of the triangle to the left of g.
bool in_same_triangle(const StripMesh& mesh, Halfedge g, Halfedge h) {
  const auto second = mesh.next(g);
  return g == h || second == h || mesh.next(second) == h;
}

/// A walk along a strip, in one direction.
struct StripWalker {
  Halfedge at{};  ///< of the triangle reached, which was entered over this edge unless it is isolated
  bool ended = false;

  /// From the strip end to the left of h. An isolated triangle is its own other end.
  static StripWalker from_end(const StripMesh& mesh, Halfedge h) {
    for (int side = 0; side < 3; ++side, h = mesh.next(h))
      if (mesh.solid(h)) return {mesh.opposite(h), false};
    return {h, true};
  }
  /// Steps to the next triangle.
  void step(const StripMesh& mesh) {
    const auto step = mesh.strip_step(at);
    ended = !step.continues;
    if (step.continues) at = step.in;
  }
};

/// Steps 1 and 2 of join.hpp: each_cut(follow) calls follow(walker) for each strip that has been cut, each_near(visit)
/// visits the triangles, and perhaps boundary halfedges, where strips may end.
template <class EachCut, class EachNear>
void join_ends(StripMesh& mesh, ColoringChange& sum, EachCut&& each_cut, EachNear&& each_near) {
  constexpr std::size_t most = 16;
  // It is enough to find one of two ends that a cut has separated, so all strips are followed in parallel until at most
  // one continues. There are few of them; strips beyond the first `most` are followed one by one.
  std::array<StripWalker, most> walkers;
  std::size_t count = 0;
  each_cut([&](StripWalker walker) {
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
template <class Each>
void join_at_ends(StripMesh& mesh, ColoringChange& sum, Each&& each) {
  const auto each_cut = [&](auto&& follow) {
    each([&](Halfedge h) {
      if (!mesh.on_boundary(h) && solid_degree(mesh, h) == 1) follow(StripWalker::from_end(mesh, h));
    });
  };
  join_ends(mesh, sum, each_cut, each);
}

/// Step 3 of join.hpp, for the triangles that each(visit) names.
template <class Each>
void absorb_and_join(StripMesh& mesh, ColoringChange& sum, Each&& each) {
  each([&](Halfedge h) {
    std::array<Halfedge, default_absorptions + 2> ends;
    std::size_t count = 0;
    const ColoringChange absorbed = absorb_with(
        mesh, h, default_absorptions, [&](Halfedge g, bool solid) { mesh.set_solid(g, solid); },
        [&](Halfedge end) { ends[count++] = end; });
    if (absorbed.isolated == 0) return;
    sum += absorbed;
    join_at_ends(mesh, sum, [&](auto&& visit) {
      for (std::size_t i = 0; i < count; ++i) visit(ends[i]);
    });
  });
}

/// Steps 1 to 3 for those triangles.
template <class Each>
ColoringChange join_and_absorb(StripMesh& mesh, Each&& each) {
  ColoringChange sum;
  join_at_ends(mesh, sum, each);
  absorb_and_join(mesh, sum, each);
  return sum;
}

ColoringChange join_in(StripMesh& mesh, std::span<Halfedge> nearby) {
  std::size_t count = 0;
  for (const Halfedge h : nearby) {
    const auto met = nearby.first(count);
    if (mesh.on_boundary(h) ||
        std::any_of(met.begin(), met.end(), [&](Halfedge g) { return in_same_triangle(mesh, h, g); }))
      continue;
    nearby[count++] = h;
  }
  return join_and_absorb(mesh, [&](auto&& visit) {
    for (const Halfedge h : nearby.first(count)) visit(h);
  });
}

ColoringChange join_patch(StripMesh& mesh, const OperationView& table, Halfedge first) {
  const PatchSides patch = read_sides(mesh, table.triangles_after, first);
  std::array<Halfedge, 4 * std::tuple_size_v<decltype(patch.side)>> nearby;
  std::size_t count = 0;
  for (const auto& triangle : patch.sides()) nearby[count++] = triangle[0];
  for (std::size_t t = 0; t < patch.sides().size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (table.triangles_after[t].side[s] >= tables::PatchTriangle::port_side)
        nearby[count++] = mesh.opposite(patch.side[t][s]);
  return join_in(mesh, std::span(nearby).first(count));
}

// ---- Around an interior vertex bits name the strip ends, and the ports joined before but not now.

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
template <class VisitBits>
Rewrite join_in_fan(StripMesh& mesh, const Rewrite& done, Word ends, Word parted, Word all, VisitBits&& visit) {
  ColoringChange sum;
  const auto each_cut = [&](auto&& follow) {
    visit(parted, [&](Halfedge h) { follow(StripWalker{mesh.opposite(mesh.next(h)), false}); });
  };
  if ((ends | parted) != 0) join_ends(mesh, sum, each_cut, [&](auto&& each) { visit(ends, each); });
  if (done.isolated > 0) absorb_and_join(mesh, sum, [&](auto&& each) { visit(all, each); });
  return with(done, sum);
}

// Elsewhere a turn around the vertices finds them.

Rewrite finish_split_and_join(StripMesh& mesh, const FanChange& change, Halfedge chord) {
  const auto done = finish_split(mesh, change, chord);
  if (!change.interior)
    return with(done, join_and_absorb(mesh, [&](auto&& visit) {
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
  return join_in_fan(mesh, done, ends_ring(fan.k, fan.a, colors, fan.ports), ring_ports(fan.a, parted),
                     low_bits(fan.k + 2),
                     [&](Word elements, auto&& each) { visit_ring(mesh, fan, chord, elements, each); });
}
Rewrite finish_collapse_and_join(StripMesh& mesh, const FanChange& change, Halfedge left) {
  const auto done = finish_collapse(mesh, change, left);
  if (!change.interior)
    return with(done, join_and_absorb(mesh, [&](auto&& visit) { for_each_around(mesh, left, visit); }));
  const auto& fan = change.fan;
  const Word colors = change.colors.word();
  const Word parted =
      parted_ports(fan.k, fan.ports, inner_pairs(ring_with_chord(fan.k, fan.a), change.before, fan.ports),
                   {closed_fan(fan.k).joined(colors, fan.ports), 0});
  return join_in_fan(mesh, done, ends_closed(fan.k, colors, fan.ports), parted, low_bits(fan.k),
                     [&](Word triangles, auto&& each) { visit_fan(mesh, fan, left, triangles, each); });
}

bool same_strip(const StripMesh& mesh, Halfedge g, Halfedge h) {
  auto from_g = StripWalker::from_end(mesh, g);
  auto from_h = StripWalker::from_end(mesh, h);
  if (from_g.ended || from_h.ended) return in_same_triangle(mesh, g, h);
  while (true) {
    from_g.step(mesh);
    if (from_g.ended) return in_same_triangle(mesh, from_g.at, h);
    from_h.step(mesh);
    if (from_h.ended) return false;  // in one strip, the walk from g would have ended by now
  }
}

ColoringChange join_end(StripMesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.alive(h), "join_end", describe(Refusal::no_such_edge));
  unsigned degree = solid_degree(mesh, h);
  ColoringChange done;
  for (int side = 0; side < 3 && degree < 2; ++side, h = mesh.next(h)) {
    if (mesh.solid(h)) continue;
    const auto across = mesh.opposite(h);
    if (mesh.on_boundary(across)) continue;
    const unsigned there = solid_degree(mesh, across);
    if (there > 1 || same_strip(mesh, h, across)) continue;
    mesh.set_solid(h, true);
    done += {-1, 0, -int{degree == 0} - int{there == 0}};
    ++degree;
  }
  return done;
}

ColoringChange join_at_edge(StripMesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.alive(h), "join_at_edge", describe(Refusal::no_such_edge));
  std::array<Halfedge, 6> nearby;
  std::size_t count = 0;
  for (const auto inner : {h, mesh.opposite(h)}) {
    if (mesh.on_boundary(inner)) continue;
    const auto second = mesh.next(inner);
    for (const auto g : {inner, mesh.opposite(second), mesh.opposite(mesh.next(second))}) nearby[count++] = g;
  }
  return join_in(mesh, std::span(nearby).first(count));
}

}  // namespace restrip::detail
