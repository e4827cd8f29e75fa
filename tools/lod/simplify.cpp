#include "lod/simplify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/progress.hpp"
#include "lod/coloring_check.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {
namespace {

using KernelMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// OpenMesh's mesh with some members hidden by ours. The decimater is a template and calls them by name. So it never
/// considers an edge that StripMesh refuses, every collapse is done on both meshes and recorded, and no loop runs
/// around a vertex with more than most_neighbors neighbours.
class RecordedMesh : public KernelMesh {
 public:
  using Vertex = restrip::Vertex;  // not OpenMesh's

  RecordedMesh(const Soup& soup, BoundaryPolicy policy)
      : policy_(policy),
        strips_(StripMesh::build(soup.triangles, soup.points.size(), &report_)),
        frozen_(soup.points.size(), 0),
        marked_(soup.points.size(), 0) {
    // A vertex with several fans becomes one vertex for each.
    std::vector<std::uint32_t> fan_of(3 * strips_.triangle_bound(), none);  // by corners 3 t + side
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3; ++side) {
        if (fan_of[3 * t + side] != none) continue;
        const auto fan = static_cast<std::uint32_t>(vertex_.size());
        StripMesh::Halfedge first = StripMesh::halfedge(t, side);
        vertex_.push_back(strips_.from(first));
        const StripMesh::Halfedge start = first;
        while (!StripMesh::on_boundary(strips_.opposite(first))) {
          first = turn_cw(strips_, first);
          if (first == start) break;
        }
        StripMesh::Halfedge h = first;
        do {
          fan_of[3 * StripMesh::triangle(h) + StripMesh::side(h)] = fan;
          h = turn_ccw(strips_, h);
        } while (!(h == first) && !StripMesh::on_boundary(h));
      }
    reserve(vertex_.size(), 3 * strips_.triangle_count() / 2, strips_.triangle_count());
    for (const Vertex v : vertex_) {
      const auto& [x, y, z] = soup.points[v];
      add_vertex(Point(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    }
    std::vector<std::size_t> triangles(vertex_.size(), 0);  // of each fan
    for (const std::uint32_t fan : fan_of) ++triangles[fan];
    if (std::any_of(triangles.begin(), triangles.end(), [](std::size_t n) { return n > most_neighbors; }))
      add_faces_at_once(fan_of);
    else
      add_faces(fan_of);
    neighbors_.reserve(vertex_.size());
    for (const VertexHandle v : vertices()) neighbors_.push_back(KernelMesh::valence(v));
  }

  // ---- called by the decimater
  /// Judges the edges of h's tail one after another; what is known about the tail is cached until the next collapse.
  /// StripMesh performs all of OpenMesh's checks, so OpenMesh need not walk.
  bool is_collapse_ok(HalfedgeHandle h) {
    const VertexHandle tail = from_vertex_handle(h);
    const VertexHandle head = to_vertex_handle(h);
    if (status(edge_handle(h)).deleted() || status(tail).deleted() || status(head).deleted()) return false;
    if (large(tail) || large(head)) return false;
    const Vertex v_t = vertex_[index(tail)];
    const Vertex v_s = vertex_[index(head)];
    if (frozen_[v_s] != 0 || frozen_[v_t] != 0 || strips_.non_manifold(v_s) || strips_.non_manifold(v_t)) return false;
    const StripMesh::Halfedge chord = chord_of(h);
    return check(chord) == Refusal::granted && !is_kept(chord);
  }

  void collapse(HalfedgeHandle h) {
    const StripMesh::Halfedge chord = chord_of(h);
    const HalfedgeHandle back = opposite_halfedge_handle(h);
    unsigned merged = 0;
    bool at_large = false;
    for (const HalfedgeHandle side : {h, back}) {
      if (is_boundary(side)) continue;
      const VertexHandle apex = to_vertex_handle(next_halfedge_handle(side));
      at_large = at_large || large(apex);
      --neighbors_[index(apex)];
      ++merged;
    }
    neighbors_[index(to_vertex_handle(h))] += neighbors_[index(from_vertex_handle(h))] - 2 - merged;
    if (at_large) {
      // KernelMesh::collapse(h), without its turn around each large apex to see whether that lies on the boundary.
      const std::array<HalfedgeHandle, 2> loops{is_boundary(h) ? HalfedgeHandle() : next_halfedge_handle(h),
                                                is_boundary(back) ? HalfedgeHandle() : next_halfedge_handle(back)};
      collapse_edge(h);
      // One of the two edges between the head and each apex is removed; the same one as in KernelMesh::collapse.
      if (loops[0].is_valid()) remove_loop(next_halfedge_handle(loops[0]));
      if (loops[1].is_valid()) remove_loop(loops[1]);
    } else {
      KernelMesh::collapse(h);
    }
    record(chord);
  }

  [[nodiscard]] unsigned valence(VertexHandle v) const { return neighbors_[index(v)]; }

  /// The decimater calls this only for vertices of valence 3, to learn whether they are neighbours.
  [[nodiscard]] HalfedgeHandle find_halfedge(VertexHandle v, VertexHandle w) const {
    return valence(v) == 3 && valence(w) == 3 ? HalfedgeHandle(KernelMesh::find_halfedge(v, w)) : HalfedgeHandle();
  }

  /// The neighbours whose best edge the decimater recomputes after a collapse. A neighbour that has no edge to offer
  /// even with one neighbour less is skipped.
  class VertexVertexIter {
   public:
    VertexVertexIter() = default;
    VertexVertexIter(const RecordedMesh& mesh, const KernelMesh::VertexVertexIter& at) : mesh_(&mesh), at_(at) {
      skip();
    }
    [[nodiscard]] bool is_valid() const { return at_.is_valid(); }
    VertexHandle operator*() const { return *at_; }
    VertexVertexIter& operator++() {
      ++at_;
      skip();
      return *this;
    }

   private:
    void skip() {
      while (at_.is_valid() && mesh_->valence(*at_) > most_neighbors + 1) ++at_;
    }
    const RecordedMesh* mesh_ = nullptr;
    KernelMesh::VertexVertexIter at_;
  };
  VertexVertexIter vv_iter(VertexHandle v) { return {*this, KernelMesh::vv_iter(v)}; }

  Progress* progress = nullptr;

  // ---- called when the decimater has no more edges
  /// Collapses what is legal, the shortest edge of a vertex first, until the wanted size is reached or no edge is
  /// legal. The decimater does not return to an edge that was illegal at its turn unless a neighbour collapses. It also
  /// never takes some edges that lead to good meshes, such as one in a fan of three. From here on, OpenMesh's mesh is
  /// out of date.
  void collapse_what_is_left(const std::vector<restrip::tools::Point>& points, std::size_t wanted_triangles) {
    count_triangles_around();
    std::vector<Vertex> waiting;
    std::vector<bool> waits(strips_.vertex_bound(), false);
    const auto wait = [&](Vertex v) {
      if (!waits[v] && strips_.spoke(v).id != none) waiting.push_back(v);
      waits[v] = true;
    };
    for (Vertex v = 0; v < strips_.vertex_bound(); ++v) wait(v);
    for (std::size_t next = 0; next < waiting.size() && strips_.triangle_count() > wanted_triangles; ++next) {
      const Vertex v_t = waiting[next];
      waits[v_t] = false;
      if (strips_.spoke(v_t).id == none || strips_.non_manifold(v_t) || is_crowded(v_t)) continue;
      // The chord of the shortest edge by which v_t may be removed. A boundary vertex stays on the boundary.
      StripMesh::Halfedge best;
      double least = 0;
      for_each_spoke(strips_, v_t, [&](StripMesh::Halfedge h) {
        const StripMesh::Halfedge chord = strips_.opposite(h);
        if (strips_.non_manifold(strips_.to(h)) || is_crowded(strips_.to(h)) || is_kept(chord)) return;
        if (strips_.leaves_boundary(h) && !strips_.leaves_boundary(chord)) return;
        const auto& from = points[v_t];
        const auto& to = points[strips_.to(h)];
        const double length = std::hypot(from.x - to.x, from.y - to.y, from.z - to.z);
        if ((best.id != none && !(length < least)) || check(chord) != Refusal::granted) return;
        best = chord;
        least = length;
      });
      if (best.id == none) continue;
      const Vertex v_s = strips_.from(best);
      record(best);
      wait(v_s);
      for_each_spoke(strips_, v_s, [&](StripMesh::Halfedge h) { wait(strips_.to(h)); });
    }
  }
  /// For each remaining edge, why it cannot collapse.
  [[nodiscard]] std::vector<Obstacle> obstacles() {
    count_triangles_around();
    std::vector<Obstacle> found;
    const auto note = [&found](const std::string& why) {
      const auto same = std::find_if(found.begin(), found.end(), [&](const Obstacle& one) { return one.why == why; });
      ++(same == found.end() ? found.emplace_back(Obstacle{why}) : *same).edges;
    };
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3 && strips_.alive(t); ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
        if (h.id > strips_.opposite(h).id) continue;  // met from the other side
        if (strips_.non_manifold(strips_.from(h)) || strips_.non_manifold(strips_.to(h)))
          note(describe(Refusal::non_manifold_vertex));
        else if (is_crowded(strips_.from(h)) || is_crowded(strips_.to(h)))
          note(fmt::format("a vertex has more than {} neighbours", most_neighbors));
        else if (is_kept(h))
          note("the boundary is locked");
        else
          note(describe(check(h)));
      }
    std::stable_sort(found.begin(), found.end(),
                     [](const Obstacle& a, const Obstacle& b) { return a.edges > b.edges; });
    return found;
  }

  // ---- results
  [[nodiscard]] const StripMesh& strips() const noexcept { return strips_; }
  [[nodiscard]] const BuildReport& report() const noexcept { return report_; }
  [[nodiscard]] const std::vector<Record>& collapses() const noexcept { return collapses_; }
  [[nodiscard]] std::size_t large_vertices() const {
    return static_cast<std::size_t>(
        std::count_if(vertices_sbegin(), vertices_end(), [this](VertexHandle v) { return large(v); }));
  }
  [[nodiscard]] std::size_t frozen_vertices() const {
    std::size_t n = 0;
    for (Vertex v = 0; v < frozen_.size(); ++v)
      n += static_cast<std::size_t>(frozen_[v] != 0 && !strips_.non_manifold(v));
    return n;
  }

 private:
  static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

  [[nodiscard]] VertexHandle vertex_at(const std::vector<std::uint32_t>& fan_of, StripMesh::Halfedge h) const {
    return VertexHandle(static_cast<int>(fan_of[3 * StripMesh::triangle(h) + StripMesh::side(h)]));
  }

  void add_faces(const std::vector<std::uint32_t>& fan_of) {
    // OpenMesh prints each face that it cannot hold; we count them.
    omerr().disable();
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t) {
      const auto corner = [&](unsigned side) { return vertex_at(fan_of, StripMesh::halfedge(t, side)); };
      if (add_face(corner(0), corner(1), corner(2)).is_valid()) continue;
      for (const Vertex v : strips_.corners(t)) frozen_[v] = 1;
    }
    omerr().enable();
  }

  /// Adds all faces at once. add_face would turn around each corner to find the edges there, which are known here. Each
  /// vertex here is one fan, so every face can be held.
  void add_faces_at_once(const std::vector<std::uint32_t>& fan_of) {
    std::vector<HalfedgeHandle> ours(3 * strips_.triangle_bound());
    const auto of = [&ours](StripMesh::Halfedge h) -> HalfedgeHandle& {
      return ours[3 * StripMesh::triangle(h) + StripMesh::side(h)];
    };
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t) {
      const FaceHandle face = new_face();
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
        const StripMesh::Halfedge back = strips_.opposite(h);
        const bool known = !StripMesh::on_boundary(back) && of(back).is_valid();
        of(h) = known ? opposite_halfedge_handle(of(back))
                      : new_edge(vertex_at(fan_of, h), vertex_at(fan_of, StripMesh::next(h)));
        set_face_handle(of(h), face);
      }
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
        set_next_halfedge_handle(of(h), of(StripMesh::next(h)));
      }
      set_halfedge_handle(face, of(StripMesh::halfedge(t, 2)));
    }
    // A boundary vertex starts with the one boundary halfedge that leaves it.
    for (const HalfedgeHandle h : ours) {
      if (!halfedge_handle(from_vertex_handle(h)).is_valid()) set_halfedge_handle(from_vertex_handle(h), h);
      const HalfedgeHandle back = opposite_halfedge_handle(h);
      if (is_boundary(back)) set_halfedge_handle(from_vertex_handle(back), back);
    }
    for (const HalfedgeHandle h : ours) {
      const HalfedgeHandle back = opposite_halfedge_handle(h);
      if (is_boundary(back)) set_next_halfedge_handle(back, halfedge_handle(to_vertex_handle(back)));
    }
  }

  [[nodiscard]] bool large(VertexHandle v) const { return valence(v) > most_neighbors; }

  // ---- the mesh that is recorded
  void record(StripMesh::Halfedge chord) {
    const Vertex v_s = strips_.from(chord);
    const Vertex v_t = strips_.to(chord);
    const auto apex = [&](StripMesh::Halfedge side) {
      return StripMesh::on_boundary(side) ? none : strips_.to(StripMesh::next(side));
    };
    const Record& made = collapses_.emplace_back(Record{v_s, v_t, apex(chord), apex(strips_.opposite(chord))});
    if (!around_.empty()) {
      around_[v_s] += around_[v_t];
      for (const Vertex v : {made.v_l, made.v_r}) {
        if (v == none) continue;
        --around_[v];
        around_[v_s] -= 2;
      }
    }
    strips_.remove_vertex(chord);
    marked_tail_ = none;
    if (progress != nullptr) progress->at(collapses_.size());
  }
  /// Whether the boundary policy protects the edge.
  [[nodiscard]] bool is_kept(StripMesh::Halfedge chord) const {
    return policy_ == BoundaryPolicy::lock &&
           (strips_.leaves_boundary(chord) || strips_.leaves_boundary(strips_.opposite(chord)));
  }
  [[nodiscard]] Refusal check(StripMesh::Halfedge chord) {
    const auto share_neighbor = [this](Vertex head, Vertex tail, Vertex v_l, Vertex v_r) {
      if (tail != marked_tail_) {  // marks its neighbours once, for all its edges
        marked_tail_ = tail;
        ++mark_;
        for_each_spoke(strips_, tail, [this](StripMesh::Halfedge h) { marked_[strips_.to(h)] = mark_; });
      }
      bool shared = false;
      for_each_spoke(strips_, head, [&](StripMesh::Halfedge h) {
        const Vertex w = strips_.to(h);
        shared = shared || (marked_[w] == mark_ && w != v_l && w != v_r);
      });
      return shared;
    };
    return restrip::detail::check_collapse_with(strips_, chord, share_neighbor);
  }
  void count_triangles_around() {
    around_.assign(strips_.vertex_bound(), 0);
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t)
      if (strips_.alive(t))
        for (const Vertex v : strips_.corners(t)) ++around_[v];
  }
  [[nodiscard]] bool is_crowded(Vertex v) const { return around_[v] > most_neighbors; }

  /// The halfedge of our mesh from h's head to its tail, searched for around the end with fewer neighbours.
  StripMesh::Halfedge chord_of(HalfedgeHandle h) {
    const VertexHandle tail = from_vertex_handle(h);
    const VertexHandle head = to_vertex_handle(h);
    const Vertex v_t = vertex_[index(tail)];
    const Vertex v_s = vertex_[index(head)];
    if (valence(head) <= valence(tail)) return strips_.spoke(v_s, v_t);
    const StripMesh::Halfedge back = strips_.spoke(v_t, v_s);
    return back.id == none ? back : strips_.opposite(back);
  }

  /// KernelMesh::collapse_loop. `gone` and the halfedge after it bound a face of two corners.
  void remove_loop(HalfedgeHandle gone) {
    const HalfedgeHandle stays = next_halfedge_handle(gone);
    const HalfedgeHandle outside = opposite_halfedge_handle(gone);
    const FaceHandle inside_face = face_handle(gone);
    const FaceHandle outside_face = face_handle(outside);
    const auto keep_first = [&](VertexHandle v, HalfedgeHandle leaves) {
      // A boundary halfedge that leaves v is already its first one, unless it is being removed.
      const HalfedgeHandle first = halfedge_handle(v);
      if (first == outside || !is_boundary(first)) set_halfedge_handle(v, leaves);
    };
    set_next_halfedge_handle(stays, next_halfedge_handle(outside));
    set_next_halfedge_handle(prev_halfedge_handle(outside), stays);
    set_face_handle(stays, outside_face);
    keep_first(to_vertex_handle(gone), stays);
    keep_first(to_vertex_handle(stays), opposite_halfedge_handle(stays));
    if (outside_face.is_valid() && halfedge_handle(outside_face) == outside) set_halfedge_handle(outside_face, stays);
    status(edge_handle(gone)).set_deleted(true);
    status(inside_face).set_deleted(true);
  }

  BoundaryPolicy policy_;
  BuildReport report_;
  StripMesh strips_;
  std::vector<std::uint8_t> frozen_;
  std::vector<Vertex> vertex_;       // the soup's vertex of each OpenMesh vertex
  std::vector<unsigned> neighbors_;  // of each OpenMesh vertex
  // This marks the soup's vertices around the tail whose edges are being judged.
  std::vector<std::uint64_t> marked_;
  std::uint64_t mark_ = 0;
  Vertex marked_tail_ = none;
  std::vector<std::size_t> around_;  // triangles at each vertex; empty while OpenMesh is up to date
  std::vector<Record> collapses_;
};

}  // namespace

std::string why_no_coarser(const LeftOut& left_out) {
  std::size_t edges = 0;
  std::vector<std::string> reasons;
  for (const Obstacle& obstacle : left_out.obstacles) {
    edges += obstacle.edges;
    reasons.push_back(fmt::format("{}: {}", obstacle.edges, obstacle.why));
  }
  return fmt::format("none of the {} edges that are left may collapse ({})", edges, fmt::join(reasons, "; "));
}

Simplification simplify(const Soup& soup, const SimplifyOptions& options) {
  RecordedMesh mesh(soup, options.boundary);
  Simplification result;
  result.left_out = {mesh.report().degenerate_triangles, mesh.report().non_manifold_vertices, mesh.frozen_vertices(),
                     0};
  const std::size_t triangles = mesh.strips().triangle_count();
  result.wanted_triangles = options.triangles != 0
                                ? std::min(options.triangles, triangles)
                                : static_cast<std::size_t>(std::ceil(options.base * static_cast<double>(triangles)));

  if (result.wanted_triangles < triangles) {
    Progress progress("simplifying", (triangles - result.wanted_triangles) / 2);
    mesh.progress = &progress;
    OpenMesh::Decimater::DecimaterT<RecordedMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<RecordedMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.initialize();
    // OpenMesh may hold fewer faces than StripMesh.
    const std::size_t missing = triangles - mesh.n_faces();
    decimater.decimate_to_faces(0, result.wanted_triangles - std::min(missing, result.wanted_triangles));
    mesh.progress = nullptr;
  }
  result.left_out.large_vertices = mesh.large_vertices();
  if (mesh.strips().triangle_count() > result.wanted_triangles)
    mesh.collapse_what_is_left(soup.points, result.wanted_triangles);
  if (mesh.strips().triangle_count() > result.wanted_triangles) result.left_out.obstacles = mesh.obstacles();

  result.mesh.points = soup.points;
  result.mesh.base = triangles_of(mesh.strips());
  result.mesh.splits.assign(mesh.collapses().rbegin(), mesh.collapses().rend());
  return result;
}

}  // namespace restrip::tools
