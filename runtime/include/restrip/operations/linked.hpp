// Linked rules: they follow the strips that leave the patch, and join more than local rules may.
//
// A local rule must be sound whatever lies outside the patch, so it may only join ports that were joined before.
// A rule that follows the strips outward for a few triangles finds that most ports are not joined outside, and may join
// them inside. On real meshes this keeps strips twice as long, at two to three times the time of a local
// rule.
//
//   split_and_link(mesh, where);  collapse_and_link(mesh, chord);  flip_and_link(mesh, h);
//
// do three things. First comes the operation, with the best recolouring that is sound for what was seen (from the
// tables: a list for each position and port mask, best first). Then strip ends that lie side by side in the patch or
// around it are linked. Adoption (adopt.hpp) comes last. A walk that has not ended after `reach` triangles counts as
// "may come back anywhere". The first step uses the local rule for flips and for fans that are open or exceed the
// tables.
//
// Why it is sound. Let Q be the pairs of ports that strips outside join, and P' those that a recolouring joins inside.
// The strips stay paths exactly when P' and Q together close no cycle (docs/theory.md). A cycle must use a pair of P'
// that was not joined before, so from each such pair the rule follows P' and Q alternately until the path ends.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "restrip/operations/adopt.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/tables/linked.hpp"

namespace restrip {

/// What a look outward says of a port, apart from the port it comes back through.
inline constexpr int strip_ends = -1;    ///< the strip ends outside
inline constexpr int out_of_sight = -2;  ///< it was followed as far as allowed

/// How many triangles a strip is followed outward unless the caller says otherwise.
inline constexpr std::size_t default_reach = 24;

namespace detail {

/// As in the tables: four bits for each port, its partner, or itself when it has none.
using Pairing = std::remove_cv_t<decltype(tables::pairings)>::value_type;
static_assert(tables::linked_split.first.size() == table_max_k + 1 &&
              std::size_t{4} * table_max_k <= 8 * sizeof(Pairing));

/// Decides which recolourings are sound, and looks outward no more than necessary: each port once at most.
template <class LookOut>
class Outlook {
 public:
  /// `joined` as in a key, and a pair that it has no bit for, if there is one. Ports are counted from `by` on, in a fan
  /// of k <= table_max_k triangles.
  constexpr Outlook(std::size_t k, std::size_t by, Word ports, Word joined, Word pair, LookOut& look_out)
      : k_(k), by_(by), ports_(ports), look_out_(&look_out) {
    for (auto& port : beyond_) port = not_asked;
    if (pair != 0)
      before_ = with_pair(before_, static_cast<std::size_t>(std::countr_zero(pair)),
                          static_cast<std::size_t>(std::bit_width(pair)) - 1);
    if (joined == 0) return;
    // The other pairs are those of neighbours among the solid ports.
    std::size_t previous = word_bits - 1 - static_cast<std::size_t>(std::countl_zero(ports));
    for (Word rest = ports; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      if (has(joined, i)) before_ = with_pair(before_, previous, i);
      previous = i;
    }
  }

  /// Does a recolouring with this pairing surely close no cycle?
  constexpr bool sound(Pairing after) {
    if (after == before_ || after == no_pairs) return true;
    for (Word rest = ports_; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      const std::size_t j = partner(after, i);
      if (j > i && partner(before_, i) != j && !stays_open(after, i, j)) return false;
    }
    return true;
  }

 private:
  static constexpr std::int8_t not_asked = -3;
  static constexpr std::int8_t comes_back = -4;
  static constexpr auto no_pairs = static_cast<Pairing>(0xfedcba9876543210U);

  static constexpr std::size_t partner(Pairing pairing, std::size_t i) noexcept { return pairing >> (4 * i) & 15U; }
  static constexpr Pairing with_pair(Pairing pairing, std::size_t i, std::size_t j) noexcept {
    if (partner(pairing, i) != i) return pairing;  // two ports, and both bits of `joined` say so
    const auto swap = static_cast<Pairing>(i ^ j);
    return pairing ^ (swap << (4 * i) | swap << (4 * j));
  }

  constexpr int beyond(std::size_t i) {
    if (beyond_[i] == not_asked) {
      const auto turn = [this](std::size_t port) { return port >= k_ ? port - k_ : port; };
      const int seen = (*look_out_)(turn(i + by_));
      const int port = seen < 0 ? seen : static_cast<int>(turn(static_cast<std::size_t>(seen) + k_ - by_));
      beyond_[i] = static_cast<std::int8_t>(port);
      if (port >= 0) beyond_[static_cast<std::size_t>(port)] = static_cast<std::int8_t>(i);
    }
    return beyond_[i];
  }

  // Leaves through port `at` and follows the path: strip_ends, comes_back to `home`, or the port where it goes out of
  // sight.
  constexpr int follow(Pairing pairing, std::size_t at, std::size_t home) {
    for (;;) {
      const int back = beyond(at);
      if (back == out_of_sight) return static_cast<int>(at);
      if (back == strip_ends) return strip_ends;
      const auto port = static_cast<std::size_t>(back);
      if (port == home) return comes_back;
      at = partner(pairing, port);
      if (at == port) return strip_ends;
    }
  }

  constexpr bool stays_open(Pairing after, std::size_t i, std::size_t j) {
    const int one = follow(after, j, i);
    if (one < 0) return one == strip_ends;
    const int two = follow(after, i, j);
    if (two < 0) return two == strip_ends;
    // Both ends are out of sight and may be one there; but not if they were the two ends of a path before.
    const auto start = static_cast<std::size_t>(one);
    const std::size_t inside = partner(before_, start);
    return inside != start && (inside == static_cast<std::size_t>(two) || follow(before_, inside, start) == two);
  }

  std::size_t k_;
  std::size_t by_;
  Word ports_;
  LookOut* look_out_;
  Pairing before_ = no_pairs;
  std::int8_t beyond_[table_max_k] = {};
};

/// The first recolouring of a list that is sound.
template <class Table, class LookOut>
constexpr Word first_sound(const Table& table, std::size_t k, std::size_t place, Word ports, Outlook<LookOut> outlook) {
  const std::size_t list = table.first[k] + (place << k) + static_cast<std::size_t>(ports);
  std::size_t at = table.start[list];
  while (!outlook.sound(tables::pairings[table.rules[at].pairing])) ++at;  // the last one joins nothing
  return table.rules[at].recoloring;
}

}  // namespace detail

/// split_rule() for a fan of k <= table_max_k triangles whose outside can be asked: `look_out(i)` says where the strip
/// goes that leaves through solid port i: the port it comes back through, strip_ends or out_of_sight. It is asked once
/// for a port at most, and only for those that matter. The answer is optimal among all recolourings that are sound for
/// everything that look_out might say.
template <class LookOut>
[[nodiscard]] constexpr Rule linked_split_rule(SplitPosition at, Word loop, Word ports, LookOut&& look_out) {
  const auto [k, a] = at;
  RESTRIP_ASSERT(k >= 3 && 1 <= a && a < k && k <= max_word_valence, "linked_split_rule", detail::no_such_split);
  if (k > table_max_k || !valid_closed(k, loop, ports)) return split_rule(at, loop, ports);
  const bool exchange = 2 * a > k;  // as in split_cell
  const std::size_t by = exchange ? a : 0;
  const std::size_t arc = exchange ? k - a : a;
  const Word turned = detail::turned_down(ports, by, k);
  detail::Outlook<std::remove_reference_t<LookOut>> outlook(
      k, by, turned, detail::turned_down(joined_closed(k, loop, ports), by, k), 0, look_out);
  const Word inner = detail::first_sound(tables::linked_split, k, arc - 1, turned, outlook);
  return detail::rule(
      detail::turned_down(inner & low_bits(k + 2), exchange ? arc + 1 : 0, k + 2) | (inner & bit(k + 2)), loop, 2);
}

/// collapse_rule(), likewise.
template <class LookOut>
[[nodiscard]] constexpr Rule linked_collapse_rule(SplitPosition at, Word inner, Word ports, LookOut&& look_out) {
  const auto [k, a] = at;
  RESTRIP_ASSERT(k >= 3 && 1 <= a && a < k && k <= max_word_valence, "linked_collapse_rule", detail::no_such_split);
  if (k > table_max_k || !valid_ring(k, a, inner, ports)) return collapse_rule(at, inner, ports);
  const detail::RingPairs before = detail::ring_pairs(k, a, inner, ports);
  detail::Outlook<std::remove_reference_t<LookOut>> outlook(k, 0, ports, before.joined, before.over_chord, look_out);
  return detail::rule(detail::first_sound(tables::linked_collapse, k, 0, ports, outlook), inner, -2);
}

namespace detail {

/// Follows the strips that leave a closed fan or a ring.
template <ColoredMesh Mesh>
class StripWalk {
 public:
  using Halfedge = typename Mesh::Halfedge;
  /// `first` is the spoke of t_0; the others are in the fan.
  StripWalk(const Mesh& mesh, const InteriorFan<Halfedge>& fan, Halfedge first, std::size_t reach)
      : mesh_(&mesh), reach_(reach) {
    for (Word rest = fan.ports; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      ports_[count_++] = {mesh.next(i == 0 ? first : fan.spokes[i - 1]), static_cast<int>(i)};
    }
  }
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
  struct Port {
    Halfedge halfedge{};
    int name = 0;
  };
  const Mesh* mesh_;
  std::size_t reach_;
  std::size_t count_ = 0;
  Port ports_[table_max_k];  // the solid ones
};

/// Where split_with() and collapse_with() get the rules of interior fans from.
struct LinkedRules {
  std::size_t reach;

  template <class Mesh, class Halfedge>
  Rule split(const Mesh& mesh, Halfedge left, const InteriorFan<Halfedge>& fan) const {
    if (fan.k > table_max_k) return LocalRules{}.split(mesh, left, fan);
    return linked_split_rule({fan.k, fan.a}, fan.loop, fan.ports, StripWalk<Mesh>(mesh, fan, left, reach));
  }
  template <class Mesh, class Halfedge>
  Rule collapse(const Mesh& mesh, Halfedge chord, const InteriorFan<Halfedge>& fan, Word ring) const {
    if (fan.k > table_max_k) return LocalRules{}.collapse(mesh, chord, fan, ring);
    return linked_collapse_rule({fan.k, fan.a}, ring, fan.ports,
                                StripWalk<Mesh>(mesh, fan, fan_step(mesh, chord).spoke, reach));
  }
};

enum class Side { same, different, unknown };

/// Do the strips that end in the triangles of g and h, different ones, have the same other end?
template <class Mesh>
Side same_strip(const Mesh& mesh, typename Mesh::Halfedge g, typename Mesh::Halfedge h, std::size_t reach) {
  for (const auto& [from, to] : {std::pair{g, h}, {h, g}}) {
    auto at = from;
    // The solid edge out of the end; then always out on the other side.
    for (int side = 0; side < 3 && !mesh.solid(at); ++side) at = mesh.next(at);
    if (!mesh.solid(at)) return Side::different;  // isolated
    auto in = mesh.opposite(at);
    for (std::size_t steps = 0; steps < reach; ++steps) {
      const auto step = strip_step(mesh, in);
      if (!step.goes_on) {
        const auto second = mesh.next(in);
        return in == to || second == to || mesh.next(second) == to ? Side::same : Side::different;
      }
      in = step.in;
    }
  }
  return Side::unknown;
}

}  // namespace detail

/// If a strip ends in the triangle to the left of h, links it with ends of other strips beside it. Looks at no more
/// than 2 * reach triangles for each.
template <ColoredMesh Mesh>
Mending link_end(Mesh& mesh, typename Mesh::Halfedge h, std::size_t reach = default_reach) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "link_end", describe(Refusal::no_such_edge));
  int degree = detail::solid_degree(mesh, h);
  Mending done;
  for (int side = 0; side < 3 && degree < 2; ++side, h = mesh.next(h)) {
    if (mesh.solid(h)) continue;
    const auto across = mesh.opposite(h);
    if (mesh.on_boundary(across)) continue;
    const int there = detail::solid_degree(mesh, across);
    if (there > 1 || detail::same_strip(mesh, h, across, reach) != detail::Side::different) continue;
    mesh.set_solid(h, true);
    done += {-1, -int{degree == 0} - int{there == 0}};
    ++degree;
  }
  return done;
}

namespace detail {

template <class Mesh>
Mending link_ends_around(Mesh& mesh, typename Mesh::Halfedge h) {
  return mend_around(
      mesh, h, [&](typename Mesh::Halfedge g) { return solid_degree(mesh, g) < 2 ? link_end(mesh, g) : Mending{}; });
}

}  // namespace detail

/// split() by linked rules. `name`: the new vertex, for meshes that let the caller name it.
template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_and_link(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                                Name... name) {
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where, name...) == Refusal::granted, "split_and_link",
                 describe(detail::refusal_of_split(mesh, where, name...)));
  auto done = detail::split_with(detail::LinkedRules{default_reach}, mesh, where, name...);
  done = detail::with(done, detail::link_ends_around(mesh, done.halfedge));
  done = detail::with(done, detail::link_ends_around(mesh, mesh.opposite(done.halfedge)));
  return done.isolated > 0 ? detail::with(done, adopt_around(mesh, done.halfedge)) : done;
}

/// collapse() by linked rules.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_and_link(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(detail::refusal_of_collapse(mesh, chord) == Refusal::granted, "collapse_and_link",
                 describe(detail::refusal_of_collapse(mesh, chord)));
  auto done = detail::collapse_with(detail::LinkedRules{default_reach}, mesh, chord);
  done = detail::with(done, detail::link_ends_around(mesh, done.halfedge));
  return done.isolated > 0 ? detail::with(done, adopt_around(mesh, done.halfedge)) : done;
}

/// flip(), then links, which restore a port that the local rule gave up without need.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip_and_link(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::refusal_of_flip(mesh, h) == Refusal::granted, "flip_and_link",
                 describe(detail::refusal_of_flip(mesh, h)));
  auto done = flip(mesh, h);
  for (const auto inner : {done.halfedge, mesh.opposite(done.halfedge)}) {
    done = detail::with(done, link_end(mesh, inner));
    for (const auto outer : {mesh.next(inner), mesh.next(mesh.next(inner))})
      if (const auto across = mesh.opposite(outer); !mesh.on_boundary(across))
        done = detail::with(done, link_end(mesh, across));
  }
  return detail::with(done, adopt_after_flip(mesh, done.halfedge));
}

}  // namespace restrip
