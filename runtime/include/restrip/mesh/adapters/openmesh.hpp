// Strips of an OpenMesh triangle mesh, maintained while OpenMesh's vertex_split, collapse and flip change it.
//
//   using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
//   restrip::OpenMeshStrips strips(mesh);                       // colours are an edge property, all dashed
//   restrip::collapse(strips, halfedge);                        // v_s -> v_t: v_t is removed
//   restrip::split(strips, {to_left, to_right}, new_vertex);    // new_vertex: added by you, with its point
//
// Needs OpenMesh 8 or later; include this header only where you have it. collapse() needs the status attributes of
// vertices, edges, halfedges and faces (OpenMesh marks what it removes); the constructor requests them.
// operations/adapters/openmesh_decimater.hpp has a module for OpenMesh's decimaters.
#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <cstddef>
#include <cstdint>

#include "restrip/mesh/mesh.hpp"

namespace restrip {

/// Colours of the dual edges of an OpenMesh TriMesh. Models SplittableMesh, CollapsibleMesh, FlippableMesh and
/// NumberedMesh. The mesh must outlive it and must not be garbage-collected while halfedge handles are kept (the
/// colours themselves survive that).
template <class TriMesh>
class OpenMeshStrips {
 public:
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;

  explicit OpenMeshStrips(TriMesh& mesh) : mesh_(mesh) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_halfedge_status();
    mesh_.request_face_status();
    mesh_.add_property(solid_, "restrip:solid");
    for (const auto edge : mesh_.edges()) mesh_.property(solid_, edge) = 0;
  }
  ~OpenMeshStrips() {
    mesh_.remove_property(solid_);
    mesh_.release_face_status();
    mesh_.release_halfedge_status();
    mesh_.release_edge_status();
    mesh_.release_vertex_status();
  }
  OpenMeshStrips(const OpenMeshStrips&) = delete;
  OpenMeshStrips& operator=(const OpenMeshStrips&) = delete;

  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }

  [[nodiscard]] Halfedge next(Halfedge h) const { return mesh_.next_halfedge_handle(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return mesh_.opposite_halfedge_handle(h); }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return mesh_.is_boundary(h); }
  [[nodiscard]] bool leaves_boundary(Halfedge h) const { return mesh_.is_boundary(mesh_.from_vertex_handle(h)); }
  [[nodiscard]] bool solid(Halfedge h) const { return mesh_.property(solid_, mesh_.edge_handle(h)) != 0; }
  void set_solid(Halfedge h, bool solid) { mesh_.property(solid_, mesh_.edge_handle(h)) = solid ? 1 : 0; }

  // For index buffers: the indices of OpenMesh's faces and vertices.
  [[nodiscard]] std::uint32_t triangle(Halfedge h) const {
    return static_cast<std::uint32_t>(mesh_.face_handle(h).idx());
  }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const {
    return mesh_.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(t)));
  }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const {
    return !mesh_.status(OpenMesh::FaceHandle(static_cast<int>(t))).deleted();
  }
  [[nodiscard]] std::size_t triangle_bound() const { return mesh_.n_faces(); }
  [[nodiscard]] std::uint32_t from(Halfedge h) const {
    return static_cast<std::uint32_t>(mesh_.from_vertex_handle(h).idx());
  }

  /// `new_vertex` has been added to the mesh and belongs to no triangle yet.
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where, Vertex new_vertex) {
    using Spokes = typename VertexSplit<Halfedge>::Spokes;
    const Vertex v_s = mesh_.from_vertex_handle(where.spoke());
    const Vertex v_l = where.spokes == Spokes::right_only ? Vertex() : mesh_.to_vertex_handle(where.left);
    const Vertex v_r = where.spokes == Spokes::left_only ? Vertex() : mesh_.to_vertex_handle(where.right);
    // OpenMesh looks along v_t -> v_s, so our right is its left.
    const Halfedge back = mesh_.vertex_split(new_vertex, v_s, v_r, v_l);
    for (const Halfedge h : {back, opposite(back)}) {
      if (on_boundary(h)) continue;
      set_solid(next(h), false);
      set_solid(next(next(h)), false);
    }
    set_solid(back, false);
    return opposite(back);
  }
  /// The new vertex is put where v_s is.
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where) {
    // A copy: the points may move.
    const typename TriMesh::Point point = mesh_.point(mesh_.from_vertex_handle(where.spoke()));
    return insert_vertex(where, mesh_.add_vertex(point));
  }

  Halfedge remove_vertex(Halfedge chord) {
    const Halfedge back = opposite(chord);
    const Vertex v_s = mesh_.from_vertex_handle(chord);
    const Vertex v_l = on_boundary(chord) ? Vertex() : mesh_.to_vertex_handle(next(chord));
    const Vertex v_r = on_boundary(back) ? Vertex() : mesh_.to_vertex_handle(next(back));
    mesh_.collapse(back);
    // The merged edges may lie on the boundary now, where nothing is solid.
    const Halfedge left = v_l.is_valid() ? mesh_.find_halfedge(v_s, v_l) : Halfedge();
    const Halfedge right = v_r.is_valid() ? mesh_.find_halfedge(v_s, v_r) : Halfedge();
    if (left.is_valid()) set_solid(left, false);
    if (right.is_valid()) set_solid(right, false);
    return left.is_valid() ? left : right;
  }

  Halfedge turn_edge(Halfedge h) {
    mesh_.flip(mesh_.edge_handle(h));
    return h;
  }

 private:
  TriMesh& mesh_;
  OpenMesh::EPropHandleT<unsigned char> solid_;
};

}  // namespace restrip
