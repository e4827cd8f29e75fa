// Linked rules: they follow the strips that leave the patch, and may join more ports than the rules.
//
// A rule must be sound for every surrounding mesh, so it may only join ports that were joined before. A linked rule
// follows the strips outward for a few triangles, finds that most ports are not joined outside, and may join them
// inside. On the bunny, with the cost of strips, this keeps strips three times as long as rules alone, in three times
// the time (docs/results.md).
//
//   split_and_link(mesh, where);  collapse_and_link(mesh, chord);  flip_and_link(mesh, h);
//
// have three steps. First comes the operation, with the best recolouring that keeps its ports and is sound given the
// strips followed. Then adjacent strip ends in the patch or around it are joined, and exchanges made (join.hpp). Last,
// isolated triangles are absorbed (absorb.hpp). A strip that has not ended after `reach` triangles is assumed to return
// through any port.
//
// The recolouring comes from the tables for closed fans of at most table_max_k triangles: a list for each position and
// port mask, best first. For larger closed fans and for open ones it is searched for by the automaton of all valences
// (impl/linked_search.hpp), which for most fans is run once or twice. Flips, and fans of more than max_word_valence
// triangles, take the rule. Nothing is allocated up to max_word_valence.
//
// impl/outlook.hpp says why this is sound.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "restrip/operations/impl/linked_search.hpp"
#include "restrip/operations/impl/outlook.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/tables/linked.hpp"

namespace restrip {

/// The number of triangles for which a strip is followed outward by default.
inline constexpr std::size_t default_reach = 24;

namespace detail {

/// The first recolouring of a list that is sound.
template <class Table, class LookOut>
constexpr Word first_sound(const Table& table, std::size_t k, std::size_t place, Word ports,
                           Outlook<TablePairs, LookOut> outlook) {
  const std::size_t list = table.first[k] + (place << k) + static_cast<std::size_t>(ports);
  std::size_t at = table.start[list];
  // The last recolouring joins nothing.
  while (outlook.may_close(TablePairs{tables::pairings[table.rules[at].pairing]}) != 0) ++at;
  return table.rules[at].recoloring;
}

}  // namespace detail

/// split_rule() with knowledge of the outside: `look_out(i)` returns where the strip goes that leaves through solid
/// port i: the port through which it returns, strip_ends or out_of_sight. It is called at most once for a port, and
/// only if the answer matters. The result is optimal among all recolourings that keep every port and are sound for
/// every possible result of the calls not made. Beyond table_max_k it is searched for, as impl/linked_search.hpp says:
/// in time linear in k, with one or two table reads for each triangle and each of at most detail::max_answers attempts,
/// few of which are made in practice. If the attempts run out, the result is sound and no worse than the rule,
/// but better ones may exist.
template <class LookOut>
[[nodiscard]] constexpr Rule linked_split_rule(SplitPosition at, Word loop, Word ports, LookOut&& look_out) {
  const auto [k, a] = at;
  RESTRIP_ASSERT(k >= 3 && 1 <= a && a < k && k <= max_word_valence, "linked_split_rule", detail::no_such_split);
  if (k > table_max_k)
    return detail::searched_rule(detail::closed_fan(k), loop, detail::ring_with_chord(k, a), ports, look_out);
  if (!valid_closed(k, loop, ports)) return split_rule(at, loop, ports);
  const bool exchange = 2 * a > k;  // as in split_cell
  const std::size_t by = exchange ? a : 0;
  const std::size_t arc = exchange ? k - a : a;
  const Word turned = detail::turned_down(ports, by, k);
  const Word joined = detail::turned_down(joined_closed(k, loop, ports), by, k);
  detail::Outlook<detail::TablePairs, std::remove_reference_t<LookOut>> outlook(
      k, by, turned, detail::pairs_of<detail::TablePairs>(turned, joined, 0), look_out);
  const Word inner = detail::first_sound(tables::linked_split, k, arc - 1, turned, outlook);
  return detail::rule(
      detail::turned_down(inner & low_bits(k + 2), exchange ? arc + 1 : 0, k + 2) | (inner & bit(k + 2)), loop, 2);
}

/// collapse_rule(), likewise.
template <class LookOut>
[[nodiscard]] constexpr Rule linked_collapse_rule(SplitPosition at, Word inner, Word ports, LookOut&& look_out) {
  const auto [k, a] = at;
  RESTRIP_ASSERT(k >= 3 && 1 <= a && a < k && k <= max_word_valence, "linked_collapse_rule", detail::no_such_split);
  if (k > table_max_k)
    return detail::searched_rule(detail::ring_with_chord(k, a), inner, detail::closed_fan(k), ports, look_out);
  if (!valid_ring(k, a, inner, ports)) return collapse_rule(at, inner, ports);
  const detail::InnerPairs before = detail::ring_pairs(k, a, inner, ports);
  detail::Outlook<detail::TablePairs, std::remove_reference_t<LookOut>> outlook(
      k, 0, ports, detail::pairs_of<detail::TablePairs>(ports, before.joined, before.over_chord), look_out);
  return detail::rule(detail::first_sound(tables::linked_collapse, k, 0, ports, outlook), inner, -2);
}

namespace detail {

/// Follows the strips that leave a patch.
template <ColoredMesh Mesh>
class StripWalk {
 public:
  using Halfedge = typename Mesh::Halfedge;
  struct Port {
    Halfedge halfedge{};
    int name = 0;
  };

  /// `room` has space for the solid ports, and must outlive the walk.
  StripWalk(const Mesh& mesh, std::size_t reach, Port* room) : mesh_(&mesh), reach_(reach), ports_(room) {}
  void add(std::size_t i, Halfedge port) { ports_[count_++] = {port, static_cast<int>(i)}; }

  int operator()(std::size_t port) const {
    std::size_t at = 0;
    while (ports_[at].name != static_cast<int>(port)) ++at;
    Halfedge h = mesh_->opposite(ports_[at].halfedge);
    for (std::size_t steps = 0; steps < reach_; ++steps) {
      const auto step = strip_step(*mesh_, h);
      if (!step.goes_on) return strip_ends;
      h = step.in;
      for (std::size_t i = 0; i < count_; ++i)
        if (ports_[i].halfedge == h) return ports_[i].name;
    }
    return out_of_sight;
  }

 private:
  const Mesh* mesh_;
  std::size_t reach_;
  std::size_t count_ = 0;
  Port* ports_;
};

/// The source of rules for split_with() and collapse_with().
struct LinkedRules {
  std::size_t reach;

  template <class Mesh, class Halfedge>
  Rule split(const Mesh& mesh, Halfedge left, const InteriorFan<Halfedge>& fan) const {
    return with_walk(mesh, left, fan, [&](const auto& walk) {
      return linked_split_rule({fan.k, fan.a}, fan.loop, fan.ports, walk);
    });
  }
  template <class Mesh, class Halfedge>
  Rule collapse(const Mesh& mesh, Halfedge chord, const InteriorFan<Halfedge>& fan, Word ring) const {
    return with_walk(mesh, fan_step(mesh, chord).spoke, fan, [&](const auto& walk) {
      return linked_collapse_rule({fan.k, fan.a}, ring, fan.ports, walk);
    });
  }

  template <class Mesh, class Bits, class WalkPorts>
  Answer<Bits> answer(const Mesh& mesh, SeenPatch<Bits>& patch, WalkPorts&& walk_ports) const {
    if constexpr (std::is_same_v<Bits, LongBits>) {
      return answer_by_rule(patch);  // colours that do not fit one word
    } else {
      typename StripWalk<Mesh>::Port room[max_word_valence];
      StripWalk<Mesh> walk(mesh, reach, room);
      walk_ports([&](std::size_t i, typename Mesh::Halfedge h) {
        if (patch.ports.get(i)) walk.add(i, h);
      });
      const Word colors = patch.inner.word;
      const Word ports = patch.ports.word;
      return detail::answer(patch.before, colors, patch.after,
                            searched_rule(patch.before, colors, patch.after, ports, std::as_const(walk)), ports);
    }
  }

 private:
  /// `first` is the spoke of t_0; the others are in the fan.
  template <class Mesh, class Halfedge, class Ask>
  Rule with_walk(const Mesh& mesh, Halfedge first, const InteriorFan<Halfedge>& fan, Ask&& ask) const {
    typename StripWalk<Mesh>::Port room[max_interior_valence];
    StripWalk<Mesh> walk(mesh, reach, room);
    for (Word rest = fan.ports; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      walk.add(i, mesh.next(i == 0 ? first : fan.spokes[i - 1]));
    }
    return ask(walk);
  }
};

}  // namespace detail

/// split() by linked rules. `name`: the new vertex, for meshes that let the caller name it.
template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_and_link(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                                Name... name) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where, name...), "split_and_link");
  return detail::split_and_join_with(detail::LinkedRules{default_reach}, Exchange::yes, mesh, where, name...);
}

/// collapse() by linked rules.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_and_link(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "collapse_and_link");
  return detail::collapse_and_join_with(detail::LinkedRules{default_reach}, Exchange::yes, mesh, chord);
}

/// flip(), then joins and exchanges, which restore a port that the rule cleared without need.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip_and_link(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_flip(mesh, h), "flip_and_link");
  const auto done = flip(mesh, h);
  return detail::with(done, join_at_edge(mesh, done.halfedge, Exchange::yes));
}

}  // namespace restrip
