// check_replace() and StripMesh::replace for a disc of few triangles.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "mesh/fan_checks.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

/// A side of a removed triangle whose neighbour across it stays.
struct RimSide {
  Vertex from = none;
  Vertex to = none;
  Halfedge across;  ///< may lack a triangle
  bool solid = false;
};

class PatchRim {
 public:
  PatchRim(const StripMesh& mesh, std::span<const Triangle> out) {
    for (const Triangle t : out)
      for (unsigned s = 0; s < 3; ++s) {
        const Halfedge h = StripMesh::halfedge(t, s);
        const Halfedge across = mesh.opposite(h);
        if (StripMesh::on_boundary(across) || !has(out, StripMesh::triangle(across)))
          sides_[count_++] = {mesh.from(h), mesh.to(h), across, mesh.solid(h)};
      }
  }
  [[nodiscard]] static bool has(std::span<const Triangle> triangles, Triangle t) {
    return std::find(triangles.begin(), triangles.end(), t) != triangles.end();
  }
  [[nodiscard]] const RimSide* find(Vertex from, Vertex to) const {
    const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto at =
        std::find_if(sides_.begin(), end, [&](const RimSide& side) { return side.from == from && side.to == to; });
    return at == end ? nullptr : &*at;
  }
  /// The sides with a triangle across.
  [[nodiscard]] std::size_t ports() const {
    return static_cast<std::size_t>(
        std::count_if(sides_.begin(), sides_.begin() + static_cast<std::ptrdiff_t>(count_),
                      [](const RimSide& side) { return !StripMesh::on_boundary(side.across); }));
  }

 private:
  std::array<RimSide, 3 * StripMesh::most_replaced> sides_;
  std::size_t count_ = 0;
};

/// The sides of the new triangles, numbered: side s of triangle t is 3 t + s.
class NewSides {
 public:
  explicit NewSides(std::span<const StripMesh::Places> in) : in_(in) {}
  [[nodiscard]] std::size_t size() const { return 3 * in_.size(); }
  [[nodiscard]] std::uint8_t from(std::size_t i) const { return in_[i / 3][i % 3]; }
  [[nodiscard]] std::uint8_t to(std::size_t i) const { return in_[i / 3][(i + 1) % 3]; }
  /// The first side from one place to another that is not before side `i`, or size().
  [[nodiscard]] std::size_t find(std::uint8_t from, std::uint8_t to, std::size_t i = 0) const {
    while (i < size() && (this->from(i) != from || this->to(i) != to)) ++i;
    return i;
  }
  /// A side that leaves the place, or size().
  [[nodiscard]] std::size_t leaving(std::size_t place) const {
    std::size_t i = 0;
    while (i < size() && from(i) != place) ++i;
    return i;
  }

 private:
  std::span<const StripMesh::Places> in_;
};

/// Whether a mesh edge between the two vertices remains when `out` is removed.
bool edge_stays(const StripMesh& mesh, std::span<const Triangle> out, Vertex v, Vertex w) {
  const Halfedge h = mesh.spoke(v, w);
  if (h.id == none) return false;
  for (const auto side : {h, mesh.opposite(h)})
    if (!StripMesh::on_boundary(side) && !PatchRim::has(out, StripMesh::triangle(side))) return true;
  return false;
}

/// The number of triangles that have the vertex.
std::size_t count_around(const StripMesh& mesh, std::span<const Triangle> triangles, Vertex v) {
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](Triangle t) {
    const auto corners = mesh.corners(t);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }));
}

/// Whether the vertex then has at least three triangles, or is on the boundary.
bool has_enough(const StripMesh& mesh, std::span<const Triangle> out, const NewSides& sides, std::size_t place,
                Vertex v) {
  std::size_t more = 0;
  bool closed = true;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides.from(i) == place) {
      ++more;
      closed = closed && sides.find(sides.to(i), sides.from(i)) < sides.size();
    }
  // Closed by only the new triangles, or by the remaining ones.
  if (closed) return more >= 3;
  if (v == none || mesh.leaves_boundary(mesh.spoke(v))) return true;
  const std::size_t fewer = count_around(mesh, out, v);
  const std::size_t valence = spokes_up_to(mesh, v, 3 + fewer);
  return valence == fewer || valence - fewer + more >= 3;
}

}  // namespace detail

Refusal check_replace(const StripMesh& mesh, std::span<const Triangle> out, std::span<const StripMesh::Places> in,
                      std::span<const Vertex> vertices) {
  if (out.empty() || in.empty() || out.size() > StripMesh::most_replaced || in.size() > StripMesh::most_replaced)
    return Refusal::other_patch;
  const auto listed = [&](Vertex v) { return std::count(vertices.begin(), vertices.end(), v) != 0; };
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!mesh.alive(out[i]) || detail::PatchRim::has(out.first(i), out[i])) return Refusal::other_patch;
    const auto corners = mesh.corners(out[i]);
    if (!std::all_of(corners.begin(), corners.end(), listed)) return Refusal::other_patch;
  }
  for (const Vertex& v : vertices) {
    if (v == none) continue;
    if (std::find(vertices.data(), &v, v) != &v) return Refusal::same_vertex;
    if (detail::count_around(mesh, out, v) == 0) return Refusal::other_patch;
    if (mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  }
  const detail::PatchRim rim(mesh, out);
  const detail::NewSides sides(in);
  std::size_t ports = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides.from(i) >= vertices.size() || sides.to(i) >= vertices.size()) return Refusal::other_patch;
    if (sides.from(i) == sides.to(i) || sides.find(sides.from(i), sides.to(i)) < i) return Refusal::other_patch;
    const Vertex from = vertices[sides.from(i)];
    const Vertex to = vertices[sides.to(i)];
    if (from == none || to == none) continue;
    if (const detail::RimSide* side = rim.find(from, to)) {
      ports += StripMesh::on_boundary(side->across) ? 0U : 1U;
      continue;
    }
    if (detail::edge_stays(mesh, out, from, to)) return Refusal::edge_exists;
  }
  if (ports != rim.ports()) return Refusal::other_patch;
  for (std::size_t place = 0; place < vertices.size(); ++place)
    if (sides.leaving(place) < sides.size() && !detail::has_enough(mesh, out, sides, place, vertices[place]))
      return Refusal::too_few_triangles;
  return Refusal::granted;
}

void StripMesh::replace(std::span<const Triangle> out, std::span<const Places> in, std::span<Vertex> vertices,
                        std::span<Triangle> made) {
  RESTRIP_ASSERT_GRANTED(check_replace(*this, out, in, vertices), "StripMesh::replace");
  RESTRIP_ASSERT(made.size() == in.size(), "StripMesh::replace", "`made` must have one element for each new triangle");
  // Everything that may throw comes first.
  const std::size_t taken_over = (std::min)(out.size(), in.size());
  const std::size_t more = in.size() - taken_over;
  const std::size_t fresh = more - (std::min)(more, free_.size());
  const auto new_vertices = static_cast<std::size_t>(std::count(vertices.begin(), vertices.end(), none));
  if (fresh > max_triangles - triangles_.size())
    RESTRIP_THROW(std::length_error, "restrip: the mesh already has the most triangles that a StripMesh can hold");
  if (new_vertices > none - spoke_.size())
    RESTRIP_THROW(std::length_error, "restrip: a StripMesh has at most 2^32 - 1 vertices");
  detail::make_room(triangles_, fresh);
  detail::make_room(spoke_, new_vertices);
  detail::make_room(non_manifold_, new_vertices);
  detail::make_room(free_, out.size() - taken_over);
  detail::make_room(free_vertices_, vertices.size());
  expect_touches(out.size() + 7 * in.size());  // a new triangle is placed, and joined on three sides

  const detail::PatchRim rim(*this, out);
  const detail::NewSides sides(in);
  // In reverse, so that the handle removed first is the first to be used again.
  for (std::size_t i = out.size(); i-- > taken_over;) {
    place_triangle(out[i], none, none, none);
    free_.push_back(out[i]);
  }
  for (std::size_t i = vertices.size(); i-- > 0;)
    if (vertices[i] != none && sides.leaving(i) == sides.size()) {
      set_spoke(vertices[i], {none});
      free_vertices_.push_back(vertices[i]);
    }
  for (Vertex& v : vertices)
    if (v == none) {
      v = new_vertex(none);
      set_spoke(v, halfedge(out[0]));  // in use from now on
    }
  for (std::size_t i = 0; i < in.size(); ++i) {
    made[i] = i < taken_over ? out[i] : take_triangle();
    place_triangle(made[i], vertices[in[i][0]], vertices[in[i][1]], vertices[in[i][2]]);
  }
  const auto side = [&](std::size_t i) { return halfedge(made[i / 3], static_cast<unsigned>(i % 3)); };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (const std::size_t other = sides.find(sides.to(i), sides.from(i), i + 1); other < sides.size()) {
      join(side(i), side(other));
    } else if (const detail::RimSide* old = rim.find(vertices[sides.from(i)], vertices[sides.to(i)])) {
      join(side(i), old->across);
      if (old->solid) color(side(i), true);
    }
  }
  // A boundary vertex must keep the spoke from which counter-clockwise turns meet all its triangles. If its triangle
  // was in the patch, the one on the boundary now is.
  for (std::size_t place = 0; place < vertices.size(); ++place) {
    const std::size_t any = sides.leaving(place);
    const Vertex v = vertices[place];
    if (any == sides.size() || !detail::PatchRim::has(out, triangle(spoke(v)))) continue;
    Halfedge first = side(any);
    for (Halfedge back = opposite(first); !on_boundary(back) && detail::PatchRim::has(made, triangle(back));
         back = opposite(first)) {
      first = next(back);
      if (first == side(any)) break;
    }
    set_spoke(v, first);
  }
}

}  // namespace restrip
