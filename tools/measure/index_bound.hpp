// A lower bound on the indices of any strip index buffer, with a proof that only needs additions.
//
//   const IndexBound bound = strip_index_lower_bound(mesh);
//   bound.indices                       // every index buffer of these triangles has at least this many
//   bound.cuts                          // the proof: docs/explanation/theory.md, "Lower bound on indices"
//
// An index serves at most three consecutive triangles. At strip ends and swaps it serves fewer: two are missing at one
// vertex and one at a neighbour, an arrow along a mesh edge. The number missing at a vertex of n triangles is -n modulo
// 3. So the arrows are a flow modulo 3, and cross the border of every set of vertices whose triangles do not add up to
// a multiple of three. The search packs such sets.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_set>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

/// A set of vertices and the multiplier of its border.
struct VertexCut {
  std::vector<Vertex> vertices;  ///< ascending
  std::uint32_t multiplier = 0;  ///< 1 … IndexBound::denominator
};

struct IndexBound {
  static constexpr std::uint32_t denominator = 3U << 18;  ///< of all multipliers

  std::size_t triangles = 0;
  std::size_t components = 0;  ///< of the mesh; triangles that share a vertex are connected
  std::size_t arrows = 0;      ///< a lower bound: the sum of all multipliers over the denominator, rounded up
  std::size_t indices = 0;     ///< triangles + arrows + components - 1; 0 without triangles
  std::vector<VertexCut> cuts;
};

/// The number of rounds that brings the bound within a thousandth of the best that these sets can give, on three meshes
/// of 13,000 to 70,000 triangles.
inline constexpr unsigned thorough_bound = 4;

/// A lower bound on the indices of strips with primitive restart that draw each triangle exactly once and nothing else;
/// degenerate triangles are allowed, and windings do not matter. Corners must differ within a triangle and be less than
/// `vertex_count`; the mesh need not be manifold. The bound is at least the sum of ceil(n / 3) over all vertices, for n
/// triangles at the vertex, plus the restarts between components.
///
/// `rounds`: 0 uses only single vertices. Each round adds edges, triangles and balls of vertices that the fewest arrows
/// so far would not cross; four rounds take some fifteen times as long as none. O(n log n) for n triangles; about 150
/// bytes a triangle without rounds, 300 with four. The arithmetic is in whole numbers, so the result is the same on
/// every machine.
[[nodiscard]] IndexBound strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                 std::size_t vertex_count, unsigned rounds = thorough_bound);

/// The bound for the triangles of a mesh. Its colours do not matter.
[[nodiscard]] IndexBound strip_index_lower_bound(const StripMesh& mesh, unsigned rounds = thorough_bound);

}  // namespace restrip

// ---- the search

namespace restrip {
namespace detail {

// The vertices and edges of a triangle list. Every mesh edge is two arrows, 2 e and 2 e + 1, one each way.
class ArrowGraph {
 public:
  struct Leaving {
    Vertex to;
    std::uint32_t arrow;
  };

  ArrowGraph(std::span<const std::array<Vertex, 3>> triangles, std::size_t vertex_count)
      : lacking_(vertex_count, 0), first_(vertex_count + 1, 0) {
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      for (unsigned s = 0; s < 3; ++s) {
        const auto [low, high] = std::minmax(t[s], t[(s + 1) % 3]);
        edges.push_back(std::uint64_t{low} << 32 | high);
        lacking_[t[s]] = static_cast<std::uint8_t>((lacking_[t[s]] + 2) % 3);
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const std::uint64_t e : edges) {
      ++first_[static_cast<std::size_t>(e >> 32) + 1];
      ++first_[std::size_t{static_cast<Vertex>(e)} + 1];
    }
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    leaving_.resize(2 * edges.size());
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    std::uint32_t arrow = 0;
    for (const std::uint64_t e : edges) {
      const auto low = static_cast<Vertex>(e >> 32);
      const auto high = static_cast<Vertex>(e);
      leaving_[place[low]++] = {high, arrow};
      leaving_[place[high]++] = {low, arrow + 1};
      arrow += 2;
    }
  }

  [[nodiscard]] std::size_t vertices() const noexcept { return lacking_.size(); }
  [[nodiscard]] std::size_t arrows() const noexcept { return leaving_.size(); }
  [[nodiscard]] std::span<const Leaving> from(Vertex v) const noexcept {
    return std::span(leaving_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  /// The number missing at v, modulo 3.
  [[nodiscard]] unsigned lacking(Vertex v) const noexcept { return lacking_[v]; }

 private:
  std::vector<std::uint8_t> lacking_;
  std::vector<std::uint32_t> first_;
  std::vector<Leaving> leaving_;
};

// The linear program: the fewest arrows that cross every set. Its dual: the largest multipliers that load no arrow by
// more than one unit. A set that lacks 1 modulo 3 is crossed by an arrow inward or two outward, one that lacks 2 by an
// arrow outward or two inward. Loads count halves, so that all numbers are whole: an arrow that is enough by itself
// weighs 2, others 1, and loads are at most 2 units.
//
// descend() is the primal-dual hybrid gradient method with the step sizes of Pock and Chambolle ("Diagonal
// preconditioning for first order primal-dual algorithms in convex optimization", 2011), in fixed point.
class CutPacking {
 public:
  using Amount = std::int64_t;

  CutPacking(const ArrowGraph& graph, std::uint32_t unit)
      : graph_(graph),
        unit_(static_cast<std::int32_t>(unit)),
        used_(graph.arrows(), 0),
        ahead_(graph.arrows(), 0),
        weights_(graph.arrows(), 0),
        load_(graph.arrows(), 0),
        inside_(graph.vertices(), false) {}

  [[nodiscard]] std::size_t size() const noexcept { return rows_.size() - 1; }
  [[nodiscard]] std::span<const Vertex> vertices(std::size_t row) const noexcept {
    return std::span(vertices_).subspan(rows_[row].vertices, rows_[row + 1].vertices - rows_[row].vertices);
  }

  /// Adds a set, with the multiplier with which single vertices prove the sum of ceil(n / 3) if it is one of them.
  void add(std::span<const Vertex> set) {
    const unsigned lacking = lacking_of(set);
    rows_.back().lacking = static_cast<std::uint8_t>(lacking);
    for_each_leaving(set, [&](std::uint32_t out) {
      border_.push_back(out);
      weights_[out] += lacking;
      weights_[out ^ 1U] += 3 - lacking;
    });
    vertices_.insert(vertices_.end(), set.begin(), set.end());
    std::sort(vertices_.end() - static_cast<std::ptrdiff_t>(set.size()), vertices_.end());
    multipliers_.push_back(set.size() == 1 ? unit_ / 3 * static_cast<std::int32_t>(lacking) : 0);
    rows_.push_back({border_.size(), vertices_.size(), 0});
  }

  /// Adds edges, triangles and balls around them, those that the present arrows do not cross as they should.
  void add_candidates(std::span<const std::array<Vertex, 3>> triangles) {
    for (Vertex v = 0; v < graph_.vertices(); ++v) {
      if (graph_.from(v).empty()) continue;
      add_balls({v}, 2);
      for (const ArrowGraph::Leaving& way : graph_.from(v))
        if (way.to > v) add_balls({v, way.to}, 1);
    }
    for (const auto& [a, b, c] : triangles) add_balls({a, b, c}, 1);
  }

  void descend(unsigned sweeps) {
    for (unsigned sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t a = 0; a < used_.size(); ++a) {
        if (weights_[a] == 0) continue;
        const Amount step = (2 * Amount{unit_} - load_[a]) / weights_[a];
        const auto now = static_cast<std::int32_t>(std::clamp<Amount>(used_[a] - step, 0, 4 * Amount{unit_}));
        ahead_[a] = 2 * now - used_[a];
        used_[a] = now;
        load_[a] = 0;
      }
      for (std::size_t row = 0; row < size(); ++row) {
        const unsigned lacking = rows_[row].lacking;
        const auto border = border_of(row);
        Amount crossing = 0;
        for (const std::uint32_t out : border) crossing += crossed(ahead_, lacking, out);
        const Amount step = (2 * Amount{unit_} - crossing) / (3 * static_cast<Amount>(border.size()));
        const Amount now = std::clamp<Amount>(multipliers_[row] + step, 0, unit_);
        multipliers_[row] = static_cast<std::int32_t>(now);
        if (now != 0) put(load_, row, now);
      }
    }
  }

  /// Multipliers that load no arrow too much: the multipliers of descend(), lowered if necessary, or of single
  /// vertices; then each raised as far as possible, the largest first. The sum is never below the one of single
  /// vertices.
  [[nodiscard]] std::vector<Amount> feasible() const {
    std::vector<Amount> plain(size(), 0);
    for (std::size_t row = 0; row < size(); ++row)
      if (vertices(row).size() == 1) plain[row] = Amount{unit_ / 3} * rows_[row].lacking;
    std::vector<Amount> found(multipliers_.begin(), multipliers_.end());
    const std::vector<Amount> load = load_of(found);
    for (std::size_t row = 0; row < size(); ++row) {
      Amount most = 2 * Amount{unit_};
      for (const std::uint32_t out : border_of(row)) most = (std::max)({most, load[out], load[out ^ 1U]});
      found[row] = found[row] * 2 * unit_ / most;
    }
    raise(plain);
    raise(found);
    const auto sum = [](const std::vector<Amount>& all) { return std::accumulate(all.begin(), all.end(), Amount{0}); };
    return sum(found) > sum(plain) ? found : plain;
  }

 private:
  struct Row {
    std::size_t border;    // where its border begins
    std::size_t vertices;  // where its vertices begin
    std::uint8_t lacking;
  };

  /// Adds the set if it is new, lacks something, and the present arrows cross it by at least a twentieth less than they
  /// should.
  void add_if_uncrossed(std::span<const Vertex> set) {
    const unsigned lacking = lacking_of(set);
    if (lacking == 0) return;
    Amount crossing = 0;
    for_each_leaving(set, [&](std::uint32_t out) { crossing += crossed(used_, lacking, out); });
    if (crossing < 2 * Amount{unit_} - unit_ / 10 && known_.insert(name_of(set)).second) add(set);
  }

  void add_balls(std::initializer_list<Vertex> seed, unsigned radius) {
    // A limit on the edges at the vertices of a set, so that vertices of many triangles are not slow.
    constexpr std::size_t most_edges = 256;
    ball_.assign(seed);
    for (unsigned r = 0;; ++r) {
      std::size_t edges = 0;
      for (const Vertex v : ball_) edges += graph_.from(v).size();
      if (edges > most_edges) return;
      if (ball_.size() > 1) add_if_uncrossed(ball_);
      if (r == radius) return;
      for (const Vertex v : ball_) inside_[v] = true;
      const std::size_t before = ball_.size();
      for (std::size_t i = 0; i < before; ++i)
        for (const ArrowGraph::Leaving& way : graph_.from(ball_[i])) {
          if (!inside_[way.to]) ball_.push_back(way.to);
          inside_[way.to] = true;
        }
      for (const Vertex v : ball_) inside_[v] = false;
    }
  }

  [[nodiscard]] unsigned lacking_of(std::span<const Vertex> set) const {
    unsigned lacking = 0;
    for (const Vertex v : set) lacking += graph_.lacking(v);
    return lacking % 3;
  }

  template <class Visit>
  void for_each_leaving(std::span<const Vertex> set, Visit visit) {
    for (const Vertex v : set) inside_[v] = true;
    for (const Vertex v : set)
      for (const ArrowGraph::Leaving& way : graph_.from(v))
        if (!inside_[way.to]) visit(way.arrow);
    for (const Vertex v : set) inside_[v] = false;
  }

  // The amount by which the arrows of an edge cross a set that `out` leaves.
  static Amount crossed(const std::vector<std::int32_t>& arrows, unsigned lacking, std::uint32_t out) {
    return Amount{lacking} * arrows[out] + Amount{3 - lacking} * arrows[out ^ 1U];
  }

  [[nodiscard]] std::span<const std::uint32_t> border_of(std::size_t row) const {
    return std::span(border_).subspan(rows_[row].border, rows_[row + 1].border - rows_[row].border);
  }

  // A name that does not depend on the order of vertices. If two sets share a name, one is left out.
  static std::uint64_t name_of(std::span<const Vertex> set) {
    std::uint64_t name = 0;
    for (const Vertex v : set) {
      std::uint64_t mixed = (v + std::uint64_t{1}) * 0x9E3779B97F4A7C15;
      mixed = (mixed ^ mixed >> 29) * 0xBF58476D1CE4E5B9;
      name += mixed ^ mixed >> 32;
    }
    return name;
  }

  void put(std::vector<Amount>& load, std::size_t row, Amount multiplier) const {
    const unsigned lacking = rows_[row].lacking;
    for (const std::uint32_t out : border_of(row)) {
      load[out] += lacking * multiplier;
      load[out ^ 1U] += (3 - lacking) * multiplier;
    }
  }

  [[nodiscard]] std::vector<Amount> load_of(const std::vector<Amount>& multipliers) const {
    std::vector<Amount> load(graph_.arrows(), 0);
    for (std::size_t row = 0; row < size(); ++row)
      if (multipliers[row] != 0) put(load, row, multipliers[row]);
    return load;
  }

  void raise(std::vector<Amount>& multipliers) const {
    std::vector<Amount> load = load_of(multipliers);
    std::vector<std::uint32_t> order(size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return multipliers[a] > multipliers[b]; });
    for (const std::uint32_t row : order) {
      const unsigned lacking = rows_[row].lacking;
      Amount room = (std::numeric_limits<Amount>::max)();
      for (const std::uint32_t out : border_of(row))
        room = (std::min)(
            {room, (2 * Amount{unit_} - load[out]) / lacking, (2 * Amount{unit_} - load[out ^ 1U]) / (3 - lacking)});
      if (room <= 0) continue;
      put(load, row, room);
      multipliers[row] += room;
    }
  }

  const ArrowGraph& graph_;
  std::int32_t unit_;
  std::vector<Row> rows_{{0, 0, 0}};  // and one after the last
  std::vector<std::uint32_t> border_;
  std::vector<Vertex> vertices_;
  std::vector<std::int32_t> multipliers_;
  std::vector<std::int32_t> used_;      // the arrows: how often each is used, in units
  std::vector<std::int32_t> ahead_;     // and its extrapolation
  std::vector<std::uint32_t> weights_;  // of all sets that an arrow crosses
  std::vector<Amount> load_;
  std::vector<bool> inside_;
  std::vector<Vertex> ball_;
  std::unordered_set<std::uint64_t> known_;
};

[[nodiscard]] inline bool are_triangles(std::span<const std::array<Vertex, 3>> triangles, std::size_t vertices) {
  for (const auto& [a, b, c] : triangles)
    if (a == b || b == c || c == a || a >= vertices || b >= vertices || c >= vertices) return false;
  return true;
}

}  // namespace detail

[[nodiscard]] inline IndexBound strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                        std::size_t vertex_count, unsigned rounds) {
  RESTRIP_ASSERT(detail::are_triangles(triangles, vertex_count), "strip_index_lower_bound",
                 "a triangle has a repeated corner, or one that is not a vertex");
  IndexBound bound;
  if (triangles.empty()) return bound;
  const detail::ArrowGraph graph(triangles, vertex_count);
  detail::CutPacking packing(graph, IndexBound::denominator);
  for (Vertex v = 0; v < vertex_count; ++v)
    if (graph.lacking(v) != 0) packing.add(std::array{v});
  packing.descend(80);
  for (unsigned round = 0; round < rounds; ++round) {
    const std::size_t before = packing.size();
    packing.add_candidates(triangles);
    if (packing.size() == before) break;
    packing.descend(60);
  }
  const auto multipliers = packing.feasible();
  std::uint64_t sum = 0;
  for (std::size_t row = 0; row < packing.size(); ++row) {
    if (multipliers[row] == 0) continue;
    const auto vertices = packing.vertices(row);
    bound.cuts.push_back({{vertices.begin(), vertices.end()}, static_cast<std::uint32_t>(multipliers[row])});
    sum += static_cast<std::uint64_t>(multipliers[row]);
  }
  bound.triangles = triangles.size();
  std::vector<Vertex> parent(vertex_count);
  std::iota(parent.begin(), parent.end(), 0U);
  for (const auto& [a, b, c] : triangles)
    for (const Vertex v : {b, c}) parent[detail::find_root(parent, v)] = detail::find_root(parent, a);
  for (Vertex v = 0; v < vertex_count; ++v) bound.components += parent[v] == v && !graph.from(v).empty() ? 1U : 0U;
  bound.arrows = static_cast<std::size_t>((sum + IndexBound::denominator - 1) / IndexBound::denominator);
  bound.indices = bound.triangles + bound.arrows + bound.components - 1;
  return bound;
}

[[nodiscard]] inline IndexBound strip_index_lower_bound(const StripMesh& mesh, unsigned rounds) {
  std::vector<std::array<Vertex, 3>> triangles;
  triangles.reserve(mesh.triangle_count());
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(mesh.corners(t));
  return strip_index_lower_bound(triangles, mesh.vertex_bound(), rounds);
}

}  // namespace restrip
