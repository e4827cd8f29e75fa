// A half-edge mesh as a user would write one, only from docs/how-to/own-mesh.md and the headers that it links: a record
// for each halfedge, boundary halfedges included, each triangle and each vertex, and free lists, so that numbers are
// used again. It lacks the optional members.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace half_edge {

constexpr std::uint32_t none = 0xffffffff;

struct Halfedge {
  std::uint32_t id = none;
  friend bool operator==(const Halfedge&, const Halfedge&) = default;
};

/// Records by number, and the numbers that are free. The record of a free number belongs to no halfedge.
template <class Record>
struct Pool {
  std::vector<Record> records;
  std::vector<std::uint32_t> unused;

  /// Afterwards `n` can be taken, and all be given back, without an exception.
  void provide(std::size_t n) {
    while (unused.size() < n) {
      records.emplace_back();
      unused.reserve(records.capacity());
      unused.push_back(static_cast<std::uint32_t>(records.size() - 1));
    }
  }
  std::uint32_t take() {
    provide(1);
    const std::uint32_t number = unused.back();
    unused.pop_back();
    return number;
  }
  void give_back(std::uint32_t number) {
    records[number] = Record{};
    unused.push_back(number);
  }
};

class Mesh {
 public:
  using Halfedge = half_edge::Halfedge;
  using Spokes = restrip::VertexSplit<Halfedge>::Spokes;

  /// Three corners for each triangle, counter-clockwise, of an oriented manifold. Triangles are numbered from
  /// `first_triangle` on: numbers need not be the indices of an array.
  explicit Mesh(std::span<const std::uint32_t> corners, std::uint32_t first_triangle = 0) {
    triangles_.records.resize(first_triangle);
    std::map<std::pair<std::uint32_t, std::uint32_t>, Halfedge> by_ends;
    for (std::size_t c = 0; c < corners.size(); c += 3) {
      for (std::size_t i = c; i < c + 3; ++i)
        while (vertices_.records.size() <= corners[i]) vertices_.records.emplace_back();
      const Halfedge h = make_triangle(new_halfedge(corners[c]), corners[c + 1], corners[c + 2]);
      for (const Halfedge side : {h, next(h), next(next(h))}) by_ends[{from(side), from(next(side))}] = side;
    }
    for (const auto& [ends, h] : by_ends) {
      const auto other = by_ends.find({ends.second, ends.first});
      join(h, other != by_ends.end() ? other->second : new_halfedge(ends.second));
    }
  }

  // ---- members of mesh.hpp
  [[nodiscard]] Halfedge next(Halfedge h) const { return at(h).next; }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return at(h).twin; }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return at(h).triangle == none; }
  [[nodiscard]] bool solid(Halfedge h) const { return at(h).solid; }
  void set_solid(Halfedge h, bool solid) { at(h).solid = at(opposite(h)).solid = solid; }

  Halfedge insert_vertex(const restrip::VertexSplit<Halfedge>& where) {
    const bool has_left = where.spokes != Spokes::right_only;
    const bool has_right = where.spokes != Spokes::left_only;
    halfedges_.provide(6);
    triangles_.provide(2);
    const std::uint32_t v_s = from(has_left ? where.left : where.right);
    const std::uint32_t v_t = vertices_.take();
    for (Halfedge h = has_right ? where.right : first_spoke(where.left); !has_left || h != where.left; h = turn(h)) {
      at(h).from = v_t;
      if (!has_left && on_boundary(h)) break;
    }
    const Halfedge chord = new_halfedge(v_s);
    join(chord, new_halfedge(v_t));
    if (has_left) open(where.left, chord);
    if (has_right) open(where.right, opposite(chord));
    return chord;
  }
  Halfedge remove_vertex(Halfedge chord) {
    const Halfedge back = opposite(chord);
    const std::uint32_t v_s = from(chord);
    const std::uint32_t v_t = from(back);
    for (Halfedge h = back; from(h) == v_t; h = turn(h)) at(h).from = v_s;
    const Halfedge to_left = close(chord);
    const Halfedge to_right = close(back);
    vertices_.give_back(v_t);
    return to_left != Halfedge{} ? to_left : to_right;
  }
  Halfedge turn_edge(Halfedge h) {
    const Halfedge g = opposite(h);
    const Halfedge v_l = next(h), l_u = next(v_l), u_r = next(g), r_v = next(u_r);
    leave(v_l, from(v_l));
    leave(u_r, from(u_r));
    leave(h, from(r_v));
    leave(g, from(l_u));
    bind(triangle(h), h, l_u, u_r);
    bind(triangle(g), g, r_v, v_l);
    return h;
  }

  // ---- members of numbered_mesh.hpp
  [[nodiscard]] std::uint32_t triangle(Halfedge h) const { return at(h).triangle; }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const { return triangles_.records[t].first; }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return halfedge(t) != Halfedge{}; }
  [[nodiscard]] std::size_t triangle_bound() const { return triangles_.records.size(); }
  [[nodiscard]] std::uint32_t from(Halfedge h) const { return at(h).from; }

  // ---- other members for its owner
  [[nodiscard]] std::uint32_t to(Halfedge h) const { return from(opposite(h)); }
  /// The halfedge from v to w, {} if it does not exist.
  [[nodiscard]] Halfedge find(std::uint32_t v, std::uint32_t w) const {
    const Halfedge first = vertices_.records[v].spoke;
    for (Halfedge h = first; h != Halfedge{};) {
      if (to(h) == w) return h;
      h = turn(h);
      if (h == first) break;
    }
    return {};
  }

 private:
  struct HalfedgeRecord {
    Halfedge next, twin;                         // no next on the boundary
    std::uint32_t from = none, triangle = none;  // no triangle on the boundary
    bool solid = false;
  };
  struct TriangleRecord {
    Halfedge first;
  };
  struct VertexRecord {
    Halfedge spoke;  // leaves the vertex
  };

  [[nodiscard]] HalfedgeRecord& at(Halfedge h) { return halfedges_.records[h.id]; }
  [[nodiscard]] const HalfedgeRecord& at(Halfedge h) const { return halfedges_.records[h.id]; }

  void leave(Halfedge h, std::uint32_t v) {
    at(h).from = v;
    vertices_.records[v].spoke = h;
  }
  Halfedge new_halfedge(std::uint32_t v) {
    const Halfedge h{halfedges_.take()};
    leave(h, v);
    return h;
  }
  void bind(std::uint32_t t, Halfedge a, Halfedge b, Halfedge c) {
    triangles_.records[t].first = a;
    at(a).next = b, at(b).next = c, at(c).next = a;
    at(a).triangle = at(b).triangle = at(c).triangle = t;
  }
  Halfedge make_triangle(Halfedge h, std::uint32_t second, std::uint32_t third) {
    const Halfedge b = new_halfedge(second), c = new_halfedge(third);
    bind(triangles_.take(), h, b, c);
    return h;
  }
  void join(Halfedge a, Halfedge b) {
    at(a).twin = b, at(b).twin = a;
    at(a).solid = at(b).solid = false;
  }

  /// The next halfedge counter-clockwise that leaves the same vertex; across the boundary after the last one.
  [[nodiscard]] Halfedge turn(Halfedge h) const { return on_boundary(h) ? first_spoke(h) : opposite(next(next(h))); }
  /// The first one counter-clockwise, around a vertex on the boundary.
  [[nodiscard]] Halfedge first_spoke(Halfedge h) const {
    while (!on_boundary(opposite(h))) h = next(opposite(h));
    return h;
  }

  /// Opens a spoke into a triangle to the left of h.
  void open(Halfedge spoke, Halfedge h) {
    const Halfedge outer = opposite(spoke);
    make_triangle(h, to(h), from(outer));
    join(next(h), outer);
    join(next(next(h)), spoke);
  }
  /// The inverse: returns the spoke, {} without a triangle, and restores h.
  Halfedge close(Halfedge h) {
    Halfedge spoke;
    if (!on_boundary(h)) {
      const Halfedge second = next(h), third = next(second), outer = opposite(second);
      spoke = opposite(third);
      join(outer, spoke);
      leave(outer, from(outer));
      leave(spoke, from(spoke));
      triangles_.give_back(triangle(h));
      halfedges_.give_back(second.id);
      halfedges_.give_back(third.id);
    }
    halfedges_.give_back(h.id);
    return spoke;
  }

  Pool<HalfedgeRecord> halfedges_;
  Pool<TriangleRecord> triangles_;
  Pool<VertexRecord> vertices_;
};

// ---- for tests

inline constexpr std::uint32_t first_triangle = 7;
inline constexpr std::uint32_t first_vertex = 1000;

/// The halfedge of a copy that was this one of the StripMesh.
inline Halfedge named(const Mesh& copy, const restrip::StripMesh& of, restrip::StripMesh::Halfedge h) {
  return copy.find(of.from(h) + first_vertex, of.to(h) + first_vertex);
}
/// A copy with other numbers, and the same colours.
inline Mesh copy_of(const restrip::StripMesh& from) {
  std::vector<std::uint32_t> corners;
  std::vector<restrip::StripMesh::Halfedge> solid;
  for (restrip::Triangle t = 0; t < from.triangle_bound(); ++t)
    for (unsigned side = 0; from.alive(t) && side < 3; ++side) {
      corners.push_back(from.corners(t)[side] + first_vertex);
      if (const auto h = restrip::StripMesh::halfedge(t, side); from.solid(h)) solid.push_back(h);
    }
  Mesh mesh(corners, first_triangle);
  for (const auto h : solid) mesh.set_solid(named(mesh, from, h), true);
  return mesh;
}

/// Without vertices that are inserted or removed.
struct OnlyFlips : Mesh {
  explicit OnlyFlips(const restrip::StripMesh& from) : Mesh(copy_of(from)) {}
  Halfedge insert_vertex(const restrip::VertexSplit<Halfedge>&) = delete;
  Halfedge remove_vertex(Halfedge) = delete;
};

}  // namespace half_edge
