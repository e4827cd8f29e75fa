// The choice between the rule of a split or a collapse and the previous colours.
//
// Outline. Passed on: a strip that a new triangle cuts goes through that triangle; a strip through a removed triangle
// closes up; nothing else changes. Both are priced before anything is written: strips and isolated triangles from the
// bits of the patch, swaps from these and from the turns of the strips outside ports whose turn changes. The choice is
// what bounds the indices that an operation adds by six (docs/explanation/theory.md, "What an operation adds").
//
// Cost. Linear in the patch; on words of bits for interior fans of ordinary valence.
#include "search/rule_choice.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "operations/join.hpp"
#include "operations/patch_walk.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::detail {

namespace {

using Halfedge = StripMesh::Halfedge;

/// The edges of a closed fan that are swaps. Two triangles that follow each other along the loop turn the same way when
/// both continue along the loop, or both leave it by their ports.
constexpr Word fan_swaps(std::size_t k, Word loop, Word ports) noexcept {
  return loop & ((turned_down(loop, 1, k) & turned_down(loop, k - 1, k)) | (ports & turned_down(ports, 1, k)));
}

/// The number of swaps on the inner edges of a ring with chord. A and D are reversed: if a strip continues along the
/// ring they turn outwards, as fan triangles do at their ports.
constexpr int ring_swaps(std::size_t k, std::size_t a, Word inner, Word fan_ports) noexcept {
  const std::size_t n = k + 2;
  const Word ring = inner & low_bits(n);
  const Word inserted = bit(0) | bit(a + 1);
  const Word ports = (fan_ports & low_bits(a)) << 1 | (fan_ports >> a) << (a + 2);
  const Word chord = has(inner, k + 2) ? inserted : 0;
  const Word apart = inserted & ~chord;
  const Word before = turned_down(ring, n - 1, n);  // bit m: the edge before element m; bit m of ring: the one after it
  // Turning outwards or along, for an element whose solid edges are the one after it and another, or before it.
  const Word outwards_from = ports | (before & apart);
  const Word along_from = (before & ~inserted) | chord;
  const Word outwards_to = ports | (ring & apart);
  const Word along_to = (ring & ~inserted) | chord;
  const Word over_chord = (ring & before >> (a + 1)) | (before & ring >> (a + 1));
  return count_bits(
      (ring & ((outwards_from & turned_down(outwards_to, 1, n)) | (along_from & turned_down(along_to, 1, n)))) |
      (over_chord & chord & 1) << n);
}

/// The loop edges of a closed fan, as the ring of a split inherits them.
constexpr Word passed_to_ring(std::size_t k, std::size_t a, Word loop) noexcept {
  const Word cut = (loop >> (k - 1) & 1) | (loop >> (a - 1) & 1) << 1;  // at A, at D
  return (loop & low_bits(a - 1)) << 1 | (loop >> a & low_bits(k - a - 1)) << (a + 2) | (cut & 1) |
         (cut & 1) << (k + 1) | (cut >> 1) << a | (cut >> 1) << (a + 1);
}
/// The ring of a collapse, as the loop edges inherit it.
constexpr Word passed_to_fan(std::size_t k, std::size_t a, Word ring) noexcept {
  return kept_loop(k, a, ring) | (ring >> (k + 1) & ring & 1) << (k - 1) | (ring >> a & ring >> (a + 1) & 1) << (a - 1);
}

/// The same between a layout without inserted elements and one with them, in either direction.
FanBits passed_on(const Patch& before, const FanBits& colors, const Patch& after) {
  const bool inserts = before.size() < after.size();
  const Patch& with = inserts ? after : before;
  FanBits passed;
  for (std::size_t i = 0; i < (with.ring ? with.k : with.k - 1); ++i) {
    const std::size_t first = with.element(i);
    const std::size_t second =
        with.element((i + 1) % with.k) == (first + 1) % with.size() ? first : (first + 1) % with.size();
    if (!inserts) {
      passed.put(i, colors.get(first) && colors.get(second));
    } else {
      passed.put(first, colors.get(i));
      if (second != first) passed.put(second, colors.get(i));
    }
  }
  return passed;
}

/// Triangles minus solid inner edges, swaps and isolated triangles of a patch, including swaps at its ports.
/// `outside(i)` is how the strip turns outside solid port i. Linear time.
template <class Outside>
ColoringChange tally(const Patch& at, const FanBits& colors, const FanBits& ports, Outside&& outside) {
  const std::size_t n = at.size();
  const bool chord = at.has_chord() && colors.get(at.chord());
  // Sides counter-clockwise: of a fan triangle the edge before it, its port, the edge after it; of an inserted one the
  // edge before it, the edge after it, the chord.
  struct Sides {
    unsigned before = 0;
    unsigned third = 0;
    unsigned after = 0;
    bool is_fan = true;
    [[nodiscard]] unsigned from_before() const noexcept { return is_fan ? third | after << 1 : after | third << 1; }
    [[nodiscard]] unsigned from_after() const noexcept { return is_fan ? before | third << 1 : third | before << 1; }
    [[nodiscard]] unsigned from_third() const noexcept { return is_fan ? after | before << 1 : before | after << 1; }
  };
  const auto sides = [&](std::size_t m) -> Sides {
    const bool is_fan = at.is_fan(m);
    return {unsigned{m > 0 ? colors.get(m - 1) : at.ring && colors.get(n - 1)},
            unsigned{is_fan ? ports.get(at.port(m)) : chord}, unsigned{(at.ring || m + 1 < n) && colors.get(m)},
            is_fan};
  };
  ColoringChange sum{static_cast<int>(n) - int{chord}, 0, 0};
  if (chord) sum.swaps += is_swap(sides(at.inserted).from_third(), sides(at.opposite).from_third());
  for (std::size_t m = 0; m < n; ++m) {
    const Sides here = sides(m);
    sum.isolated += int{(here.before | here.third | here.after) == 0};
    if (here.is_fan && here.third != 0) sum.swaps += is_swap(here.from_third(), outside(at.port(m)));
    if (here.after == 0) continue;
    --sum.strips;
    sum.swaps += is_swap(here.from_after(), sides(m + 1 < n ? m + 1 : 0).from_before());
  }
  return sum;
}

/// The change when a closed fan becomes a ring with the given colours. `first`: the spoke of t_0.
ColoringChange ring_for_fan(const StripMesh& mesh, Halfedge first, const InteriorFan& fan, Word ring, Word loop) {
  const auto [k, a] = std::pair{fan.k, fan.a};
  const Word ports = fan.ports;
  ColoringChange change{2 - count_difference(ring, loop),
                        ring_swaps(k, a, ring, ports) - count_bits(fan_swaps(k, loop, ports)),
                        count_difference(isolated_ring(k, a, ring, ports), isolated_closed(k, loop, ports))};
  // The fan triangles whose strip turns differently from before, seen from their ports: to the next, to the previous
  // one.
  const Word next = (ring >> 1 & low_bits(a)) | (ring >> 2 & low_bits(k) & ~low_bits(a));
  const Word last = (ring & low_bits(a)) | (ring >> 1 & low_bits(k) & ~low_bits(a));
  const Word last_in_fan = turned_down(loop, k - 1, k);
  for (Word rest = ports & ((next ^ loop) | (last ^ last_in_fan)); rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const unsigned outside = mesh.other_solid_sides(mesh.opposite(mesh.next(i == 0 ? first : fan.spokes[i - 1])));
    const auto turn = [i](Word to_next, Word to_last) {
      return static_cast<unsigned>(to_next >> i & 1) | static_cast<unsigned>(to_last >> i & 1) << 1;
    };
    change.swaps += is_swap(turn(next, last), outside) - is_swap(turn(loop, last_in_fan), outside);
  }
  return change;
}

}  // namespace

Rule RuleChoice::split(const StripMesh& mesh, Halfedge left, const InteriorFan& fan) {
  ++counts_.asked;
  return chosen(split_rule({fan.k, fan.a}, fan.loop, fan.ports), passed_to_ring(fan.k, fan.a, fan.loop),
                [&](Word ring) { return ring_for_fan(mesh, left, fan, ring, fan.loop); });
}
Rule RuleChoice::collapse(const StripMesh& mesh, Halfedge chord, const InteriorFan& fan, Word ring) {
  ++counts_.asked;
  return chosen(collapse_rule({fan.k, fan.a}, ring, fan.ports), passed_to_fan(fan.k, fan.a, ring),
                [&](Word loop) { return -ring_for_fan(mesh, mesh.fan_step(chord).spoke, fan, ring, loop); });
}

// Whether colours with the change `kept` are as good as the rule's.
bool RuleChoice::keeps(const ColoringChange& kept, const ColoringChange& by_rule) noexcept {
  if (kept.price(cost_) > by_rule.price(cost_)) {
    took(by_rule);
    return false;
  }
  change_ = kept;
  ++counts_.kept;
  return true;
}

// `change`(colours) prices them.
template <class Change>
Rule RuleChoice::chosen(const Rule& rule, Word passed, Change&& change) {
  if (!weighs_) {
    took({rule.strips, 0, 0});
    return rule;
  }
  const ColoringChange by_rule = change(rule.colors);
  if (!searches_ || !rule.valid || passed == rule.colors) {
    took(by_rule);
    return rule;
  }
  const ColoringChange kept = change(passed);
  return keeps(kept, by_rule) ? Rule{passed, kept.strips, true} : rule;
}
template <class WalkPorts>
Answer RuleChoice::chosen(const StripMesh& mesh, SeenPatch& patch, WalkPorts&& walk_ports) {
  ++counts_.asked;
  Answer rule = answer_by_rule(patch);
  if (!weighs_) {
    took({rule.change.strips, 0, 0});
    return rule;
  }
  FanBits next;  // how strips turn outside the ports
  FanBits last;
  walk_ports([&](std::size_t i, Halfedge port) {
    const unsigned turn = patch.ports.get(i) ? mesh.other_solid_sides(mesh.opposite(port)) : 0;
    next.put(i, (turn & 1U) != 0);
    last.put(i, (turn & 2U) != 0);
  });
  const auto outside = [&](std::size_t i) { return unsigned{next.get(i)} | unsigned{last.get(i)} << 1; };
  const ColoringChange old = tally(patch.before, patch.inner, patch.ports, outside);
  const auto change = [&](const FanBits& now) {
    ColoringChange sum = tally(patch.after, now, patch.ports, outside);
    sum += -old;
    return sum;
  };
  const ColoringChange by_rule = change(rule.colors);
  if (searches_) {
    FanBits passed = passed_on(patch.before, patch.inner, patch.after);
    const ColoringChange kept = change(passed);
    if (keeps(kept, by_rule)) return {std::move(passed), {kept.strips, 0, kept.isolated}};
  } else {
    took(by_rule);
  }
  return rule;
}

Answer RuleChoice::answer_split(const StripMesh& mesh, const VertexSplit& where, SeenPatch& patch) {
  return chosen(mesh, patch, [&](auto&& port) { walk_ports(mesh, where, patch, port); });
}
Answer RuleChoice::answer_collapse(const StripMesh& mesh, Halfedge chord, SeenPatch& patch) {
  return chosen(mesh, patch, [&](auto&& port) {
    walk_patch(
        mesh, chord, [](std::size_t, Halfedge) {}, port);
  });
}

// ---- where a search begins

void RuleChoice::begin_after_split(const StripMesh& mesh, const FanChange& change, Halfedge chord) {
  if (!searches_) return;
  if (!change.interior) {
    edge_triangles(mesh, chord, start_);
    return keep_ends(mesh);
  }
  const auto& fan = change.fan;
  const Word inserted = bit(0) | bit(fan.a + 1);
  const Word all = from_ends_ ? ends_ring(fan.k, fan.a, change.colors.word(), fan.ports) : low_bits(fan.k + 2);
  for (const Word elements : {all & inserted, all & ~inserted})
    visit_ring(mesh, fan, chord, elements, [this](Halfedge h) { start_.push_back(StripMesh::triangle(h)); });
}
void RuleChoice::begin_after_collapse(const StripMesh& mesh, const FanChange& change, Halfedge spoke) {
  if (!searches_) return;
  if (!change.interior) {
    fan_triangles(mesh, spoke, start_);
    return keep_ends(mesh);
  }
  const auto& fan = change.fan;
  const Word all = from_ends_ ? ends_closed(fan.k, change.colors.word(), fan.ports) : low_bits(fan.k);
  visit_fan(mesh, fan, spoke, all, [this](Halfedge h) { start_.push_back(StripMesh::triangle(h)); });
}
void RuleChoice::keep_ends(const StripMesh& mesh) {
  if (from_ends_) std::erase_if(start_, [&](Triangle t) { return mesh.solid_degree(t) == 2; });
}

}  // namespace restrip::detail
