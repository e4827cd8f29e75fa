// Session: one progressive mesh whose strips are maintained under a policy, with the index buffer that draws them. The
// page and the npm package drive it; exports.cpp exports it to JavaScript.
#pragma once

#include <memory>
#include <optional>

#include "progressive.hpp"

namespace restrip::web {

/// The colours of a patch. `closed`: the fan is closed and fits a word, so that k, a and the colours are known.
struct PatchColors {
  bool closed = false;
  std::uint32_t k = 0;
  std::uint32_t a = 0;
  Word edges = 0;  ///< loop edges of a fan, inner edges of a ring
  Word ports = 0;
};

/// The fan of a vertex, numbered from `left`: t_0 is the triangle to its left.
[[nodiscard]] inline PatchColors fan_colors(const StripMesh& mesh, Halfedge left, Halfedge right) {
  PatchColors out;
  Halfedge h = left;
  do {
    if (StripMesh::on_boundary(h) || out.k == max_word_valence) return {};
    const auto step = mesh.fan_step(h);
    if (step.port) out.ports |= bit(out.k);
    if (step.edge) out.edges |= bit(out.k);
    ++out.k;
    h = step.spoke;
    if (h == right) out.a = out.k;
  } while (!(h == left));
  out.closed = true;
  return out;
}

/// The ring with chord around the edge v_s -> v_t of `chord`.
[[nodiscard]] inline PatchColors ring_colors(const StripMesh& mesh, Halfedge chord) {
  PatchColors out;
  const Halfedge back = mesh.opposite(chord);
  if (StripMesh::on_boundary(chord) || StripMesh::on_boundary(back)) return {};
  std::size_t edge = 0;
  for (const Halfedge start : {chord, back}) {
    Halfedge h = turn_ccw(mesh, start);
    while (true) {
      if (StripMesh::on_boundary(h) || out.k == max_word_valence) return {};
      if (mesh.solid(h)) out.edges |= bit(edge);
      ++edge;
      const auto step = mesh.fan_step(h);
      if (step.spoke == start) break;
      if (step.port) out.ports |= bit(out.k);
      ++out.k;
      h = step.spoke;
    }
    if (start == chord) out.a = out.k;
  }
  if (mesh.solid(chord)) out.edges |= bit(edge);
  out.closed = true;
  return out;
}

/// A description of the last operation: its patch before and after, numbered as in docs/reference/notation.md.
struct LastOperation {
  enum class Kind : std::uint32_t { nothing, split, collapse, flip };
  Kind kind = Kind::nothing;
  PatchColors before;
  PatchColors after;
  int strips = 0;
  int isolated = 0;
  std::vector<Corners> triangles_before;
  std::vector<Corners> triangles_after;
};

/// Counts cover the whole session since begin(), except for counts of the present mesh. JavaScript reads the fields in
/// this order.
struct Figures {
  std::uint32_t triangles = 0;
  std::uint32_t strips = 0;
  std::uint32_t played = 0;          ///< records that are split now
  std::uint32_t in_order = 0;        ///< 1: these are the first `played` records
  std::uint32_t buffer_indices = 0;  ///< to be drawn, gaps included; `none`: the buffer is behind the mesh
  std::uint32_t operations = 0;
  std::uint32_t adding_strip = 0;  ///< operations that added strips
  std::uint32_t isolating = 0;     ///< operations that added an isolated triangle
  std::uint32_t refused = 0;       ///< operations that the mesh refused
  std::uint32_t indices_written = 0;
  std::uint32_t updates = 0;
  std::uint32_t baked = 0;  ///< 1: the strips are baked strips, at a baked level
};

class Session {
 public:
  /// `points`: three coordinates a vertex. Plays all records once; refused_record() is the first that the mesh refuses.
  /// `report`, if given: on the base.
  Session(Progressive source, std::vector<float> points, BuildReport* report = nullptr)
      : source_(std::move(source)), points_(std::move(points)) {
    StripMesh mesh = StripMesh::build(source_.base, source_.points, report);
    mesh.reserve(source_.fine_triangles(), source_.points);
    std::vector<std::uint32_t> last(source_.fine_triangles(),
                                    none);  // by triangle: the record that it was last part of
    for (std::uint32_t i = 0; i < source_.splits.size(); ++i) {
      const Where where = find_spokes(mesh, source_.splits[i]);
      const Vertex v_t = source_.splits[i].v_t;
      if (v_t >= source_.points || check_split(mesh, where, v_t) != Refusal::granted) {
        refused_record_ = i;
        source_.splits.resize(i);
        break;
      }
      fan_triangles(mesh, where.spokes == Where::Spokes::right_only ? where.right : where.left, patch_);
      const std::size_t begin = needs_.size();
      for (const Triangle t : patch_)
        if (last[t] != none) needs_.push_back(last[t]);
      std::sort(needs_.begin() + static_cast<std::ptrdiff_t>(begin), needs_.end());
      needs_.erase(std::unique(needs_.begin() + static_cast<std::ptrdiff_t>(begin), needs_.end()), needs_.end());
      first_need_.push_back(static_cast<std::uint32_t>(needs_.size()));
      edge_triangles(mesh, mesh.insert_vertex(where, v_t), patch_);
      for (const Triangle t : patch_) last[t] = i;
    }
    dependents_.resize(source_.splits.size());
    played_.resize(source_.splits.size());
  }
  Session(BakedFile file, BuildReport* report)
      : Session({file.base, file.splits, file.points.size()}, coordinates_of(file), report) {
    file_ = std::move(file);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] std::size_t refused_record() const noexcept { return refused_record_; }
  [[nodiscard]] bool has_baked_strips() const noexcept { return file_.has_value(); }
  [[nodiscard]] const Progressive& source() const noexcept { return source_; }
  [[nodiscard]] std::span<const float> points() const noexcept { return points_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const LastOperation& last() const noexcept { return last_; }

  /// Goes to the base and gives it strips from scratch, as `restrip replay` does. Without records, single operations
  /// stay. `format`: of the buffer; limits of batches are not supported.
  void begin(Policy policy, Cost cost, const StripFormat& format) {
    if (checked_ && source_.splits.empty() && !file_) {
      source_.base.clear();
      for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
        if (mesh_.alive(t)) source_.base.push_back(mesh_.corners(t));
      source_.points = points_.size() / 3;
    }
    begin_with(StripMesh::build(source_.base, source_.points));
    stripify(mesh_, default_effort, cost);
    keeper_.emplace(mesh_, policy, cost);
    begin_buffer(format);
  }
  /// Begins with the baked strips of the base, if any.
  void begin_baked(const StripFormat& format) {
    if (!file_) return;
    begin_with(file_->mesh);
    keeper_.emplace(mesh_, file_->records);
    begin_buffer(format);
  }

  /// Moves towards the level at which the first `level` records are played: undoes later records, the last one first,
  /// then plays missing ones in order. At most `most` operations; returns the number done.
  std::size_t move(std::size_t level, std::size_t most) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < played_.size(); ++i) left += (played_[i] != 0) != (i < level) ? 1U : 0U;
    left = std::min(left, most);
    std::size_t done = 0;
    for (std::size_t i = played_.size(); i-- > level && done < most;) {
      if (played_[i] == 0) continue;
      tell_ = done + 1 == left;
      if (take_back(i)) ++done;
    }
    for (std::size_t i = 0; i < level && i < played_.size() && done < most; ++i) {
      if (played_[i] != 0) continue;
      tell_ = done + 1 == left;
      if (play(i)) ++done;
    }
    tell_ = true;
    return done;
  }

  /// Moves towards the set of records that `wanted` names, one byte each, and the records that they need: undoes all
  /// others, then plays the missing ones. At most `most` operations; returns the number done. Calls with a small `most`
  /// arrive as well, because no record of the set is undone. Records need earlier records only.
  std::size_t approach(std::span<const std::uint8_t> wanted, std::size_t most) {
    wanted_.assign(wanted.begin(), wanted.end());
    for (std::size_t i = played_.size(); i-- > 0;)
      if (wanted_[i] != 0)
        for (const std::uint32_t need : needs(i)) wanted_[need] = 1;
    std::size_t done = 0;
    for (std::size_t i = played_.size(); i-- > 0 && done < most;)
      if (played_[i] != 0 && wanted_[i] == 0 && dependents_[i] == 0 && take_back(i)) ++done;
    for (std::size_t i = 0; i < played_.size() && done < most; ++i)
      if (played_[i] == 0 && wanted_[i] != 0 && play(i)) ++done;
    return done;
  }

  /// The records that can be split now: not split yet, and needing no other. Linear in the records.
  std::span<const std::uint32_t> ready() {
    ready_.clear();
    for (std::uint32_t i = 0; i < played_.size(); ++i) {
      const auto needed = needs(i);
      if (played_[i] == 0 &&
          std::all_of(needed.begin(), needed.end(), [&](std::uint32_t n) { return played_[n] != 0; }))
        ready_.push_back(i);
    }
    return ready_;
  }

  // ---- single operations, by vertices. From then on records are checked before they are played.
  Refusal split(const Record& r) {
    const Where where = find_spokes(mesh_, r);
    const Refusal refusal = check_split(mesh_, where, r.v_t);
    if (refusal == Refusal::granted) leave_records(), do_split(where, r.v_t);
    return refusal;
  }
  Refusal collapse(Vertex v_s, Vertex v_t) {
    const Halfedge chord = find_edge(mesh_, v_s, v_t);
    const Refusal refusal = check_collapse(mesh_, chord);
    if (refusal == Refusal::granted) leave_records(), do_collapse(chord);
    return refusal;
  }
  Refusal flip(Vertex u, Vertex v) {
    const Halfedge h = find_edge(mesh_, u, v);
    const Refusal refusal = check_flip(mesh_, h);
    if (refusal != Refusal::granted) return refusal;
    leave_records();
    const auto quad = [this](Halfedge g, std::vector<Corners>& out) {
      out = {mesh_.corners(StripMesh::triangle(g)), mesh_.corners(StripMesh::triangle(mesh_.opposite(g)))};
    };
    last_.kind = LastOperation::Kind::flip;
    last_.before = last_.after = {};
    quad(h, last_.triangles_before);
    const auto done = keeper_->flip(h);
    quad(done.halfedge, last_.triangles_after);
    count(done);
    return refusal;
  }

  /// A new vertex on the edge of u and v, or in the triangle of the three. Its number is new_vertex(); its point is in
  /// the middle.
  Refusal bisect(Vertex u, Vertex v) {
    const Halfedge h = find_edge(mesh_, u, v);
    return refine(check_bisect(mesh_, h), {u, v}, [&] { return keeper_->bisect(h); });
  }
  Refusal split_face(Vertex a, Vertex b, Vertex c) {
    Halfedge h = find_edge(mesh_, a, b);
    if (h.id != none && (StripMesh::on_boundary(h) || mesh_.to(StripMesh::next(h)) != c)) h = {};
    return refine(check_split_face(mesh_, h), {a, b, c}, [&] { return keeper_->split_face(h); });
  }
  [[nodiscard]] Vertex new_vertex() const noexcept { return new_vertex_; }

  /// Brings the buffer in step and returns the ranges to upload.
  std::span<const IndexRange> update(const RangeOptions& options) {
    ++figures_.updates;
    const Upload upload = buffer_.update(mesh_, changed_, options);
    changed_.clear();
    given_.assign(upload.begin(), upload.end());
    const bool first = std::exchange(begun_, false);
    if (!first)
      for (const IndexRange& range : given_) figures_.indices_written += static_cast<std::uint32_t>(range.count);
    outgrown_ = upload.outgrown || first;
    return given_;
  }
  [[nodiscard]] const LiveBuffer& buffer() const noexcept { return buffer_; }
  /// Whether the buffer had outgrown its room at the last update.
  [[nodiscard]] bool outgrown() const noexcept { return outgrown_; }
  /// Whether single operations have changed the mesh, so that records no longer fit.
  [[nodiscard]] bool left_records() const noexcept { return checked_; }

  // ---- vertices
  /// A new vertex, to be named by a split or a bisection. Returns its number.
  Vertex add_point(const std::array<float, 3>& point) {
    points_.insert(points_.end(), point.begin(), point.end());
    return static_cast<Vertex>(points_.size() / 3 - 1);
  }
  void set_point(Vertex v, const std::array<float, 3>& point) {
    std::copy(point.begin(), point.end(), points_.begin() + std::ptrdiff_t{3} * static_cast<std::ptrdiff_t>(v));
  }

  // ---- alternatives to compare maintained strips with
  /// In place of update(): a triangle list, written whole or with a slot for each triangle.
  std::span<const IndexRange> update_list(bool whole) {
    if (whole) {
      list_.rebuild(mesh_);
      given_ = {{0, list_.indices().size()}};
    } else {
      const auto ranges = list_.update(mesh_, changed_);
      given_.assign(ranges.begin(), ranges.end());
    }
    changed_.clear();
    return given_;
  }
  [[nodiscard]] std::span<const std::uint32_t> list() const noexcept { return list_.indices(); }
  /// The index buffer of strips made from scratch by the fastest way, for the present mesh, whose strips do not change.
  std::span<const std::uint32_t> from_scratch(Cost cost, const VertexCache& cache) {
    scratch_ = mesh_;
    stripify(scratch_, Effort::fast, cost);
    scratch_indices_ =
        cache.size == 0 ? strip_indices(scratch_) : strip_indices(scratch_, strips_for_vertex_cache(scratch_, cache));
    return scratch_indices_;
  }
  [[nodiscard]] const StripMesh& scratch() const noexcept { return scratch_; }

  [[nodiscard]] const Figures& figures() {
    figures_.triangles = static_cast<std::uint32_t>(mesh_.triangle_count());
    figures_.strips = static_cast<std::uint32_t>(keeper_->strips());
    std::size_t played = 0;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < played_.size(); ++i)
      if (played_[i] != 0) ++played, beyond = i + 1;
    figures_.played = static_cast<std::uint32_t>(played);
    figures_.in_order = played == beyond ? 1 : 0;
    figures_.baked = keeper_->baked() != nullptr && keeper_->baked()->in_step() ? 1 : 0;
    const bool list = buffer_.format().form == StripForm::list;  // whose padding is not drawn
    figures_.buffer_indices =
        changed_.empty() ? static_cast<std::uint32_t>(list ? buffer_.size() / 3 * 3 : buffer_.size()) : none;
    return figures_;
  }

 private:
  /// The order of splits that must be kept. Two operations whose fans share a triangle keep the order of the records,
  /// all others commute. So a set of records can be played, in any such order, exactly if it contains all records that
  /// its members need. A record can be undone if no other played record needs it.
  [[nodiscard]] std::span<const std::uint32_t> needs(std::size_t record) const noexcept {
    return {needs_.data() + first_need_[record], needs_.data() + first_need_[record + 1]};
  }
  [[nodiscard]] static std::vector<float> coordinates_of(const BakedFile& file) {
    std::vector<float> out;
    for (const auto& point : file.points) out.insert(out.end(), point.begin(), point.end());
    return out;
  }
  void begin_with(StripMesh base) {
    keeper_.reset();
    mesh_ = std::move(base);
    mesh_.reserve(source_.fine_triangles(), source_.points);
    mesh_.watch(nullptr);
  }
  void begin_buffer(const StripFormat& format) {
    std::fill(played_.begin(), played_.end(), 0);
    std::fill(dependents_.begin(), dependents_.end(), 0);
    figures_ = {};
    last_ = {};
    checked_ = false;
    changed_.clear();
    mesh_.watch(&changed_);
    buffer_ = LiveBuffer(format);
    buffer_.rebuild(mesh_);
    buffer_.reserve(source_.fine_triangles());
    buffer_.forget();
    list_ = {};
    begun_ = true;
    outgrown_ = true;
  }
  /// Notes that the mesh no longer fits the records.
  void leave_records() {
    checked_ = true;
    if (keeper_->baked() != nullptr) keeper_->baked()->leave_step();
  }
  template <class Operation>
  Refusal refine(Refusal refusal, const std::vector<Vertex>& corners, Operation&& operation) {
    if (refusal != Refusal::granted) return refusal;
    leave_records();
    last_ = {};
    const Rewrite<Halfedge> done = operation();
    count(done);
    new_vertex_ = mesh_.to(done.halfedge);
    points_.resize(std::max(points_.size(), 3 * (std::size_t{new_vertex_} + 1)));
    for (std::size_t x = 0; x < 3; ++x) {
      float sum = 0;
      for (const Vertex v : corners) sum += points_[3 * std::size_t{v} + x];
      points_[3 * std::size_t{new_vertex_} + x] = sum / static_cast<float>(corners.size());
    }
    return refusal;
  }
  bool play(std::size_t i) {
    const Record& r = source_.splits[i];
    const Where where = find_spokes(mesh_, r);
    if (checked_ && check_split(mesh_, where, r.v_t) != Refusal::granted) return ++figures_.refused, false;
    do_split(where, r.v_t);
    played_[i] = 1;
    for (const std::uint32_t need : needs(i)) ++dependents_[need];
    return true;
  }
  bool take_back(std::size_t i) {
    const Record& r = source_.splits[i];
    const Halfedge chord = find_edge(mesh_, r.v_s, r.v_t);
    if (checked_ && (dependents_[i] != 0 || check_collapse(mesh_, chord) != Refusal::granted))
      return ++figures_.refused, false;
    do_collapse(chord);
    played_[i] = 0;
    for (const std::uint32_t need : needs(i)) --dependents_[need];
    return true;
  }

  /// For a baked mesh: the record that adds this vertex; none for vertices of the base.
  [[nodiscard]] std::size_t record_of(Vertex v_t) const noexcept {
    return std::size_t{v_t} - (file_->points.size() - file_->splits.size());
  }
  void corners_of(std::vector<Corners>& out) const {
    out.clear();
    for (const Triangle t : patch_) out.push_back(mesh_.corners(t));
  }
  void do_split(const Where& where, Vertex v_t) {
    if (tell_) {
      last_.kind = LastOperation::Kind::split;
      last_.before = where.spokes == Where::Spokes::both ? fan_colors(mesh_, where.left, where.right) : PatchColors{};
      fan_triangles(mesh_, where.spokes == Where::Spokes::right_only ? where.right : where.left, patch_);
      corners_of(last_.triangles_before);
    }
    const auto done =
        keeper_->baked() != nullptr ? keeper_->split_record(record_of(v_t), where, v_t) : keeper_->split(where, v_t);
    count(done);
    if (!tell_) return;
    last_.after = last_.before.closed ? ring_colors(mesh_, done.halfedge) : PatchColors{};
    edge_triangles(mesh_, done.halfedge, patch_);
    corners_of(last_.triangles_after);
  }
  void do_collapse(Halfedge chord) {
    Vertex v_r = none;
    if (tell_) {
      last_.kind = LastOperation::Kind::collapse;
      last_.before = mesh_.leaves_boundary(chord) || mesh_.leaves_boundary(mesh_.opposite(chord))
                         ? PatchColors{}
                         : ring_colors(mesh_, chord);
      if (last_.before.closed) v_r = mesh_.to(StripMesh::next(mesh_.opposite(chord)));
      edge_triangles(mesh_, chord, patch_);
      corners_of(last_.triangles_before);
    }
    const auto done = keeper_->baked() != nullptr ? keeper_->collapse_record(record_of(mesh_.to(chord)), chord)
                                                  : keeper_->collapse(chord);
    count(done);
    if (!tell_) return;
    last_.after = last_.before.closed ? fan_colors(mesh_, done.halfedge, mesh_.spoke(mesh_.from(done.halfedge), v_r))
                                      : PatchColors{};
    fan_triangles(mesh_, done.halfedge, patch_);
    corners_of(last_.triangles_after);
  }
  void count(const Rewrite<Halfedge>& done) {
    ++figures_.operations;
    if (done.strips > 0) ++figures_.adding_strip;
    if (done.isolated > 0) ++figures_.isolating;
    last_.strips = done.strips;
    last_.isolated = done.isolated;
  }

  Progressive source_;
  std::vector<float> points_;
  std::vector<std::uint32_t> first_need_{0};  // in needs_, by record, and one after the last
  std::vector<std::uint32_t> needs_;
  std::optional<BakedFile> file_;  // of a baked mesh
  std::size_t refused_record_ = none;
  std::vector<std::uint8_t> played_;       // by record
  std::vector<std::uint32_t> dependents_;  // by record: the number of played records that need it
  std::vector<std::uint32_t> ready_;
  std::vector<std::uint8_t> wanted_;  // by record: approach() plays it

  StripMesh mesh_;
  std::optional<Keeper<StripMesh>> keeper_;
  std::vector<Triangle> changed_;
  LiveBuffer buffer_;
  TriangleListBuffer list_;
  StripMesh scratch_;
  std::vector<std::uint32_t> scratch_indices_;
  bool begun_ = true;      // and not updated yet
  bool outgrown_ = false;  // by the last update
  std::vector<IndexRange> given_;
  Vertex new_vertex_ = none;  // of the last bisection or split of a face
  Figures figures_;
  LastOperation last_;
  bool tell_ = true;      // whether to describe the next operations in last_
  bool checked_ = false;  // whether the mesh may no longer fit the records
  std::vector<Triangle> patch_;
};

}  // namespace restrip::web
