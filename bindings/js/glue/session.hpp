// Session: a LiveMesh for JavaScript, with the vertex splits that lead from the base of a progressive mesh to the fine
// one, its *records*, and counts. exports.cpp exports it. Points, the set of played records and the frame in which
// single operations began are JavaScript's (restrip.mjs).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#ifdef __wasm__
namespace restrip::web {
/// Why the module has stopped. A refused input ends the call by a trap, which JavaScript sees.
inline const char* stopped_because = nullptr;
}  // namespace restrip::web
#define RESTRIP_THROW(exception, sentence) (restrip::web::stopped_because = (sentence), __builtin_trap())
#endif
#include "restrip/restrip.hpp"

namespace restrip::web {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using Corners = std::array<Vertex, 3>;
using Record = SplitRecord;
static_assert(sizeof(Corners) == 12 && sizeof(Record) == 16, "JavaScript passes these as numbers of 32 bits");

struct Progressive {
  std::vector<Corners> base;
  std::vector<Record> splits;
  std::size_t points = 0;

  [[nodiscard]] std::size_t fine_triangles() const noexcept {
    std::size_t n = base.size();
    for (const Record& r : splits) n += r.triangles();
    return n;
  }
};

[[nodiscard]] inline std::vector<Corners> triangles_of(const StripMesh& mesh) {
  std::vector<Corners> corners;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) corners.push_back(mesh.corners(t));
  return corners;
}

/// The spokes of a split, found by its vertices; missing spokes are {none}, and check_split refuses them.
[[nodiscard]] inline Where find_spokes(const StripMesh& mesh, const Record& r) {
  return r.v_s < mesh.vertex_bound() ? spokes_of(mesh, r) : Where{};
}

/// A patch as it is, numbered as in docs/reference/notation.md. `closed`: the fan is closed and fits a word, so that k,
/// a and the colours are known.
struct PatchColors {
  bool closed = false;
  std::uint32_t k = 0;
  std::uint32_t a = 0;
  Word edges = 0;  ///< loop edges of a fan, inner edges of a ring
  Word ports = 0;

  /// Adds the triangles counter-clockwise from one spoke to another, with the dual edge after each.
  bool add(const StripMesh& mesh, Halfedge from, Halfedge to, std::size_t& edge) {
    for (Halfedge h = from; h != to; ++k, ++edge) {
      if (StripMesh::on_boundary(h) || k == max_word_valence) return false;
      const auto step = mesh.fan_step(h);
      if (step.port) ports |= bit(k);
      if (step.edge) edges |= bit(edge);
      h = step.spoke;
    }
    return true;
  }
};

/// The fan of a vertex, numbered from `left`: t_0 is the triangle to its left.
[[nodiscard]] inline PatchColors fan_colors(const StripMesh& mesh, Halfedge left, Halfedge right) {
  PatchColors out;
  std::size_t edge = 0;
  out.closed = out.add(mesh, left, right, edge);
  out.a = out.k;
  out.closed = out.closed && out.add(mesh, right, left, edge);
  return out;
}

/// The ring with chord around the edge v_s -> v_t of `chord`.
[[nodiscard]] inline PatchColors ring_colors(const StripMesh& mesh, Halfedge chord) {
  PatchColors out;
  const Halfedge back = mesh.opposite(chord);
  if (mesh.leaves_boundary(chord) || mesh.leaves_boundary(back)) return out;
  std::size_t edge = 0;
  out.closed = true;
  for (const Halfedge start : {chord, back}) {
    const Halfedge first = turn_ccw(mesh, start);
    if (mesh.solid(first)) out.edges |= bit(edge);
    ++edge;
    out.closed = out.closed && out.add(mesh, first, turn_cw(mesh, start), edge);
    if (start == chord) out.a = out.k;
  }
  if (out.closed && mesh.solid(chord)) out.edges |= bit(edge);
  return out;
}

/// Counts since begin(), undone operations included, and of the present mesh. JavaScript reads the fields in this
/// order.
struct Figures {
  std::uint32_t triangles = 0;
  std::uint32_t strips = 0;
  std::uint32_t buffer_indices = 0;  ///< to be drawn, gaps included; `none`: the buffer is behind the mesh
  std::uint32_t operations = 0;
  std::uint32_t adding_strip = 0;  ///< operations that added strips
  std::uint32_t isolating = 0;     ///< operations that added an isolated triangle
  std::uint32_t baked = 0;         ///< 1: the strips are baked strips, at a baked level
  std::int32_t last_strips = 0;    ///< added by the last operation
  std::int32_t last_isolated = 0;
};

class Session {
 public:
  /// Plays all records once; refused_record() is the first that the mesh refuses. `report`, if given: on the base.
  explicit Session(Progressive source, BuildReport* report = nullptr) : source_(std::move(source)) {
    StripMesh mesh = StripMesh::build(source_.base, source_.points, report);
    mesh.reserve(source_.fine_triangles(), source_.points);
    std::vector<std::uint32_t> last(source_.fine_triangles(), none);  // by triangle: the last record it was part of
    std::vector<Triangle> patch;
    for (std::uint32_t i = 0; i < source_.splits.size(); ++i) {
      const Where where = find_spokes(mesh, source_.splits[i]);
      const Vertex v_t = source_.splits[i].v_t;
      if (v_t >= source_.points || check_split(mesh, where, v_t) != Refusal::granted) {
        refused_record_ = i;
        source_.splits.resize(i);
        break;
      }
      fan_triangles(mesh, where.spokes == Where::Spokes::right_only ? where.right : where.left, patch);
      const auto begin = static_cast<std::ptrdiff_t>(needs_.size());
      for (const Triangle t : patch)
        if (last[t] != none) needs_.push_back(last[t]);
      std::sort(needs_.begin() + begin, needs_.end());
      needs_.erase(std::unique(needs_.begin() + begin, needs_.end()), needs_.end());
      first_need_.push_back(static_cast<std::uint32_t>(needs_.size()));
      edge_triangles(mesh, mesh.insert_vertex(where, v_t), patch);
      for (const Triangle t : patch) last[t] = i;
    }
  }
  Session(BakedFile file, BuildReport* report) : Session({file.base, file.splits, file.points.size()}, report) {
    file_ = std::make_shared<const BakedFile>(std::move(file));
  }
  /// Continues a mesh that was saved, without records.
  explicit Session(LiveMesh live) : live_(std::move(live)) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] std::size_t refused_record() const noexcept { return refused_record_; }
  [[nodiscard]] const BakedFile* file() const noexcept { return file_.get(); }
  [[nodiscard]] const Progressive& source() const noexcept { return source_; }
  /// Two records whose fans share a triangle keep their order, all others commute. These are the earlier records that
  /// each one needs: of record i from first_need()[i] on, up to the one of the next.
  [[nodiscard]] std::span<const std::uint32_t> needs() const noexcept { return needs_; }
  [[nodiscard]] std::span<const std::uint32_t> first_need() const noexcept { return first_need_; }
  /// After begin().
  [[nodiscard]] LiveMesh& live() noexcept { return *live_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return live_->mesh(); }

  /// Goes to the base, with its baked strips or with strips from scratch. Without records the base is the present mesh,
  /// of this many vertices.
  void begin(const LiveOptions& options, bool baked, std::size_t vertices) {
    if (live_ && source_.splits.empty() && !file_) {
      source_.base = triangles_of(mesh());
      source_.points = vertices;
    }
    live_.reset();  // its memory serves the next
    if (baked)
      live_.emplace(file_, options);
    else
      live_.emplace(source_.base, source_.points, options);
    live_->reserve(source_.fine_triangles(), source_.points);
    figures_ = {};
  }
  /// Splits each of the records, or undoes it if it is split.
  void play(std::span<const std::uint32_t> records) {
    Keeper& keeper = live_->keeper();
    for (const std::uint32_t i : records) {
      const Record& r = source_.splits[i];
      const bool in_step = live_->level().has_value();
      if (is_split(i)) {
        const Halfedge chord = mesh().spoke(r.v_s, r.v_t);
        count(in_step ? keeper.collapse_record(i, chord) : keeper.collapse(chord));
      } else {
        const Where where = spokes_of(mesh(), r);
        count(in_step ? keeper.split_record(i, where, r.v_t) : keeper.split(where, r.v_t));
      }
    }
  }
  /// Unless single operations have changed the mesh.
  [[nodiscard]] bool is_split(std::size_t record) const noexcept {
    const Vertex v_t = source_.splits[record].v_t;  // which no other record adds
    return v_t < mesh().vertex_bound() && mesh().spoke(v_t).id != none;
  }

  /// Single operations, by vertices.
  Refusal split(const Record& r) { return counted(live_->split(find_spokes(mesh(), r), r.v_t)); }
  Refusal collapse(Vertex v_s, Vertex v_t) { return counted(live_->collapse(live_->edge(v_s, v_t))); }
  Refusal flip(Vertex u, Vertex v) { return counted(live_->flip(live_->edge(u, v))); }
  Refusal bisect(Vertex u, Vertex v) { return counted(live_->bisect(live_->edge(u, v))); }
  Refusal split_face(Vertex a, Vertex b, Vertex c) {
    return counted(live_->split_face(apex(a, b) == c ? live_->edge(a, b) : Halfedge{}));
  }
  /// Of the last operation that was granted.
  [[nodiscard]] Vertex new_vertex() const noexcept { return new_vertex_; }
  /// The third corner of the triangle that has the side from u to v, counter-clockwise; `none` if it does not exist.
  [[nodiscard]] Vertex apex(Vertex u, Vertex v) const noexcept {
    const Halfedge h = live_->edge(u, v);
    return h.id == none || StripMesh::on_boundary(h) ? none : mesh().to(StripMesh::next(h));
  }

  [[nodiscard]] const Figures& figures() {
    const std::size_t size = live_->buffer().size();
    const bool list = live_->buffer().format().form == StripForm::list;  // whose padding is not drawn
    figures_.triangles = static_cast<std::uint32_t>(mesh().triangle_count());
    figures_.strips = static_cast<std::uint32_t>(live_->strips());
    figures_.baked = live_->level() ? 1 : 0;
    figures_.buffer_indices = live_->changed().empty() ? static_cast<std::uint32_t>(list ? size / 3 * 3 : size) : none;
    return figures_;
  }

 private:
  Refusal counted(const Checked& done) {
    if (done) count(done.rewrite), new_vertex_ = done.new_vertex();
    return done.refusal;
  }
  void count(const Rewrite& done) {
    ++figures_.operations;
    if (done.strips > 0) ++figures_.adding_strip;
    if (done.isolated > 0) ++figures_.isolating;
    figures_.last_strips = done.strips;
    figures_.last_isolated = done.isolated;
  }

  Progressive source_;
  std::vector<std::uint32_t> first_need_{0};
  std::vector<std::uint32_t> needs_;
  std::shared_ptr<const BakedFile> file_;  // of a baked mesh
  std::size_t refused_record_ = none;
  std::optional<LiveMesh> live_;
  Vertex new_vertex_ = none;
  Figures figures_;
};

}  // namespace restrip::web
