// restrip on a CGAL::Surface_mesh of triangles: CGAL's Euler operations change the mesh, and its strips are maintained.
//
//   using Mesh = CGAL::Surface_mesh<Point>;
//   restrip::SurfaceMeshStrips strips(mesh);                    // colours are an edge property map, all dashed
//   restrip::collapse(strips, halfedge);                        // v_s -> v_t: v_t is removed
//   restrip::split(strips, {to_left, to_right}, point);         // point of the new vertex
//
// Include this header only where you have CGAL (5.4 or later). operations/adapters/cgal_edge_collapse.hpp has a visitor
// for CGAL's edge_collapse.
#pragma once

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <cstdint>
#include <tuple>

#include "restrip/mesh/mesh.hpp"

namespace restrip {

/// Colours of the dual edges of a CGAL surface mesh. Models SplittableMesh, CollapsibleMesh, FlippableMesh and
/// NumberedMesh. The mesh must outlive it.
template <class Point>
class SurfaceMeshStrips {
 public:
  using Mesh = CGAL::Surface_mesh<Point>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Vertex = typename Mesh::Vertex_index;

  explicit SurfaceMeshStrips(Mesh& mesh)
      : mesh_(mesh),
        solid_(mesh.template add_property_map<typename Mesh::Edge_index, bool>("e:restrip_solid", false).first) {}
  ~SurfaceMeshStrips() { mesh_.remove_property_map(solid_); }
  SurfaceMeshStrips(const SurfaceMeshStrips&) = delete;
  SurfaceMeshStrips& operator=(const SurfaceMeshStrips&) = delete;

  [[nodiscard]] Halfedge next(Halfedge h) const { return mesh_.next(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return mesh_.opposite(h); }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return mesh_.is_border(h); }
  [[nodiscard]] bool solid(Halfedge h) const { return solid_[mesh_.edge(h)]; }
  void set_solid(Halfedge h, bool solid) { solid_[mesh_.edge(h)] = solid; }

  // For index buffers: the indices of CGAL's faces and vertices.
  [[nodiscard]] std::uint32_t triangle(Halfedge h) const { return mesh_.face(h); }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const { return mesh_.halfedge(typename Mesh::Face_index(t)); }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return !mesh_.is_removed(typename Mesh::Face_index(t)); }
  [[nodiscard]] std::size_t triangle_bound() const { return mesh_.num_faces(); }
  [[nodiscard]] std::uint32_t from(Halfedge h) const { return mesh_.source(h); }

  Halfedge insert_vertex(const VertexSplit<Halfedge>& where, const Point& point) {
    using Spokes = typename VertexSplit<Halfedge>::Spokes;
    const bool has_left = where.spokes != Spokes::right_only;
    const bool has_right = where.spokes != Spokes::left_only;
    const Vertex v_s = mesh_.source(has_left ? where.left : where.right);
    // CGAL splits a vertex between two corners and leaves two gaps to be closed by A and D. A missing spoke's corner is
    // outside.
    const Halfedge into_left = has_left ? mesh_.opposite(where.left) : border_into(v_s);
    const Halfedge into_right = has_right ? mesh_.opposite(where.right) : border_into(v_s);
    if (into_left == into_right) return append(into_left, has_left, point);
    const Halfedge left_tip = mesh_.prev(into_left);
    const Halfedge right_tip = mesh_.prev(into_right);
    const Halfedge back = CGAL::Euler::split_vertex(into_left, into_right, mesh_);
    const Halfedge chord = mesh_.opposite(back);
    mesh_.point(mesh_.target(chord)) = point;
    // The edge of a spoke is now one of the new triangle's, and has the spoke's colour.
    for (const auto& [there, tip, side] : {std::tuple{has_left, left_tip, chord}, {has_right, right_tip, back}}) {
      if (!there) continue;
      // Cuts the triangle off that lies between the apex, where `tip` ends, and the new mesh edge.
      if (mesh_.is_border(tip))
        CGAL::Euler::add_face_to_border(tip, side, mesh_);
      else
        CGAL::Euler::split_face(tip, side, mesh_);
      set_solid(mesh_.next(side), false);
      set_solid(mesh_.prev(side), false);
    }
    return chord;
  }
  /// The new vertex is put where v_s is.
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where) {
    return insert_vertex(where, Point(mesh_.point(mesh_.source(where.spoke()))));
  }

  Halfedge remove_vertex(Halfedge chord) {
    const Halfedge back = mesh_.opposite(chord);
    const bool has_left = !mesh_.is_border(chord);
    const bool has_right = !mesh_.is_border(back);
    // On the left the edge of v_t is removed, on the right the edge of v_s, so that neither end loses its last triangle
    // on the way. At the boundary the edge with a triangle beyond it is removed. Returns a halfedge of the other edge.
    const auto remove_triangle = [&](Halfedge side, bool alone) {
      const Halfedge first = mesh_.next(side);
      const Halfedge second = mesh_.prev(side);
      const bool keeps_first = alone && mesh_.is_border(mesh_.opposite(first));
      const Halfedge merged = keeps_first ? first : mesh_.opposite(second);
      CGAL::Euler::join_face(mesh_.opposite(keeps_first ? second : first), mesh_);
      return merged;
    };
    const Halfedge left = has_left ? remove_triangle(chord, !has_right) : Halfedge();
    const Halfedge right = has_right ? remove_triangle(back, !has_left) : Halfedge();
    CGAL::Euler::join_vertex(back, mesh_);
    // The merged edges may lie on the boundary now, where nothing is solid.
    if (has_left) set_solid(left, false);
    if (has_right) set_solid(right, false);
    return has_left ? left : right;
  }

  Halfedge turn_edge(Halfedge h) {
    CGAL::Euler::flip_edge(h, mesh_);
    return mesh_.opposite(h);
  }

 private:
  /// The halfedge without a triangle that enters a boundary vertex.
  [[nodiscard]] Halfedge border_into(Vertex v) const {
    Halfedge h = mesh_.halfedge(v);
    while (!mesh_.is_border(h)) h = mesh_.prev(mesh_.opposite(h));
    return h;
  }

  /// Both corners are the same: the new triangle is added at the boundary edge of `border`.
  Halfedge append(Halfedge border, bool fan_stays, const Point& point) {
    const Vertex v_s = mesh_.target(border);
    const Halfedge chord = CGAL::Euler::add_vertex_and_face_to_border(mesh_.prev(border), border, mesh_);
    const Vertex v_t = mesh_.target(chord);
    mesh_.point(v_t) = point;
    if (fan_stays) return chord;
    // The fan goes to v_t, and v_s keeps the new triangle alone: exchange the two vertices.
    for (const Halfedge h : CGAL::halfedges_around_target(mesh_.opposite(chord), mesh_)) mesh_.set_target(h, v_t);
    for (const Halfedge h : CGAL::halfedges_around_target(chord, mesh_)) mesh_.set_target(h, v_s);
    const Halfedge of_s = mesh_.halfedge(v_s);
    mesh_.set_halfedge(v_s, mesh_.halfedge(v_t));
    mesh_.set_halfedge(v_t, of_s);
    return mesh_.opposite(chord);
  }

  Mesh& mesh_;
  typename Mesh::template Property_map<typename Mesh::Edge_index, bool> solid_;
};

}  // namespace restrip
