// StripMesh, member by member.
#include "restrip/mesh/strip_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "mesh/join_sides.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

void StripMesh::join(Halfedge g, Halfedge h) noexcept {
  if (!on_boundary(g)) link_of(g) = on_boundary(h) ? edge_of_mesh : h.id << 1;
  if (!on_boundary(h)) link_of(h) = on_boundary(g) ? edge_of_mesh : g.id << 1;
  touch(triangle(g));
  touch(triangle(h));
}

void StripMesh::expect_triangles(std::size_t count) {
  const std::size_t fresh = count - (std::min)(count, free_.size());
  if (fresh > max_triangles - triangles_.size())
    RESTRIP_THROW(std::length_error, "restrip: the mesh already has the most triangles that a StripMesh can hold");
  detail::make_room(triangles_, fresh);
}

Triangle StripMesh::take_triangle() {
  if (free_.empty()) {
    triangles_.emplace_back();
    return static_cast<Triangle>(triangles_.size() - 1);
  }
  const Triangle t = free_.back();
  free_.pop_back();
  return t;
}

void StripMesh::place_triangle(Triangle t, Vertex a, Vertex b, Vertex c) noexcept {
  triangles_[t] = {{a, b, c}, {edge_of_mesh, edge_of_mesh, edge_of_mesh}};
  touch(t);
}

void StripMesh::expect_touches_around(Vertex v, std::span<const Halfedge> moved) {
  if (watch_.changed == nullptr) return;
  expect_touches((moved.empty() ? spoke_count(*this, v) : moved.size()) + most_other_touches);
}

Vertex StripMesh::next_vertex(std::size_t n) const noexcept {
  for (auto v = free_vertices_.rbegin(); v != free_vertices_.rend(); ++v)
    if (*v < spoke_.size() && spoke_[*v] == none && n-- == 0) return *v;
  return static_cast<Vertex>(spoke_.size() + n);
}

Vertex StripMesh::new_vertex(Vertex wanted) {
  if (wanted == none) {
    // Vertices that were named by a caller in the meantime are in use again: skip them.
    while (!free_vertices_.empty()) {
      const Vertex v = free_vertices_.back();
      free_vertices_.pop_back();
      if (spoke_[v] == none) return v;
    }
    if (spoke_.size() >= none) RESTRIP_THROW(std::length_error, "restrip: a StripMesh has at most 2^32 - 1 vertices");
    wanted = static_cast<Vertex>(spoke_.size());
  }
  if (wanted >= spoke_.size()) {
    detail::make_room(spoke_, wanted + std::size_t{1} - spoke_.size());
    detail::make_room(non_manifold_, wanted + std::size_t{1} - non_manifold_.size());
    spoke_.resize(wanted + std::size_t{1}, none);
    non_manifold_.resize(spoke_.size(), 0);
  }
  return wanted;
}

void StripMesh::reserve(std::size_t triangles, std::size_t vertices) {
  triangles_.reserve(triangles);
  free_.reserve(triangles);
  spoke_.reserve(vertices);
  non_manifold_.reserve(vertices);
  free_vertices_.reserve(vertices);
}

void StripMesh::clear_colors() noexcept {
  for (Record& record : triangles_)
    for (std::uint32_t& link : record.link)
      if (link != edge_of_mesh) link &= ~1U;
}

void StripMesh::set_colors(std::span<const std::uint8_t> solid_sides) {
  expect_touches(triangle_count());
  for (Triangle t = 0; t < triangles_.size(); ++t) {
    if (!alive(t)) continue;
    Record& record = triangles_[t];
    for (unsigned s = 0; s < 3; ++s) {
      const std::uint32_t solid = solid_sides[t] >> s & 1U;
      RESTRIP_ASSERT(record.link[s] != edge_of_mesh || solid == 0, "StripMesh::set_colors",
                     describe(Refusal::boundary_edge));
      RESTRIP_ASSERT(record.link[s] == edge_of_mesh ||
                         (std::uint32_t{solid_sides[record.link[s] >> 3]} >> (record.link[s] >> 1 & 3U) & 1U) == solid,
                     "StripMesh::set_colors", "the two triangles of an edge have different colours");
      if (record.link[s] != edge_of_mesh) record.link[s] = (record.link[s] & ~1U) | solid;
    }
    touch(t);
  }
}

Halfedge StripMesh::spoke(Vertex v, Vertex w) const noexcept {
  const Halfedge first = spoke(v);
  if (first.id == none) return first;
  Halfedge h = first;
  do {
    if (to(h) == w) return h;
    if (on_boundary(h)) break;
    h = turn_ccw(*this, h);
  } while (!(h == first));
  return {none};
}

Halfedge StripMesh::insert_vertex(const VertexSplit& where, Vertex wanted, std::span<const Halfedge> moved) {
  RESTRIP_ASSERT_GRANTED(check_split(*this, where, wanted), "StripMesh::insert_vertex");
  using Spokes = VertexSplit::Spokes;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  const Halfedge left = where.left;
  const Halfedge right = where.right;
  const Halfedge before_left = has_left ? opposite(left) : Halfedge{};
  const Halfedge before_right = has_right ? opposite(right) : Halfedge{};
  const Vertex v_s = from(has_left ? left : right);
  const Vertex v_l = has_left ? to(left) : none;
  const Vertex v_r = has_right ? to(right) : none;

  // Everything that may throw comes first, so either everything has been taken or nothing.
  expect_touches_around(v_s, moved);
  expect_triangles(has_left && has_right ? 2 : 1);
  const Vertex v_t = new_vertex(wanted);
  const Triangle a = has_left ? take_triangle() : none;
  const Triangle d = has_right ? take_triangle() : none;

  // The triangles of v_t: counter-clockwise from `right`; if the boundary interrupts, the rest is clockwise of `left`.
  const Halfedge old_spoke = spoke(v_s);
  bool interrupted = !has_right;
  for (const Halfedge h : moved) set_corner(h, v_t);
  if (has_right && moved.empty()) {
    Halfedge h = right;
    while (!(has_left && h == left)) {
      if (on_boundary(h)) {
        interrupted = has_left;
        break;
      }
      set_corner(h, v_t);
      h = turn_ccw(*this, h);
    }
  }
  if (interrupted) {
    for (Halfedge back = opposite(left); !on_boundary(back); back = opposite(next(back))) {
      const Halfedge h = next(back);  // leaves the vertex, its triangle is clockwise of the last one
      set_corner(h, v_t);
    }
  }

  Halfedge chord{};
  if (has_left) {
    place_triangle(a, v_s, v_t, v_l);
    join(halfedge(a, 2), left);
    join(halfedge(a, 1), before_left);
    chord = halfedge(a, 0);
    if (on_boundary(left) && spoke(v_l) == before_left) set_spoke(v_l, halfedge(a, 2));
  }
  if (has_right) {
    place_triangle(d, v_t, v_s, v_r);
    join(halfedge(d, 2), right);
    join(halfedge(d, 1), before_right);
    if (has_left)
      join(halfedge(d, 0), chord);
    else
      chord = {halfedge(d, 0).id | outside};
    if (on_boundary(right) && spoke(v_r) == before_right) set_spoke(v_r, halfedge(d, 2));
  }

  // First spokes. A boundary vertex must keep the one from which counter-clockwise turns meet all its triangles.
  const Halfedge back = opposite(chord);
  if (!interrupted) {
    // v_t is interior, or (right only) starts at the chord.
    set_spoke(v_t, back);
    if (old_spoke == right && on_boundary(before_right))
      set_spoke(v_s, next(back));
    else if (from(old_spoke) != v_s)  // a closed fan's first spoke may have gone to v_t
      set_spoke(v_s, has_left ? chord : old_spoke);
  } else {
    // v_s is interior, or (left only) starts at the chord.
    set_spoke(v_s, chord);
    set_spoke(v_t, old_spoke == left && on_boundary(before_left) ? next(chord) : old_spoke);
  }
  return chord;
}

Halfedge StripMesh::remove_vertex(Halfedge chord, std::span<const Halfedge> moved) {
  RESTRIP_ASSERT_GRANTED(check_collapse(*this, chord), "StripMesh::remove_vertex");
  const Vertex v_s = from(chord);
  const Vertex v_t = to(chord);
  const Halfedge back = opposite(chord);
  const bool has_left = !on_boundary(chord);
  const bool has_right = !on_boundary(back);
  const bool boundary_vertex =
      moved.empty() && (on_boundary(opposite(spoke(v_s))) || on_boundary(opposite(spoke(v_t))));
  // Everything that may throw comes first.
  detail::make_room(free_, 2);
  detail::make_room(free_vertices_, 1);
  expect_touches_around(v_t, moved);

  for (const Halfedge h : moved) set_corner(h, v_s);
  if (moved.empty()) {
    const Halfedge first = spoke(v_t);
    Halfedge h = first;
    do {
      set_corner(h, v_s);
      h = turn_ccw(*this, h);
    } while (!(h == first) && !on_boundary(h));
  }

  const Halfedge merged = unlink(chord, back, has_left, has_right);
  if (has_right) free_.push_back(triangle(back));
  if (has_left) free_.push_back(triangle(chord));
  free_vertices_.push_back(v_t);
  set_spoke(v_t, {none});

  Halfedge first = on_boundary(merged) ? next(opposite(merged)) : merged;
  if (boundary_vertex)
    while (!on_boundary(opposite(first))) first = turn_cw(*this, first);
  set_spoke(v_s, first);
  return merged;
}

/// Joins the neighbours on both sides of the triangles at the chord, and empties these triangles.
Halfedge StripMesh::unlink(Halfedge chord, Halfedge back, bool has_left, bool has_right) noexcept {
  Halfedge merged{};
  if (has_right) {
    const Halfedge to_right = next(back);         // v_s -> v_r
    const Halfedge from_right = next(to_right);   // v_r -> v_t
    const Halfedge below = opposite(to_right);    // v_r -> v_s
    const Halfedge above = opposite(from_right);  // v_t -> v_r
    const Vertex v_r = from(from_right);
    join(below, above);
    if (spoke(v_r) == from_right) set_spoke(v_r, below);
    merged = on_boundary(above) ? opposite(below) : above;
    place_triangle(triangle(back), none, none, none);
  }
  if (has_left) {
    const Halfedge to_left = next(chord);        // v_t -> v_l
    const Halfedge from_left = next(to_left);    // v_l -> v_s
    const Halfedge above = opposite(to_left);    // v_l -> v_t
    const Halfedge below = opposite(from_left);  // v_s -> v_l
    const Vertex v_l = from(from_left);
    join(below, above);
    if (spoke(v_l) == from_left) set_spoke(v_l, above);
    merged = on_boundary(below) ? opposite(above) : below;
    place_triangle(triangle(chord), none, none, none);
  }
  return merged;
}

Halfedge StripMesh::turn_edge(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(check_flip(*this, h), "StripMesh::turn_edge");
  expect_touches(most_other_touches);
  const Halfedge g = opposite(h);
  const Halfedge vl = next(h);
  const Halfedge lu = next(vl);
  const Halfedge ur = next(g);
  const Halfedge rv = next(ur);
  const Vertex u = from(h);
  const Vertex v = from(g);
  const Vertex l = from(lu);
  const Vertex r = from(rv);
  const std::array<Halfedge, 4> out{opposite(vl), opposite(lu), opposite(ur), opposite(rv)};
  const std::array<bool, 4> color{solid(vl), solid(lu), solid(ur), solid(rv)};
  const bool inner = solid(h);

  // h: r -> l, then l -> u, u -> r;  g: l -> r, then r -> v, v -> l.
  const std::array<Halfedge, 4> now{next(next(g)), next(h), next(next(h)), next(g)};
  const auto place = [this](Halfedge at, Vertex a, Vertex b, Vertex c) {
    set_corner(at, a);
    set_corner(next(at), b);
    set_corner(next(next(at)), c);
  };
  place(h, r, l, u);
  place(g, l, r, v);
  join(h, g);
  for (unsigned i = 0; i < 4; ++i) {
    join(now[i], out[i]);  // out[i] did not move: l and r differ, so no side is the neighbour of another
    if (!on_boundary(out[i]) && color[i]) set_solid(now[i], true);
  }
  if (inner) set_solid(h, true);
  // First spokes that were halfedges of the two triangles now start elsewhere; v -> l and u -> r moved across.
  for (const auto& [vertex, spoke_now] : {std::pair{u, now[2]}, {v, now[0]}, {l, now[1]}, {r, now[3]}}) {
    const Triangle t = triangle(spoke(vertex));
    if (t != triangle(h) && t != triangle(g)) continue;
    Halfedge first = spoke_now;
    while (!on_boundary(opposite(first))) {
      first = turn_cw(*this, first);
      if (first == spoke_now) break;
    }
    set_spoke(vertex, first);
  }
  return h;
}

/// The halfedges of the triangles, for JoinSides.
class StripMesh::Sides {
 public:
  static constexpr std::uint32_t not_joined = edge_of_mesh;

  explicit Sides(StripMesh& mesh) noexcept : mesh_(&mesh), triangles_(mesh.triangles_.data()) {}

  [[nodiscard]] std::size_t triangle_bound() const noexcept { return mesh_->triangles_.size(); }
  [[nodiscard]] static bool takes(Triangle /*t*/) noexcept { return true; }
  [[nodiscard]] Vertex corner(std::uint32_t h) const noexcept { return triangles_[h >> 2].corner[h & 3U]; }
  [[nodiscard]] std::uint32_t& link(std::uint32_t h) const noexcept { return triangles_[h >> 2].link[h & 3U]; }
  [[nodiscard]] static std::uint32_t joined(std::uint32_t h) noexcept { return h << 1; }
  [[nodiscard]] std::uint32_t across(std::uint32_t h) const noexcept { return link(h) >> 1; }
  void odd_edge(Vertex v, Vertex w) const noexcept { mesh_->non_manifold_[v] = mesh_->non_manifold_[w] = 1; }

 private:
  StripMesh* mesh_;
  Record* triangles_;
};

template <class Element>
StripMesh StripMesh::build_of(const TriangleList<Element>& list, std::size_t vertex_count, BuildReport* report_out,
                              std::vector<std::uint32_t>* origin) {
  detail::expect_vertices(vertex_count);
  StripMesh mesh;
  BuildReport report;
  mesh.spoke_.assign(vertex_count, none);
  mesh.non_manifold_.assign(vertex_count, 0);
  mesh.triangles_.reserve(list.size());
  if (origin != nullptr) origin->clear();
  for (Triangle t = 0; t < list.size(); ++t) {
    if (!list.in_range(t, vertex_count)) {
      ++report.out_of_range_triangles;
    } else if (list.degenerate(t)) {
      ++report.degenerate_triangles;
    } else {
      mesh.triangles_.push_back({{list.corner(t << 2), list.corner(t << 2 | 1U), list.corner(t << 2 | 2U)}, {}});
      if (origin != nullptr) origin->push_back(t);
    }
  }

  detail::JoinSides<Sides>(Sides(mesh), vertex_count, report).run();
  mesh.find_non_manifold_vertices(report);
  if (report_out != nullptr) *report_out = report;
  return mesh;
}

void StripMesh::find_non_manifold_vertices(BuildReport& report) {
  std::vector<std::uint32_t> corners(spoke_.size(), 0);
  for (Triangle t = 0; t < triangles_.size(); ++t) {
    for (unsigned s = 0; s < 3; ++s) {
      const Halfedge h = halfedge(t, s);
      const Vertex v = from(h);
      ++corners[v];
      // On the boundary the first spoke has nothing clockwise of it.
      if (spoke_[v] == none || on_boundary(opposite(h))) set_spoke(v, h);
    }
  }
  for (Vertex v = 0; v < spoke_.size(); ++v) {
    if (spoke_[v] == none) continue;
    std::uint32_t met = 0;
    const Halfedge first = spoke(v);
    Halfedge h = first;
    do {
      ++met;
      h = turn_ccw(*this, h);
    } while (!on_boundary(h) && !(h == first));
    if (met != corners[v]) non_manifold_[v] = 1;
    report.non_manifold_vertices += non_manifold_[v];
  }
}

template StripMesh StripMesh::build_of(const TriangleList<std::uint32_t>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);
template StripMesh StripMesh::build_of(const TriangleList<std::uint16_t>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);
template StripMesh StripMesh::build_of(const TriangleList<std::array<Vertex, 3>>&, std::size_t, BuildReport*,
                                       std::vector<std::uint32_t>*);

}  // namespace restrip
