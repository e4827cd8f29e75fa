#include "replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

class Replay {
 public:
  Replay(const ProgressiveMesh& mesh, const ReplayOptions& options)
      : source_(mesh),
        options_(options),
        search_(options.search.value_or(search_of(options.policy))),
        base_(StripMesh::build(mesh.base, mesh.points.size())) {
    if (options_.baked != nullptr)
      base_ = options_.baked->base;
    else
      stripify(base_, Effort::full);
    // One mesh serves every run, so that its memory is there before the first clock starts.
    mesh_.reserve(mesh.fine_triangles(), mesh.points.size());
    report_.base_triangles = base_.triangle_count();
    report_.operations = mesh.splits.size();
  }

  ReplayReport run(const std::vector<Corners>& original) {
    watch_the_way_up();
    if (report_.operations_without_rule == 0) {
      watch_the_way_down();
      if (!player_ && options_.policy == Policy::local && search_.states == 0)
        report_.boldness = count_bolder(source_, base_);
      measure_buffer();
      measure();
      check_top(original.empty() ? bare_triangles() : original);
      const std::size_t cycles = std::max<std::size_t>(options_.cycles, options_.baked != nullptr ? 1 : 0);
      for (std::size_t i = 0; i < cycles; ++i) cycle();
    }
    return std::move(report_);
  }

 private:
  using Halfedge = StripMesh::Halfedge;

  // ---- one operation, under the policy
  void start_from_base() {
    mesh_ = base_;
    if (options_.baked != nullptr)
      player_.emplace(mesh_, options_.baked->records);
    else
      keeper_.emplace(mesh_, options_.policy).set_search(search_);
  }
  /// Baked: nobody counts valence and isolated triangles; they are 0.
  Rewrite<Halfedge> split_one(std::size_t i) { return split_one(i, spokes_of(mesh_, source_.splits[i])); }
  Rewrite<Halfedge> split_one(std::size_t i, const VertexSplit<Halfedge>& where) {
    const Vertex v_t = source_.splits[i].v_t;
    if (player_) {
      const BakedRewrite<Halfedge> done = player_->split(i, where, v_t);
      return {done.halfedge, 0, done.strips, 0};
    }
    return keeper_->split(where, v_t);
  }
  Rewrite<Halfedge> collapse_one(std::size_t i) {
    const Halfedge chord = mesh_.spoke(source_.splits[i].v_s, source_.splits[i].v_t);
    if (player_) {
      const BakedRewrite<Halfedge> done = player_->collapse(i, chord);
      return {done.halfedge, 0, done.strips, 0};
    }
    return keeper_->collapse(chord);
  }

  // ---- the way up, with everything counted
  void watch_the_way_up() {
    start_from_base();
    const std::vector<std::size_t> stops = level_sizes();
    std::size_t stop = 0;
    const auto at_level = [&] { return stop < stops.size() && mesh_.triangle_count() >= stops[stop]; };
    Progress progress("replaying", source_.splits.size());
    strips_now_ = report_.most_strips = extract_strips(mesh_).size();
    for (std::size_t i = 0; i < source_.splits.size(); ++i) {
      if (at_level()) record_level(), ++stop;
      split_and_count(source_.splits[i], i);
      progress.at(i);
    }
    record_level();
    report_.triangles = mesh_.triangle_count();
  }

  // ---- the way back, the same levels counted
  void watch_the_way_down() {
    std::size_t next = report_.levels.size();
    const auto at_level = [&] { return next > 0 && mesh_.triangle_count() == report_.levels[next - 1].triangles; };
    Progress progress("replaying backward", source_.splits.size());
    for (std::size_t i = source_.splits.size(); i-- > 0;) {
      if (at_level()) report_.levels_down.push_back(level()), --next;
      collapse_one(i);
      progress.at(source_.splits.size() - i);
    }
    while (at_level()) report_.levels_down.push_back(level()), --next;
    std::reverse(report_.levels_down.begin(), report_.levels_down.end());
  }

  // ---- what a renderer would have to upload, kept in step after every operation
  void measure_buffer() {
    if (source_.splits.empty() || !report_.faults.empty()) return;
    start_from_base();
    std::vector<Triangle> changed;
    mesh_.watch(&changed);
    StripBuffer buffer(mesh_);
    std::size_t written = 0;
    Progress progress("keeping an index buffer", source_.splits.size());
    for (std::size_t i = 0; i < source_.splits.size(); ++i) {
      split_one(i);
      for (const auto& range : buffer.update(mesh_, changed)) written += range.count;
      changed.clear();
      progress.at(i);
    }
    mesh_.watch(nullptr);
    constexpr auto bytes_each = static_cast<double>(sizeof(std::uint32_t));
    report_.buffer_bytes = buffer.indices().size_bytes();
    report_.bytes_written_per_operation =
        static_cast<double>(written) * bytes_each / static_cast<double>(source_.splits.size());
    if (sorted_triangles(decode_strips(buffer.indices())) != sorted_triangles(triangles_of(mesh_)))
      report_.faults.emplace_back("the index buffer that was kept in step does not draw the mesh");
  }

  /// Geometric steps from the base, the finest level excluded.
  [[nodiscard]] std::vector<std::size_t> level_sizes() const {
    const auto first = static_cast<double>(base_.triangle_count());
    const double ratio = static_cast<double>(source_.fine_triangles()) / first;
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i + 1 < options_.levels; ++i)
      sizes.push_back(static_cast<std::size_t>(
          std::ceil(first * std::pow(ratio, static_cast<double>(i) / static_cast<double>(options_.levels - 1)))));
    return sizes;
  }

  void split_and_count(const Record& record, std::size_t index) {
    const auto where = spokes_of(mesh_, record);
    const Refusal refusal = check_split(mesh_, where, record.v_t);
    if (refusal != Refusal::granted) {
      if (report_.operations_without_rule++ == 0)
        report_.faults.push_back(
            fmt::format("split {} ({} -> {}) is not possible: {}", index, record.v_s, record.v_t, describe(refusal)));
      return;
    }
    std::vector<Triangle> lonely;
    if (player_) lonely = lonely_triangles(index);
    auto done = split_one(index, where);
    if (player_) {
      done.valence = static_cast<std::uint32_t>(valence_before(done.halfedge));
      const std::vector<Triangle> now = lonely_triangles(index);
      done.isolated = std::includes(lonely.begin(), lonely.end(), now.begin(), now.end()) ? 0 : 1;
    }
    strips_now_ += static_cast<std::size_t>(done.strips);
    report_.most_strips = std::max(report_.most_strips, strips_now_);
    if (done.valence >= report_.by_valence.size()) report_.by_valence.resize(done.valence + std::size_t{1}, 0);
    ++report_.by_valence[done.valence];
    report_.operations_isolating += done.isolated > 0 ? 1 : 0;
    report_.operations_adding_strip += done.strips > 0 ? 1 : 0;
  }

  Level level() {
    const Strips strips = extract_strips(mesh_);
    Level level{mesh_.triangle_count(), strips.size(), 0, strip_index_count(mesh_, strips)};
    for (std::size_t s = 0; s < strips.size(); ++s) level.isolated += static_cast<std::size_t>(strips[s].size() == 1);
    if (strips.order.size() != level.triangles)
      report_.faults.push_back(
          fmt::format("at {} triangles: only {} of them are in a strip", level.triangles, strips.order.size()));
    return level;
  }
  void record_level() {
    report_.levels.push_back(level());
    if (!player_) return;
    hashes_.push_back(hash_of_strips());
    for (const std::string& fault : find_faults(mesh_))
      report_.faults.push_back(fmt::format("at {} triangles: {}", mesh_.triangle_count(), fault));
  }

  // ---- the clock
  void split_all() {
    for (std::size_t i = 0; i < source_.splits.size(); ++i) split_one(i);
  }
  void split_all_bare() {
    for (const Record& record : source_.splits) mesh_.insert_vertex(spokes_of(mesh_, record), record.v_t);
  }
  void collapse_all() {
    for (std::size_t i = source_.splits.size(); i-- > 0;) collapse_one(i);
  }
  void collapse_all_bare() {
    for (auto record = source_.splits.rbegin(); record != source_.splits.rend(); ++record)
      mesh_.remove_vertex(mesh_.spoke(record->v_s, record->v_t));
  }

  /// With strips and bare by turns, so that a slow moment of the machine strikes both.
  void measure() {
    if (source_.splits.empty() || options_.repeats == 0) return;
    Medians up;
    Medians up_bare;
    Medians down;
    Medians down_bare;
    // Small meshes are over in a moment: repeat them until there is something to measure.
    constexpr std::size_t enough_operations = 200'000;
    const std::size_t repeats = std::max(options_.repeats, enough_operations / source_.splits.size());
    Progress progress("measuring", repeats);
    for (std::size_t i = 0; i < repeats; ++i) {
      start_from_base();
      up.time([&] { split_all(); });
      down.time([&] { collapse_all(); });
      mesh_ = base_;
      up_bare.time([&] { split_all_bare(); });
      down_bare.time([&] { collapse_all_bare(); });
      progress.at(i);
    }
    const auto each = static_cast<double>(source_.splits.size());
    report_.ns_per_operation = up.nanoseconds() / each;
    report_.ns_per_operation_bare = up_bare.nanoseconds() / each;
    report_.ns_per_collapse = down.nanoseconds() / each;
    report_.ns_per_collapse_bare = down_bare.nanoseconds() / each;
  }

  // ---- the checks
  std::vector<Corners> bare_triangles() {
    mesh_ = base_;
    split_all_bare();
    return triangles_of(mesh_);
  }

  void check_top(const std::vector<Corners>& original) {
    start_from_base();
    split_all();
    for (std::string& fault : find_faults(mesh_)) report_.faults.push_back(std::move(fault));
    const std::vector<Corners> expected = sorted_triangles(original);
    if (sorted_triangles(triangles_of(mesh_)) != expected)
      report_.faults.emplace_back("after the last split the triangles are not those of the original mesh");
    if (sorted_triangles(decode_strips(strip_indices(mesh_, extract_strips(mesh_)))) != expected)
      report_.faults.emplace_back("the index buffer does not draw the triangles of the original mesh");
  }

  // ---- down and up
  void cycle() {
    Cycle cycle;
    const auto count = [&cycle](const auto& done) {
      cycle.isolating += done.isolated > 0 ? 1 : 0;
      cycle.adding_strip += done.strips > 0 ? 1 : 0;
    };
    std::size_t next = report_.levels.size();
    while (next > 0 && compare_level(next - 1)) --next;
    for (std::size_t i = source_.splits.size(); i-- > 0;) {
      count(collapse_one(i));
      while (next > 0 && compare_level(next - 1)) --next;
    }
    cycle.base = checked_level();
    while (next < report_.levels.size() && compare_level(next)) ++next;
    for (std::size_t i = 0; i < source_.splits.size(); ++i) {
      count(split_one(i));
      while (next < report_.levels.size() && compare_level(next)) ++next;
    }
    cycle.top = checked_level();
    report_.cycles.push_back(cycle);
  }
  Level checked_level() {
    for (std::string& fault : find_faults(mesh_))
      report_.faults.push_back(fmt::format("cycle {}: {}", report_.cycles.size() + 1, fault));
    return level();
  }

  // ---- baked strips
  /// Triangles alone, of those beside the flips of a record, in ascending order.
  [[nodiscard]] std::vector<Triangle> lonely_triangles(std::size_t record) const {
    std::vector<Triangle> lonely;
    for (const Halfedge h : options_.baked->records[record]) {
      if (!mesh_.alive(StripMesh::triangle(h))) continue;
      for (const Triangle t : {StripMesh::triangle(h), StripMesh::triangle(mesh_.opposite(h))})
        if (mesh_.solid_degree(t) == 0) lonely.push_back(t);
    }
    std::sort(lonely.begin(), lonely.end());
    lonely.erase(std::unique(lonely.begin(), lonely.end()), lonely.end());
    return lonely;
  }
  /// Triangles around the vertex before it was split there.
  [[nodiscard]] std::size_t valence_before(Halfedge chord) const {
    std::vector<Triangle> patch;
    edge_triangles(mesh_, chord, patch);
    return patch.size() - (StripMesh::on_boundary(chord) || StripMesh::on_boundary(mesh_.opposite(chord)) ? 1 : 2);
  }
  [[nodiscard]] std::uint64_t hash_of_strips() const {
    const std::vector<std::uint32_t> indices = strip_indices(mesh_, extract_strips(mesh_));
    return fnv1a({reinterpret_cast<const char*>(indices.data()), indices.size() * sizeof(std::uint32_t)});
  }
  /// At a level that was reported: are its strips what they were?
  bool compare_level(std::size_t i) {
    if (!player_ || mesh_.triangle_count() != report_.levels[i].triangles) return false;
    ++report_.levels_compared;
    if (hash_of_strips() != hashes_[i])
      report_.faults.push_back(fmt::format("cycle {}: at {} triangles the strips are not what they were",
                                           report_.cycles.size() + 1, report_.levels[i].triangles));
    return true;
  }

  const ProgressiveMesh& source_;
  ReplayOptions options_;
  Search search_;
  StripMesh base_;
  StripMesh mesh_;
  std::optional<StripKeeper> keeper_;
  std::optional<BakedPlayer<StripMesh>> player_;
  std::size_t strips_now_ = 0;
  std::vector<std::uint64_t> hashes_;  // of the strips at each reported level, if baked
  ReplayReport report_;
};

}  // namespace

ReplayReport replay(const ProgressiveMesh& mesh, const std::vector<Corners>& original, const ReplayOptions& options) {
  return Replay(mesh, options).run(original);
}

}  // namespace restrip::tools
