// StripMesh: the mesh of the library, a compact half-edge mesh whose dual edges carry a colour.
//
// Flat arrays: 12 bytes a triangle for adjacency and colours, 12 for its corners, 5 a vertex. The data structure is the
// corner table with explicit links (Rossignac, "Edgebreaker", 1999; Campagna, Kobbelt, Seidel, "Directed edges", 1998).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/triangle_list.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {
class TrialColors;
class LiveState;

/// Room for `more` elements, so that appending them throws nothing.
template <class Vector>
void make_room(Vector& vector, std::size_t more) {
  if (vector.capacity() - vector.size() < more) vector.reserve((std::max)(vector.size() + more, 2 * vector.capacity()));
}
inline void sort_unique(std::vector<std::uint32_t>& numbers) {
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}
}  // namespace detail

/// A directed mesh edge of a StripMesh: side s of triangle t runs from corner s to corner s + 1; the triangle lies to
/// its left. A boundary halfedge lacks a triangle and is named by its opposite. The *colour of a halfedge* is the
/// colour of the dual edge that crosses its mesh edge: the same for a halfedge and its opposite, and dashed on the
/// boundary.
struct Halfedge {
  std::uint32_t id = none;
  friend constexpr bool operator==(Halfedge, Halfedge) = default;
};

/// Where a vertex v_h is split: along its spokes to v_l and v_r, given as halfedges that leave v_h.
///
/// v_h stays as v_s; the new vertex v_t takes the triangles met when turning counter-clockwise from `right` to `left`.
/// With both spokes, two triangles A = (v_s, v_t, v_l) and D = (v_t, v_s, v_r) are inserted. On a boundary vertex the
/// order of the two spokes says which of the two vertices stays there. Turning counter-clockwise from one boundary edge
/// of the fan to the other,
///  - if `right` comes first, v_t takes the triangles between the spokes and is interior; v_s is on the boundary;
///  - if `left` comes first, the turn from `right` to `left` continues across the boundary: v_t takes the triangles at
///    both ends of the fan and is on the boundary; v_s keeps the triangles between the spokes and is interior.
/// Both make the same mesh except for the names. Both are needed to undo collapses of an edge with one end on the
/// boundary: the first undoes a collapse into that end, the second a collapse into the interior end.
///
/// On the boundary one spoke may be missing; then the new mesh edge is itself on the boundary, one triangle is
/// inserted, and the other spoke is ignored:
///  - left only: v_t takes the triangles clockwise of `left`, A is inserted;
///  - right only: v_t takes the triangles counter-clockwise of `right`, D is inserted.
struct VertexSplit {
  enum class Spokes { both, left_only, right_only };
  Halfedge left{};
  Halfedge right{};
  Spokes spokes = Spokes::both;

  /// The left spoke, or the right one if it is alone.
  [[nodiscard]] constexpr Halfedge spoke() const { return spokes == Spokes::right_only ? right : left; }
};

/// One triangle of a fan, seen from the vertex that h leaves: the colours of its port and of its dual edge to the next
/// triangle counter-clockwise, and the spoke between the two.
struct FanStep {
  bool port = false;
  bool edge = false;
  Halfedge spoke{};
};

/// One triangle of a strip, entered over the dual edge of one of its halfedges: whether the strip continues, and over
/// which halfedge of the next triangle.
struct StripStep {
  bool continues = false;
  Halfedge in{};
};

/// An indexed triangle mesh with coloured dual edges.
///
/// Triangle handles are stable until the triangle is removed. The handle removed last is used by the next insertion, so
/// coarsening and refining again gives the same handles. At most `max_triangles` triangles.
///
/// Preconditions. Handles passed to a function must belong to the mesh as it is now, unless the function says
/// otherwise; debug builds check that (precondition.hpp).
class StripMesh {
 public:
  using Halfedge = restrip::Halfedge;

  static constexpr std::size_t max_triangles = RESTRIP_MAX_TRIANGLES;
  /// A new vertex may be named up to this far beyond vertex_bound(), and one further for each triangle: all vertices up
  /// to it are allocated.
  static constexpr std::size_t max_vertex_gap = 1U << 20;

  StripMesh() = default;

  /// Builds the mesh of a triangle list, counter-clockwise, with all dual edges dashed. The list is anything that a
  /// TriangleList can be made of: 16-bit or 32-bit indices, or corner triples. Linear time. `vertex_count`: valid
  /// corners are 0 … vertex_count - 1. `origin`, if given, receives for each triangle of the mesh its index in the list
  /// (they differ only when some are left out). Throws, before a corner is read, std::length_error for more than
  /// `max_triangles` triangles or more than 2^32 - 1 vertices, and std::invalid_argument when the number of indices is
  /// not a multiple of three.
  template <class Triangles = std::span<const std::array<Vertex, 3>>>
  [[nodiscard]] static StripMesh build(const Triangles& triangles, std::size_t vertex_count,
                                       BuildReport* report = nullptr, std::vector<std::uint32_t>* origin = nullptr) {
    return build_of(TriangleList(triangles), vertex_count, report, origin);
  }

  // ---- walking
  [[nodiscard]] static constexpr Halfedge halfedge(Triangle t, unsigned side = 0) noexcept { return {t << 2 | side}; }
  /// The triangle to the left; for a boundary halfedge, the triangle to the right.
  [[nodiscard]] static constexpr Triangle triangle(Halfedge h) noexcept { return (h.id & ~outside) >> 2; }
  [[nodiscard]] static constexpr unsigned side(Halfedge h) noexcept { return h.id & 3U; }
  [[nodiscard]] static constexpr bool on_boundary(Halfedge h) noexcept { return (h.id & outside) != 0; }
  [[nodiscard]] static constexpr Halfedge next(Halfedge h) noexcept { return {(h.id & ~3U) | side_after(side(h))}; }
  /// The other halfedge of a mesh edge on the boundary.
  [[nodiscard]] static constexpr Halfedge across_boundary(Halfedge h) noexcept { return {h.id ^ outside}; }
  [[nodiscard]] Halfedge opposite(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::opposite", describe(Refusal::no_such_edge));
    if (on_boundary(h)) return {h.id & ~outside};
    const std::uint32_t link = link_of(h);
    return {link == edge_of_mesh ? h.id | outside : link >> 1};
  }
  /// The vertex that h leaves.
  [[nodiscard]] Vertex from(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::from", describe(Refusal::no_such_edge));
    return on_boundary(h) ? corner_of({h.id & ~outside}, 1) : corner_of(h, 0);
  }
  /// The vertex that h enters.
  [[nodiscard]] Vertex to(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::to", describe(Refusal::no_such_edge));
    return on_boundary(h) ? corner_of({h.id & ~outside}, 0) : corner_of(h, 1);
  }
  /// A halfedge that leaves v, or {none} when v belongs to no triangle. On the boundary it is the halfedge from which
  /// turning counter-clockwise meets every triangle of v.
  [[nodiscard]] Halfedge spoke(Vertex v) const noexcept {
    RESTRIP_ASSERT(v < spoke_.size(), "StripMesh::spoke", no_such_vertex);
    return {spoke_[v]};
  }
  /// The halfedge v -> w, or {none}. O(valence of v). Boundary halfedges are found too.
  [[nodiscard]] Halfedge spoke(Vertex v, Vertex w) const noexcept;

  /// The triangle to the left of h, which must exist. One read of the triangle's record.
  [[nodiscard]] FanStep fan_step(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::fan_step", describe(Refusal::no_such_edge));
    RESTRIP_ASSERT(!on_boundary(h), "StripMesh::fan_step", describe(Refusal::boundary_edge));
    const Record& record = triangles_[triangle(h)];
    const unsigned s = side(h);
    const unsigned before = side_before(s);
    const std::uint32_t port = record.link[3 - s - before];
    const std::uint32_t edge = record.link[before];
    const std::uint32_t spoke = edge == edge_of_mesh ? ((h.id & ~3U) | before | outside) : edge >> 1;
    return {(port & 1U) != 0, (edge & 1U) != 0, {spoke}};
  }
  /// halfedge(t, 3) begins at triangle t and leaves over its lowest solid side.
  [[nodiscard]] StripStep strip_step(Halfedge in) const noexcept {
    const auto& link = triangles_[triangle(in)].link;
    const unsigned s = side(in);
    if (s == 3) {
      const unsigned ways = solid_sides(triangle(in));
      if (ways == 0) return {};
      return {true, {link[static_cast<unsigned>(std::countr_zero(ways))] >> 1}};
    }
    // Branch-free: turns are unpredictable.
    const std::uint32_t after = link[side_after(s)];
    const std::uint32_t before = link[side_before(s)];
    const std::uint32_t out = before ^ ((before ^ after) & (0U - (after & 1U)));
    return {(out & 1U) != 0, {out >> 1}};
  }
  /// True when the vertex that h leaves lies on the boundary. Constant time.
  [[nodiscard]] bool leaves_boundary(Halfedge h) const noexcept { return on_boundary(opposite(spoke(from(h)))); }

  // ---- colours
  [[nodiscard]] bool solid(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::solid", describe(Refusal::no_such_edge));
    return (link_of({h.id & ~outside}) & 1U) != 0;
  }
  /// The edge must not be on the boundary. Throws std::bad_alloc only while the mesh is watched; nothing has changed
  /// then.
  void set_solid(Halfedge h, bool solid) {
    RESTRIP_ASSERT(is_side(h), "StripMesh::set_solid", describe(Refusal::no_such_edge));
    RESTRIP_ASSERT(!on_boundary(h) && link_of(h) != edge_of_mesh, "StripMesh::set_solid",
                   describe(Refusal::boundary_edge));
    expect_touches(2);
    color(h, solid);
    touch(triangle(h));
    touch(triangle({link_of(h) >> 1}));
  }
  /// Number of solid dual edges of t: 0 (isolated), 1 (end of a strip) or 2 in a valid colouring.
  [[nodiscard]] unsigned solid_degree(Triangle t) const noexcept {
    RESTRIP_ASSERT(alive(t), "StripMesh::solid_degree", no_such_triangle);
    unsigned degree = 0;
    for (const std::uint32_t link : triangles_[t].link) degree += link & 1U;
    return degree;
  }
  /// The sides of t whose dual edges are solid: bit s for side s.
  [[nodiscard]] unsigned solid_sides(Triangle t) const noexcept {
    RESTRIP_ASSERT(alive(t), "StripMesh::solid_sides", no_such_triangle);
    const auto& link = triangles_[t].link;
    return (link[0] & 1U) | (link[1] & 1U) << 1 | (link[2] & 1U) << 2;
  }
  /// The solid sides of the triangle of h other than h: bit 0 for next(h), bit 1 for the one before h. If the edge of h
  /// is solid as well, this is how the strip turns: 1 or 2, or 0 if it ends.
  [[nodiscard]] unsigned other_solid_sides(Halfedge h) const noexcept {
    RESTRIP_ASSERT(is_side(h), "StripMesh::other_solid_sides", describe(Refusal::no_such_edge));
    const auto& link = triangles_[triangle(h)].link;
    return (link[side_after(side(h))] & 1U) | (link[side_before(side(h))] & 1U) << 1;
  }
  /// Colours every dual edge dashed.
  void clear_colors() noexcept;
  /// Colours every dual edge: bit s of solid_sides[t] is the colour of side s of triangle t, for all triangles below
  /// triangle_bound(). Both triangles of an edge must agree; sides without a neighbour, and triangles that are not
  /// alive, must be 0. Throws std::bad_alloc only while the mesh is watched; nothing has changed then.
  void set_colors(std::span<const std::uint8_t> solid_sides);

  // ---- operations on the mesh alone (restrip::split and its siblings maintain the strips as well)
  /// Inserts the triangles described at VertexSplit and returns the chord v_s -> v_t. Other halfedges around the
  /// vertex, except those of the two spokes, keep their meaning. The dual edges of the new triangles are dashed; all
  /// others keep their colours. The new vertex is `new_vertex`, or the next free one when none is given; vertices up to
  /// it are allocated. Precondition: check_split() grants it. Throws std::length_error when another triangle or vertex
  /// does not fit, or std::bad_alloc; nothing has changed then. The same holds for the other operations. `moved`, if
  /// the fan of an interior vertex has been walked already: the spokes whose left triangles go to the new vertex,
  /// counter-clockwise from `right`.
  Halfedge insert_vertex(const VertexSplit& where, Vertex new_vertex = none, std::span<const Halfedge> moved = {});
  /// Collapses the mesh edge of v_s -> v_t: removes v_t and the triangles at the edge, and returns a halfedge that
  /// leaves v_s: to v_l, the apex of the triangle to the left, or if that triangle does not exist, to v_r. Other
  /// halfedges around the two vertices keep their meaning, except those of the removed triangles and of the edges that
  /// are merged, whose dual edges are dashed; all others keep their colours. Precondition: check_collapse() grants it.
  /// `moved`, if the fans of two interior ends have been walked already: the spokes of v_t whose left triangles stay,
  /// counter-clockwise.
  Halfedge remove_vertex(Halfedge chord, std::span<const Halfedge> moved = {});
  /// Flips an interior mesh edge: the edge of u -> v, with apexes l (left) and r (right), becomes the edge of r -> l,
  /// which is returned. All dual edges keep their colours. Precondition: check_flip() grants it.
  Halfedge turn_edge(Halfedge h);
  /// Replaces any triangles by any others, each by its corners, counter-clockwise; either list may be empty. Vertices
  /// not in use become new ones, vertices left without triangles are removed. Dual edges of removed and of new
  /// triangles are dashed; all others keep their colours. `made` has the size of `in` and receives its handles;
  /// the first ones are the handles of `out` again. Precondition: check_replace() of the same lists grants it.
  /// O(n log n) for the triangles in both lists.
  void replace(std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in, std::span<Triangle> made);

  // ---- list of changes
  /// From now on every triangle whose corners, neighbours or colours change, or that is inserted or removed, is
  /// appended to *changed, some of them more than once. Null ends this. Room in *changed is
  /// made before anything changes; after std::bad_alloc nothing has changed.
  ///
  /// A copy of the mesh is not watched. Moving the mesh moves its watch: the new mesh is watched, the old one no
  /// longer. A mesh that is assigned to keeps its watch, unless a watched mesh is moved into it. The assignment itself
  /// is not reported, although all triangles may have changed.
  void watch(std::vector<Triangle>* changed) noexcept { watch_.changed = changed; }

  // ---- extent
  /// Number of triangles alive.
  [[nodiscard]] std::size_t triangle_count() const noexcept { return triangles_.size() - free_.size(); }
  /// Triangle handles are below this bound.
  [[nodiscard]] std::size_t triangle_bound() const noexcept { return triangles_.size(); }
  [[nodiscard]] bool alive(Triangle t) const noexcept {
    return t < triangles_.size() && triangles_[t].corner[0] != none;
  }
  /// Vertices are below this bound.
  [[nodiscard]] std::size_t vertex_bound() const noexcept { return spoke_.size(); }
  /// The vertex that the next insertion takes if it names none. `n`: the one after it, and so on; a vertex may come
  /// twice if it was named while it was free.
  [[nodiscard]] Vertex next_vertex(std::size_t n = 0) const noexcept;
  [[nodiscard]] bool alive(Halfedge h) const noexcept {
    return side(h) < 3 && alive(triangle(h)) && (!on_boundary(h) || link_of({h.id & ~outside}) == edge_of_mesh);
  }
  /// Counter-clockwise. A removed triangle has `none` for corners.
  [[nodiscard]] std::array<Vertex, 3> corners(Triangle t) const noexcept {
    RESTRIP_ASSERT(t < triangles_.size(), "StripMesh::corners", no_such_triangle);
    return triangles_[t].corner;
  }
  /// True for vertices that no operation may touch (see BuildReport::non_manifold_vertices).
  [[nodiscard]] bool non_manifold(Vertex v) const noexcept {
    RESTRIP_ASSERT(v < non_manifold_.size(), "StripMesh::non_manifold", no_such_vertex);
    return non_manifold_[v] != 0;
  }
  /// Makes room for this many triangles and vertices, so that insertions up to there do not allocate.
  void reserve(std::size_t triangles, std::size_t vertices);

 private:
  friend class detail::TrialColors;
  friend class detail::LiveState;
  friend class History;

  static constexpr const char* no_such_vertex = "the vertex is not one of this mesh";
  static constexpr const char* no_such_triangle = "the triangle is not one of this mesh";
  // A side of a triangle alive, seen from either side: alive(h), also during an operation.
  [[nodiscard]] bool is_side(Halfedge h) const noexcept { return side(h) < 3 && alive(triangle(h)); }

  // Sides are effectively random: a branch would mispredict one time in three.
  [[nodiscard]] static constexpr unsigned side_after(unsigned s) noexcept { return 0b00'10'01U >> (2 * s) & 3U; }
  [[nodiscard]] static constexpr unsigned side_before(unsigned s) noexcept { return 0b01'00'10U >> (2 * s) & 3U; }
  static constexpr std::uint32_t outside = 1U << 31;
  static constexpr std::uint32_t edge_of_mesh = none - 1;  // link of a side without neighbour; reads as dashed

  struct Record {
    std::array<Vertex, 3> corner;
    std::array<std::uint32_t, 3> link;  // opposite halfedge << 1 | solid, or edge_of_mesh
  };

  // A watch moves with the mesh; copies are not watched.
  struct Watch {
    std::vector<Triangle>* changed = nullptr;
    Watch() = default;
    Watch(const Watch& /*other*/) noexcept {}
    Watch(Watch&& other) noexcept : changed(std::exchange(other.changed, nullptr)) {}
    Watch& operator=(const Watch& /*other*/) noexcept { return *this; }  // NOLINT(bugprone-unhandled-self-assignment)
    Watch& operator=(Watch&& other) noexcept {
      if (other.changed != nullptr) changed = std::exchange(other.changed, nullptr);
      return *this;
    }
    ~Watch() = default;
  };
  /// Makes room for `count` calls of touch(), so that they do not throw.
  void expect_touches(std::size_t count) {
    if (watch_.changed != nullptr) detail::make_room(*watch_.changed, count);
  }
  /// A flip moves six corners, joins five edges and colours five; insertions and removals do less, except for the
  /// corners at a vertex.
  static constexpr std::size_t most_other_touches = 6 + 2 * 5 + 2 * 5;
  /// Makes room for the touches of an operation on the triangles around v, or if they are known, at `moved`.
  void expect_touches_around(Vertex v, std::span<const Halfedge> moved);
  void touch(Triangle t) noexcept {
    if (watch_.changed != nullptr) watch_.changed->push_back(t);
  }
  // set_solid() that is not reported to the watch, for trial moves (TrialColors of chain_search.cpp).
  void color(Halfedge h, bool solid) noexcept {
    std::uint32_t& link = link_of(h);
    link = (link & ~1U) | static_cast<std::uint32_t>(solid);
    std::uint32_t& back = link_of({link >> 1});
    back = (back & ~1U) | static_cast<std::uint32_t>(solid);
  }
  void set_corner(Halfedge h, Vertex v) noexcept {
    triangles_[triangle(h)].corner[side(h)] = v;
    touch(triangle(h));
  }
  [[nodiscard]] Vertex corner_of(Halfedge h, unsigned turn) const noexcept {
    return triangles_[triangle(h)].corner[turn == 0 ? side(h) : side_after(side(h))];
  }
  [[nodiscard]] std::uint32_t link_of(Halfedge h) const noexcept { return triangles_[triangle(h)].link[side(h)]; }
  [[nodiscard]] std::uint32_t& link_of(Halfedge h) noexcept { return triangles_[triangle(h)].link[side(h)]; }
  void join(Halfedge g, Halfedge h) noexcept;  // g or h may be on the boundary; dashed
  // Makes room for `count` calls of take_triangle().
  void expect_triangles(std::size_t count);
  Triangle take_triangle();
  void place_triangle(Triangle t, Vertex a, Vertex b, Vertex c) noexcept;
  Halfedge unlink(Halfedge chord, Halfedge back, bool has_left, bool has_right) noexcept;
  void set_spoke(Vertex v, Halfedge h) noexcept { spoke_[v] = h.id; }
  Vertex new_vertex(Vertex wanted);
  class Sides;
  template <class Element>
  static StripMesh build_of(const TriangleList<Element>& list, std::size_t vertex_count, BuildReport* report_out,
                            std::vector<std::uint32_t>* origin);
  void find_non_manifold_vertices(BuildReport& report);

  std::vector<Record> triangles_;
  std::vector<Triangle> free_;
  std::vector<std::uint32_t> spoke_;
  std::vector<std::uint8_t> non_manifold_;
  std::vector<Vertex> free_vertices_;
  Watch watch_;
};

}  // namespace restrip
