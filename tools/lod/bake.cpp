#include "lod/bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "common/bad_input.hpp"
#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "lod/coloring_check.hpp"
#include "lod/trail_search.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/end_search.hpp"
#include "restrip/search/rounds.hpp"
#include "restrip/search/strip_index.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/search/tunnel.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;

VertexSplit<Halfedge> where_of(const StripMesh& mesh, const BakedMesh& baked, std::size_t i) {
  const Record& record = baked.mesh.splits[i];
  const auto where = spokes_of(mesh, record);
  const Refusal refusal = check_split(mesh, where, record.v_t);
  if (refusal != Refusal::granted)
    throw BadInput(
        fmt::format("split {} ({} -> {}) is not possible: {}", i, record.v_s, record.v_t, describe(refusal)));
  return where;
}

void end_record(BakedRecords<Halfedge>& records) {
  if (records.flips.size() > std::numeric_limits<std::uint32_t>::max())
    throw BadInput("the mesh is too large: its records flip more than 2^32 colours");
  records.first.push_back(static_cast<std::uint32_t>(records.flips.size()));
}

class Baker {
 public:
  Baker(BakedMesh& baked, const BakeOptions& options)
      : baked_(baked),
        effort_(options.effort),
        index_(StripIndex::chunk_limit_for_long_strips(baked.mesh.fine_triangles())) {}

  BakeReport run() {
    Medians clock;
    clock.time([this] { walk_up(); });
    report_.seconds = clock.nanoseconds() * 1e-9;
    return report_;
  }

 private:
  void walk_up() {
    // Searches on the base are cheap, and every level inherits its strips.
    constexpr std::size_t states_per_triangle = 1000;
    stripify(baked_.base, Effort::full, states_per_triangle * baked_.base.triangle_count());
    mesh_ = baked_.base;
    mesh_.reserve(baked_.mesh.fine_triangles(), baked_.mesh.points.size());
    index_.rebuild(mesh_);
    report_.components = connected_components(mesh_);
    report_.base_strips = index_.strips();
    count_level();
    Progress progress("baking", baked_.mesh.splits.size());
    for (std::size_t i = 0; i < baked_.mesh.splits.size(); ++i) {
      bake_split(i);
      count_level();
      progress.at(i);
    }
    report_.top_strips = index_.strips();
    report_.top_indices = strip_indices(mesh_).size();
    report_.top_at_least = strips_at_least(mesh_);
    report_.flips = baked_.records.flips.size();
    report_.states = trails_.states() + tunnel_.counts().states;
  }

  void count_level() {
    report_.most_strips = std::max(report_.most_strips, index_.strips());
    if (index_.strips() <= report_.components) ++report_.fewest_levels;
  }

  void bake_split(std::size_t i) {
    flips_.clear();
    const std::size_t before = index_.strips();
    split_plainly(i);
    if (index_.strips() > report_.components && !join_around(index_.strips() > before)) join_from_afar();
    write_flips();
  }

  void split_plainly(std::size_t i) {
    const auto where = where_of(mesh_, baked_, i);
    fan_triangles(mesh_, where.spokes == VertexSplit<Halfedge>::Spokes::right_only ? where.right : where.left, patch_);
    index_.before_patch(mesh_, patch_);
    const Halfedge chord = split_baked(mesh_, where, {}, baked_.mesh.splits[i].v_t).halfedge;
    edge_triangles(mesh_, chord, patch_);
    index_.after_patch(mesh_, patch_);
    // The inserted triangles first: trails from there are the shortest.
    const auto inserted = [&](Triangle t) {
      return t == StripMesh::triangle(chord) || t == StripMesh::triangle(mesh_.opposite(chord));
    };
    std::stable_partition(patch_.begin(), patch_.end(), inserted);
    // Both alone: together they are one strip.
    if (where.spokes == VertexSplit<Halfedge>::Spokes::both && mesh_.solid_degree(patch_[0]) == 0 &&
        mesh_.solid_degree(patch_[1]) == 0) {
      index_.link(mesh_, chord);
      flips_.push_back(chord);
    }
  }

  /// Short trails from the strip ends in the patch, until the mesh has no strip too many or none is found. False when
  /// the split has `cost` a strip that they do not save.
  bool join_around(bool cost) {
    bool saved = !cost;
    while (index_.strips() > report_.components) {
      ends_.clear();
      for (const Triangle t : patch_)
        if (mesh_.solid_degree(t) < 2) ends_.push_back(t);
      // What earlier splits left behind is worth a short look only: it has been searched for already.
      constexpr std::size_t short_look = 20'000;
      if (ends_.empty() || !trails_.join(mesh_, index_, ends_, saved ? std::min(effort_, short_look) : effort_)) break;
      flips_.insert(flips_.end(), trails_.flips().begin(), trails_.flips().end());
      saved = true;
    }
    return saved && (index_.strips() <= report_.components || ++waited_ < wait_);
  }

  /// Tunnelling: first from the patch, then from every strip end of the mesh. What it flips is found by comparison,
  /// because it can be anywhere.
  void join_from_afar() {
    before_.resize(mesh_.triangle_bound());
    for (Triangle t = 0; t < before_.size(); ++t) before_[t] = colors(t);
    const std::size_t strips = index_.strips();
    const auto states = static_cast<std::uint32_t>(std::min<std::size_t>(effort_ / 16, 1U << 20));
    for (const Triangle t : patch_)
      if (mesh_.solid_degree(t) < 2) tunnel_.join(mesh_, index_, t, states);
    if (index_.strips() == strips && ++waited_ >= wait_) {
      rounds_.run(mesh_, index_, tunnel_, effort_ / 8, report_.components);
      // Where nothing is found, the next try can wait, and the longer the more often that was so.
      waited_ = 0;
      wait_ = index_.strips() < strips ? 1 : std::min<std::size_t>(2 * wait_, 1024);
    }
    changed_.clear();
    for (Triangle t = 0; t < before_.size(); ++t)
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if (((colors(t) ^ before_[t]) >> side & 1U) != 0 && h.id < mesh_.opposite(h).id) changed_.push_back(h);
      }
    if (index_.strips() < strips) {
      flips_.insert(flips_.end(), changed_.begin(), changed_.end());
      return;
    }
    // Searches that found nothing have wandered, and those flips need not be played.
    const auto missing =
        std::partition(changed_.begin(), changed_.end(), [this](Halfedge h) { return mesh_.solid(h); });
    std::for_each(changed_.begin(), missing, [this](Halfedge h) { index_.cut(mesh_, h); });
    std::for_each(missing, changed_.end(), [this](Halfedge h) { index_.link(mesh_, h); });
  }

  [[nodiscard]] std::uint8_t colors(Triangle t) const {
    unsigned bits = 0;
    for (unsigned side = 0; side < 3; ++side) bits |= unsigned{mesh_.solid(StripMesh::halfedge(t, side))} << side;
    return static_cast<std::uint8_t>(bits);
  }

  /// What was flipped twice was not flipped.
  void write_flips() {
    for (Halfedge& h : flips_) h.id = std::min(h.id, mesh_.opposite(h).id);
    std::sort(flips_.begin(), flips_.end(), [](Halfedge g, Halfedge h) { return g.id < h.id; });
    BakedRecords<Halfedge>& records = baked_.records;
    for (std::size_t i = 0; i < flips_.size();) {
      std::size_t same = i + 1;
      while (same < flips_.size() && flips_[same] == flips_[i]) ++same;
      if ((same - i) % 2 == 1) records.flips.push_back(flips_[i]);
      i = same;
    }
    end_record(records);
  }

  BakedMesh& baked_;
  std::size_t effort_;
  BakeReport report_;
  StripMesh mesh_;
  StripIndex index_;
  TrailSearch trails_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};
  std::vector<Triangle> patch_;
  std::vector<Triangle> ends_;
  std::vector<Halfedge> flips_;
  std::vector<std::uint8_t> before_;
  std::vector<Halfedge> changed_;
  std::size_t wait_ = 1;
  std::size_t waited_ = 0;
};

/// Bakes fewest indices: after each plain split a search at the strip ends around it, with chains as long as they get.
class IndexBaker {
 public:
  IndexBaker(BakedMesh& baked, const BakeOptions& options) : baked_(baked), search_(options.cost) {
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    limits_ = {.looks = static_cast<std::uint32_t>(std::min(options.effort / effort_of_a_look, most)),
               .length = EndSearch::max_length,
               .worse = 2};
  }

  BakeReport run() {
    Medians clock;
    clock.time([this] { walk_up(); });
    report_.seconds = clock.nanoseconds() * 1e-9;
    return report_;
  }

 private:
  static constexpr std::size_t effort_of_a_look = 500;

  void walk_up() {
    stripify(baked_.base, Effort::best, search_.cost());
    mesh_ = baked_.base;
    mesh_.reserve(baked_.mesh.fine_triangles(), baked_.mesh.points.size());
    mesh_.watch(&changed_);
    report_.components = connected_components(mesh_);
    strips_ = report_.base_strips = count_strips(mesh_);
    changed_.resize(mesh_.triangle_bound());
    std::iota(changed_.begin(), changed_.end(), Triangle{0});
    note_colors();
    count_level();
    Progress progress("baking", baked_.mesh.splits.size());
    for (std::size_t i = 0; i < baked_.mesh.splits.size(); ++i) {
      bake_split(i);
      count_level();
      progress.at(i);
    }
    report_.top_strips = strips_;
    report_.top_indices = strip_indices(mesh_).size();
    report_.top_at_least = strips_at_least(mesh_);
    report_.flips = baked_.records.flips.size();
    report_.states = search_.counts().looked;
  }

  void count_level() {
    report_.most_strips = std::max(report_.most_strips, strips_);
    if (strips_ <= report_.components) ++report_.fewest_levels;
  }

  void bake_split(std::size_t i) {
    changed_.clear();
    const auto done = split_baked(mesh_, where_of(mesh_, baked_, i), {}, baked_.mesh.splits[i].v_t);
    note_colors();
    // From the patch and two rings around it.
    edge_triangles(mesh_, done.halfedge, from_);
    for (std::size_t ring = 0, begin = 0; ring < 2; ++ring)
      for (const std::size_t end = from_.size(); begin < end; ++begin)
        for (unsigned side = 0; side < 3; ++side)
          if (const Halfedge back = mesh_.opposite(StripMesh::halfedge(from_[begin], side));
              !StripMesh::on_boundary(back))
            from_.push_back(StripMesh::triangle(back));
    changed_.clear();
    const ColoringChange change = search_.run(mesh_, from_, limits_);
    strips_ += static_cast<std::size_t>(done.strips + change.strips);
    write_flips();
  }

  /// The colours of triangles that have changed; the others have what they had.
  void note_colors() {
    colors_.resize(mesh_.triangle_bound());
    for (const Triangle t : changed_) colors_[t] = static_cast<std::uint8_t>(mesh_.solid_sides(t));
  }

  void write_flips() {
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const Triangle t : changed_) {
      const unsigned now = mesh_.solid_sides(t);
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if (((now ^ colors_[t]) >> side & 1U) != 0 && h.id < mesh_.opposite(h).id) baked_.records.flips.push_back(h);
      }
    }
    note_colors();
    end_record(baked_.records);
  }

  BakedMesh& baked_;
  EndSearch search_;
  EndLimits limits_;
  BakeReport report_;
  StripMesh mesh_;
  std::size_t strips_ = 0;
  std::vector<Triangle> from_;
  std::vector<Triangle> changed_;
  std::vector<std::uint8_t> colors_;
};

}  // namespace

std::size_t strips_at_least(const StripMesh& mesh) {
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::vector<Triangle> piece;
  std::size_t strips = 0;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || met[start]) continue;
    piece.assign(1, start);
    met[start] = true;
    std::size_t ends = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      unsigned neighbors = 0;
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge there = mesh.opposite(StripMesh::halfedge(piece[i], side));
        if (StripMesh::on_boundary(there)) continue;
        ++neighbors;
        const Triangle t = StripMesh::triangle(there);
        if (!met[t]) piece.push_back(t);
        met[t] = true;
      }
      ends += neighbors < 2 ? 1U : 0U;
    }
    strips += std::max<std::size_t>(1, (ends + 1) / 2);
  }
  return strips;
}

BakedMesh bake(ProgressiveMesh mesh, const BakeOptions& options, BakeReport* report) {
  BakedMesh baked;
  baked.base = StripMesh::build(mesh.base, mesh.points.size());
  mesh.base = triangles_of(baked.base);
  baked.mesh = std::move(mesh);
  const BakeReport made =
      options.cost == Cost::strips() ? Baker(baked, options).run() : IndexBaker(baked, options).run();
  if (report != nullptr) *report = made;
  return baked;
}

}  // namespace restrip::tools
