// Split, collapse and flip by the rules.
//
// Outline. (1) A turn around the vertices reads the colours of the patch, numbered as in docs/reference/notation.md.
// (2) The rule is looked up: closed fans up to k = 8 in the tables; others by the automaton, on words up to
// max_word_valence triangles and on bit strings beyond. (3) Edges are cleared, (4) the mesh changes, (5) edges are set.
// Interior fans of ordinary valence, nearly all, have code of their own (InteriorFan): one turn reads everything and
// remembers the spokes, and only dual edges whose colour changes are written.
//
// Invariant. At every moment the colouring is valid: the old one or the new one, perhaps with fewer solid edges.
//
// Cost. Linear in the valence; the look-up is constant up to k = 8 and linear beyond.
#include "restrip/operations/operations.hpp"

#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "operations/halves.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

Answer answer_by_rule(SeenPatch& patch) {
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

// ---- split

FanChange begin_split(RuleSource& rules, StripMesh& mesh, const VertexSplit& where) {
  FanChange change;
  InteriorFan& interior = change.fan;
  change.interior =
      where.spokes == VertexSplit::Spokes::both && read_interior_fan(mesh, where.left, where.right, interior);
  if (change.interior) {
    const auto [k, a] = std::pair{interior.k, interior.a};
    const Rule rule = rules.split(mesh, where.left, interior);
    change.take(rule, interior.loop, isolated_ring(k, a, rule.colors, interior.ports),
                isolated_closed(k, interior.loop, interior.ports));
    interior.write(mesh, interior.loop & ~kept_loop(k, a, rule.colors), false);
    return change;
  }
  SeenPatch fan = read_fan(mesh, where);
  change.take(rules.answer_split(mesh, where, fan), fan.before, fan.gap);
  walk_fan(mesh, where.spoke(), fan.before, fan.gap, [&](std::size_t i, Halfedge h) {
    const std::size_t edge = fan.after.element(i);
    const bool is_cut = i + 1 == fan.before.k || fan.after.element(i + 1) != edge + 1;
    if (!is_cut && fan.inner.get(i) && !change.colors.get(edge)) mesh.set_solid(h, false);
  });
  return change;
}

Halfedge change_by_split(StripMesh& mesh, const VertexSplit& where, const FanChange& change, Vertex new_vertex) {
  return mesh.insert_vertex(where, new_vertex, change.moved());
}

Rewrite finish_split(StripMesh& mesh, const FanChange& change, Halfedge chord) {
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

static SeenPatch read_patch(const StripMesh& mesh, Halfedge chord) {
  SeenPatch patch;
  std::tie(patch.before, patch.gap) = walk_patch(
      mesh, chord, [&](std::size_t j, auto h) { patch.inner.put(j, mesh.solid(h)); },
      [&](std::size_t i, auto h) { patch.ports.put(i, mesh.solid(h)); });
  patch.after = patch.before.ring ? closed_fan(patch.before.k) : open_fan(patch.before.k);
  return patch;
}

FanChange begin_collapse(RuleSource& rules, StripMesh& mesh, Halfedge chord) {
  FanChange change;
  InteriorFan& interior = change.fan;
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
  change.take(rules.answer_collapse(mesh, chord, patch), patch.after, patch.gap);
  walk_patch(
      mesh, chord,
      [&](std::size_t j, Halfedge h) {
        const bool stays = j + 1 < before.size() && before.is_fan(j) && before.is_fan(j + 1);
        if (stays && patch.inner.get(j) && !change.colors.get(before.port(j))) mesh.set_solid(h, false);
      },
      [](std::size_t, Halfedge) {});
  return change;
}

Halfedge change_by_collapse(StripMesh& mesh, Halfedge chord, const FanChange& change) {
  return mesh.remove_vertex(chord, change.moved());
}

Rewrite finish_collapse(StripMesh& mesh, const FanChange& change, Halfedge left) {
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

int isolated_outside(const StripMesh& mesh, std::span<const Halfedge> given_up) {
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

Rewrite flip_by_rule(StripMesh& mesh, Halfedge h) {
  const Halfedge g = mesh.opposite(h);
  const Halfedge first = StripMesh::next(h);
  const Halfedge third = StripMesh::next(g);
  const Halfedge port[4] = {first, StripMesh::next(first), third, StripMesh::next(third)};
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
    isolated += isolated_outside(mesh, std::span<const Halfedge>(outer, n));
    for (std::size_t i = 0; i < n; ++i) mesh.set_solid(outer[i], false);
  }
  if (inner && !rule.inner) mesh.set_solid(h, false);
  const Halfedge turned = mesh.turn_edge(h);
  if (rule.inner) mesh.set_solid(turned, true);
  return {{rule.strips, 0, isolated}, turned, 4};
}

}  // namespace detail

// ---- the public functions, with and without a check that is made in every build

static Rewrite split_by_rule(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex) {
  detail::RuleSource rules;
  const detail::FanChange change = detail::begin_split(rules, mesh, where);
  return detail::finish_split(mesh, change, detail::change_by_split(mesh, where, change, new_vertex));
}

static Rewrite collapse_by_rule(StripMesh& mesh, Halfedge chord) {
  detail::RuleSource rules;
  const detail::FanChange change = detail::begin_collapse(rules, mesh, chord);
  return detail::finish_collapse(mesh, change, detail::change_by_collapse(mesh, chord, change));
}

Rewrite split(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex) {
  RESTRIP_ASSERT_GRANTED(check_split(mesh, where, new_vertex), "split");
  return split_by_rule(mesh, where, new_vertex);
}

Rewrite collapse(StripMesh& mesh, Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(check_collapse(mesh, chord), "collapse");
  return collapse_by_rule(mesh, chord);
}

Rewrite flip(StripMesh& mesh, Halfedge h) {
  RESTRIP_ASSERT_GRANTED(check_flip(mesh, h), "flip");
  return detail::flip_by_rule(mesh, h);
}

Checked checked_split(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex) {
  Checked done;
  done.refusal = check_split(mesh, where, new_vertex);
  if (!done) return done;
  done.rewrite = split_by_rule(mesh, where, new_vertex);
  done.new_vertices.push_back(mesh.to(done.rewrite.halfedge));
  return done;
}

Checked checked_collapse(StripMesh& mesh, Halfedge chord) {
  Checked done;
  done.refusal = check_collapse(mesh, chord);
  if (done) done.rewrite = collapse_by_rule(mesh, chord);
  return done;
}

Checked checked_flip(StripMesh& mesh, Halfedge h) {
  Checked done;
  done.refusal = check_flip(mesh, h);
  if (done) done.rewrite = detail::flip_by_rule(mesh, h);
  return done;
}

}  // namespace restrip
