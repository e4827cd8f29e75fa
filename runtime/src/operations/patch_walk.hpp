// Walks around the vertices of an operation, in the order in which docs/reference/notation.md numbers edges and ports.
// The same walk reads the colours before and writes them after.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/mesh/walks.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::detail {

// ---- The common case, kept fast: an interior vertex of ordinary valence. One turn around the vertex reads all colours
// and remembers the spokes; afterwards only dual edges whose colour really changes are written.

/// Larger fans use the general code.
inline constexpr std::size_t max_interior_valence = 16;

/// The closed fan of a vertex before a split or after a collapse, numbered as in docs/reference/notation.md.
struct InteriorFan {
  std::size_t k = 0;
  std::size_t a = 0;
  Word loop = 0;  ///< colours of the loop; before a collapse, of the edges that it keeps
  Word ports = 0;
  Halfedge spokes[max_interior_valence];  ///< the mesh edge that loop edge i crosses, seen from the vertex; not the
                                          ///< edges next to A and D, which an operation makes or removes

  /// Colours kept loop edges. Edges are cleared before the mesh changes and set after it, so that the colouring is
  /// valid all the time (operations.hpp, "Exceptions").
  void write(StripMesh& mesh, Word edges, bool solid) const {
    const Word made = bit(a - 1) | bit(k - 1);
    for (Word rest = edges & ~made; rest != 0; rest &= rest - 1)
      mesh.set_solid(spokes[static_cast<std::size_t>(std::countr_zero(rest))], solid);
  }
};

/// Reads the fan between two spokes of an interior vertex. False when it is open or too large.
inline bool read_interior_fan(const StripMesh& mesh, Halfedge left, Halfedge right, InteriorFan& fan) {
  auto h = left;
  std::size_t i = 0;
  do {
    if (i == max_interior_valence || mesh.on_boundary(h)) return false;
    const auto step = mesh.fan_step(h);
    fan.ports |= Word{step.port} << i;
    fan.loop |= Word{step.edge} << i;
    h = step.spoke;
    fan.spokes[i] = h;
    ++i;
    if (h == right) fan.a = i;
  } while (!(h == left));
  fan.k = i;
  return true;
}

/// The inner edges of a ring with chord that lie between fan triangles, as loop edges.
constexpr Word kept_loop(std::size_t k, std::size_t a, Word inner) noexcept {
  return (inner >> 1 & low_bits(a - 1)) | (inner >> (a + 2) & low_bits(k - a - 1)) << a;
}

/// Reads the ring with chord around an interior mesh edge whose ends are interior. False when they are not, or the fan
/// is too large.
inline bool read_ring(const StripMesh& mesh, Halfedge chord, InteriorFan& fan, Word& inner) {
  std::size_t i = 0;     // fan triangles met
  std::size_t edge = 0;  // inner edges met
  for (const auto start : {chord, mesh.opposite(chord)}) {
    if (mesh.on_boundary(start)) return false;
    const auto removed = mesh.fan_step(start);  // the triangle to be removed
    inner |= Word{removed.edge} << edge++;
    auto h = removed.spoke;
    for (;;) {
      if (mesh.on_boundary(h)) return false;
      const auto step = mesh.fan_step(h);
      if (step.spoke == start) break;
      if (i == max_interior_valence) return false;
      if (i > 0) fan.spokes[i - 1] = h;
      fan.ports |= Word{step.port} << i++;
      inner |= Word{step.edge} << edge++;
      h = step.spoke;
    }
    if (start == chord) fan.a = i;
  }
  fan.k = i;
  inner |= Word{mesh.solid(chord)} << edge;
  // A patch has at least one triangle on each side; the general code reports others.
  if (fan.a == 0 || fan.a == fan.k) return false;
  fan.loop = kept_loop(fan.k, fan.a, inner);
  return true;
}

// ---- All other cases. Visitors: visit(i, h), inner edge or port number i crosses the mesh edge of h.

/// Bits of a fan: one word, or allocated words once a bit beyond the first 64 is set.
class FanBits {
 public:
  FanBits() = default;
  explicit FanBits(Word word) noexcept : first_(word) {}
  /// The first 64 bits, unless span() has been called.
  [[nodiscard]] Word word() const noexcept { return first_; }
  [[nodiscard]] bool get(std::size_t i) const noexcept {
    if (words_.empty()) return has(first_, i);
    return i / word_bits < words_.size() && has(words_[i / word_bits], i % word_bits);
  }
  void put(std::size_t i, bool value) {
    if (!value) return;
    if (words_.empty() && i < word_bits)
      first_ |= bit(i);
    else
      span((std::max)(i + 1, words_.size() * word_bits)).set(i);
  }
  /// A view of n bits, or more if they are allocated.
  MutableBitSpan span(std::size_t n) {
    if (words_.empty()) words_.push_back(first_);
    words_.resize((std::max)(words_for(n), words_.size()), 0);
    return {words_.data()};
  }
  [[nodiscard]] int count() const noexcept {
    int n = words_.empty() ? count_bits(first_) : 0;
    for (const Word word : words_) n += count_bits(word);
    return n;
  }
  /// The first n bits of `lower` in reversed order, then m bits of `upper`.
  static FanBits reversed(const FanBits& lower, std::size_t n, const FanBits& upper, std::size_t m) {
    FanBits all;
    for (std::size_t i = 0; i < n; ++i) all.put(n - 1 - i, lower.get(i));
    for (std::size_t i = 0; i < m; ++i) all.put(n + i, upper.get(i));
    return all;
  }

 private:
  Word first_ = 0;
  std::vector<Word> words_;  // all bits, if it is not empty
};

/// The colours that an operation finds in its patch, and the layouts before and after it.
struct SeenPatch {
  Patch before;
  Patch after;
  /// In an open fan: before a split the gap of the left spoke, or of the right one if it is alone; before a collapse
  /// the gap of the spoke to v_l, or if v_l does not exist to v_r.
  std::size_t gap = 0;
  FanBits inner;
  FanBits ports;
};

/// Reads the fan around the vertex that `where` splits. A closed fan is numbered from the left spoke, an open one from
/// the boundary.
inline SeenPatch read_fan(const StripMesh& mesh, const VertexSplit& where) {
  using Spokes = VertexSplit::Spokes;
  const Halfedge start = where.spoke();
  const Halfedge other = where.spokes == Spokes::left_only ? where.left : where.right;
  SeenPatch fan;
  std::size_t k = 0;
  std::size_t ahead = 0;  // the other spoke, counted in triangles from the first one, in either direction
  std::size_t clockwise = 0;
  Halfedge h = start;
  while (!mesh.on_boundary(h)) {
    const Halfedge link = mesh.next(h);
    const Halfedge spoke = mesh.next(link);
    fan.ports.put(k, mesh.solid(link));
    fan.inner.put(k, mesh.solid(spoke));
    ++k;
    h = mesh.opposite(spoke);
    if (h == other) ahead = k;
    if (h == start) {
      fan.before = closed_fan(k);
      fan.after = ring_with_chord(k, ahead);
      return fan;
    }
  }
  SeenPatch lower;  // the rest, read backwards
  for (h = start; !mesh.on_boundary(mesh.opposite(h));) {
    lower.inner.put(fan.gap, mesh.solid(h));
    h = turn_cw(mesh, h);
    lower.ports.put(fan.gap, mesh.solid(mesh.next(h)));
    ++fan.gap;
    if (h == other) clockwise = fan.gap;
  }
  // Loop edge i lies between triangles i and i + 1: those read backwards end with the one across the first spoke.
  fan.inner = FanBits::reversed(lower.inner, fan.gap, fan.inner, k);
  fan.ports = FanBits::reversed(lower.ports, fan.gap, fan.ports, k);
  k += fan.gap;
  const std::size_t other_gap = clockwise != 0 ? fan.gap - clockwise : fan.gap + ahead;
  const auto [low, high] = std::minmax(fan.gap, other_gap);
  fan.before = open_fan(k);
  fan.after = where.spokes == Spokes::both ? path_with_chord(k, low, high) : path(k, low);
  return fan;
}

/// Visits the ports of a fan that has been read: port(i, h), port p_i crosses the mesh edge of h.
template <class Port>
void walk_ports(const StripMesh& mesh, const VertexSplit& where, const SeenPatch& fan, Port&& port) {
  auto h = where.spoke();
  for (std::size_t i = fan.gap; i < fan.before.k; ++i) {
    port(i, mesh.next(h));
    h = turn_ccw(mesh, h);
  }
  h = where.spoke();
  for (std::size_t i = fan.gap; i-- > 0;) {
    h = turn_cw(mesh, h);
    port(i, mesh.next(h));
  }
}

/// Visits spokes counter-clockwise from the one after `from`, until the boundary or `from` again; edge number
/// `edge_index` counts up. Returns the number of fan triangles met (not the ones at `from`).
template <class Edge, class Port>
std::size_t walk_up(const StripMesh& mesh, Halfedge from, std::size_t edge_index, std::size_t port_index, Edge&& edge,
                    Port&& port) {
  std::size_t met = 0;
  auto h = turn_ccw(mesh, from);
  while (!mesh.on_boundary(h)) {
    edge(edge_index++, h);
    const auto after = turn_ccw(mesh, h);
    if (after == from) break;
    port(port_index + met, mesh.next(h));
    ++met;
    h = after;
  }
  return met;
}

/// Visits spokes clockwise from the one after `from` until the boundary; edges count down from `top` - 1.
template <class Edge, class Port>
void walk_down(const StripMesh& mesh, Halfedge from, std::size_t top, Edge&& edge, Port&& port) {
  auto h = turn_cw(mesh, from);
  while (!mesh.on_boundary(mesh.opposite(h))) {
    --top;
    edge(top, h);
    h = turn_cw(mesh, h);
    port(top, mesh.next(h));
  }
}

/// Fan triangles clockwise of `from`, not counting the one at it.
inline std::size_t count_down(const StripMesh& mesh, Halfedge from) {
  std::size_t count = 0;
  walk_down(
      mesh, from, static_cast<std::size_t>(-1), [&](std::size_t, auto) { ++count; }, [](std::size_t, auto) {});
  return count;
}

/// Visits the patch after a split, or before a collapse, whose chord is v_s -> v_t.
///  edge(j, h): inner edge f_j crosses the mesh edge of h;  port(i, h): port p_i crosses the mesh edge of h.
/// Returns its layout and SeenPatch::gap. The mesh is not changed by the walk; edge() may change colours.
template <class Edge, class Port>
std::pair<Patch, std::size_t> walk_patch(const StripMesh& mesh, Halfedge chord, Edge&& edge, Port&& port) {
  const auto back = mesh.opposite(chord);
  if (mesh.on_boundary(chord) || mesh.on_boundary(back)) {
    const auto inward = mesh.on_boundary(chord) ? back : chord;  // the triangle lies to its left
    const std::size_t i = count_down(mesh, mesh.opposite(inward));
    walk_down(mesh, mesh.opposite(inward), i, edge, port);
    return {path(i + walk_up(mesh, inward, i, i, edge, port), i), i};
  }
  const bool tail_on_boundary = mesh.leaves_boundary(chord);
  if (!tail_on_boundary && !mesh.leaves_boundary(back)) {
    const std::size_t a = walk_up(mesh, chord, 0, 0, edge, port);
    const std::size_t k = a + walk_up(mesh, back, a + 1, a, edge, port);
    edge(k + 2, chord);
    return {ring_with_chord(k, a), 0};
  }
  // One end is interior: its triangles lie between the gaps.
  const auto inner = tail_on_boundary ? back : chord;
  const auto outer = mesh.opposite(inner);
  const std::size_t i = count_down(mesh, outer);
  walk_down(mesh, outer, i, edge, port);
  const std::size_t j = i + walk_up(mesh, inner, i, i, edge, port);
  const std::size_t k = j + walk_up(mesh, outer, j + 1, j, edge, port);
  edge(k + 1, inner);
  return {path_with_chord(k, i, j), tail_on_boundary ? j : i};
}

/// Visits the loop edges of the fan around the vertex that `spoke` leaves: edge(i, h), loop edge i crosses the mesh
/// edge of h. Closed: edge k - 1 crosses `spoke`, edges count up from there. Open: `spoke` lies in gap `gap`, which
/// carries edge gap - 1. The mesh is not changed by the walk; edge() may change colours.
template <class Edge>
void walk_fan(const StripMesh& mesh, Halfedge spoke, const Patch& fan, std::size_t gap, Edge&& edge) {
  const std::size_t k = fan.k;
  if (fan.ring) {
    edge(k - 1, spoke);
    auto h = spoke;
    for (std::size_t i = 0; i + 1 < k; ++i) {
      h = turn_ccw(mesh, h);
      edge(i, h);
    }
    return;
  }
  // Gap g carries edge g - 1; gaps 0 and k are boundary.
  if (gap > 0 && gap < k) edge(gap - 1, spoke);
  auto h = spoke;
  for (std::size_t g = gap; g > 1; --g) {
    h = turn_cw(mesh, h);
    edge(g - 2, h);
  }
  h = spoke;
  for (std::size_t g = gap + 1; g < k; ++g) {
    h = turn_ccw(mesh, h);
    edge(g - 1, h);
  }
}

}  // namespace restrip::detail
