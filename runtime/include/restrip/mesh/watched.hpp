// Watched: any mesh, with a list of the triangles that change.
//
// Buffers that are kept in step with a mesh (output/) must know which triangles changed. A forgotten triangle is drawn
// wrongly, without a warning. A StripMesh makes the list itself (StripMesh::watch). For every other mesh Watched
// derives it from the calls that change the mesh, so that nothing can be forgotten:
//
//   Watched watched(mesh);                             // a custom NumberedMesh
//   Keeper keeper(watched, Policy::quick);
//   StripBuffer buffer(watched);
//   keeper.collapse(chord);
//   for (const auto& range : buffer.update(watched, watched.changed())) upload(range);
//   watched.changed().clear();
//
// Change the mesh and its colours only through the wrapper. A list that you keep by hand can be tested
// (operations/test_adapter.hpp), and so can the triangles that a buffer draws (output/check_buffer.hpp).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

/// Models the concepts that the mesh models, and has its checks. Refers to the mesh, which must outlive it. Each call
/// takes the time of the mesh's call and of a walk around the vertices whose triangles change. Room in the list is made
/// before anything changes; after std::bad_alloc nothing has changed.
template <NumberedMesh Mesh>
class Watched {
 public:
  using Halfedge = typename Mesh::Halfedge;

  explicit Watched(Mesh& mesh) noexcept : mesh_(&mesh) {}

  /// Every triangle whose corners, neighbours or colours have changed since the list was cleared, and those inserted
  /// and removed; some of them more than once.
  [[nodiscard]] std::vector<std::uint32_t>& changed() noexcept { return changed_; }
  [[nodiscard]] const Mesh& mesh() const noexcept { return *mesh_; }

  // ---- forwarded to the mesh
  [[nodiscard]] Halfedge next(Halfedge h) const { return mesh_->next(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return mesh_->opposite(h); }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return mesh_->on_boundary(h); }
  [[nodiscard]] bool solid(Halfedge h) const { return mesh_->solid(h); }
  [[nodiscard]] auto triangle(Halfedge h) const { return mesh_->triangle(h); }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const { return mesh_->halfedge(t); }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return mesh_->has_triangle(t); }
  [[nodiscard]] std::size_t triangle_bound() const { return mesh_->triangle_bound(); }
  [[nodiscard]] auto from(Halfedge h) const { return mesh_->from(h); }
  [[nodiscard]] bool leaves_boundary(Halfedge h) const requires requires(const Mesh& m) { m.leaves_boundary(h); }
  { return mesh_->leaves_boundary(h); }
  [[nodiscard]] bool alive(Halfedge h) const requires requires(const Mesh& m) { m.alive(h); }
  { return mesh_->alive(h); }

  // ---- checks of the mesh (operations/checked.hpp), found by argument-dependent lookup as for the mesh itself
  template <class... Name>
  [[nodiscard]] friend Refusal check_split(const Watched& watched, const VertexSplit<Halfedge>& where,
                                           const Name&... name) requires requires(const Mesh& m) {
    { check_split(m, where, name...) } -> std::same_as<Refusal>;
  }
  { return check_split(watched.mesh(), where, name...); }
  [[nodiscard]] friend Refusal check_collapse(const Watched& watched, Halfedge chord) requires requires(const Mesh& m) {
    { check_collapse(m, chord) } -> std::same_as<Refusal>;
  }
  { return check_collapse(watched.mesh(), chord); }
  [[nodiscard]] friend Refusal check_flip(const Watched& watched, Halfedge h) requires requires(const Mesh& m) {
    { check_flip(m, h) } -> std::same_as<Refusal>;
  }
  { return check_flip(watched.mesh(), h); }

  // ---- changes
  void set_solid(Halfedge h, bool solid) {
    detail::make_room(changed_, 2);
    name(h);
    name(mesh_->opposite(h));
    mesh_->set_solid(h, solid);
  }
  template <class... Name>
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where, Name... name_of_vertex) requires requires(Mesh& m) {
    m.insert_vertex(where, name_of_vertex...);
  }
  {
    detail::add_fan(*mesh_, where.spoke(), changed_);
    detail::make_room(changed_, 2);
    const Halfedge chord = mesh_->insert_vertex(where, name_of_vertex...);
    name(chord);
    name(mesh_->opposite(chord));
    return chord;
  }
  Halfedge remove_vertex(Halfedge chord) requires requires(Mesh& m) { m.remove_vertex(chord); }
  {
    // The remaining neighbours of the two removed triangles lie around either end of the chord.
    detail::add_fan(*mesh_, mesh_->opposite(chord), changed_);
    detail::add_fan(*mesh_, chord, changed_);
    return mesh_->remove_vertex(chord);
  }
  Halfedge turn_edge(Halfedge h) requires requires(Mesh& m) { m.turn_edge(h); }
  {
    detail::make_room(changed_, 6);
    for (Halfedge side : {h, mesh_->opposite(h)}) {
      name(side);
      for (int port = 0; port < 2; ++port) {
        side = mesh_->next(side);
        name(mesh_->opposite(side));
      }
    }
    return mesh_->turn_edge(h);
  }

 private:
  // There is room.
  void name(Halfedge h) {
    if (!mesh_->on_boundary(h)) changed_.push_back(static_cast<std::uint32_t>(mesh_->triangle(h)));
  }

  Mesh* mesh_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace restrip
