#include "replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "mesh/history.hpp"
#include "replay/methods.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

Rewrite with(Rewrite done, const ColoringChange& more) {
  done += more;
  return done;
}

class Replay {
 public:
  Replay(const PreparedMethod& prepared, const ReplayOptions& options)
      : prepared_(prepared), splits_(prepared.mesh().splits), options_(options), mesh_(prepared.base()) {
    // One mesh serves every run, so that its memory is allocated before timing starts.
    mesh_.reserve(prepared.mesh().fine_triangles(), prepared.mesh().points.size());
    maintainer_ = prepared.begin(mesh_);
    bare_ = method_named("bare").begin(mesh_, {});
    report_.base_triangles = mesh_.triangle_count();
    report_.operations = splits_.size();
  }

  ReplayReport run(const std::vector<Corners>& original) {
    if (options_.trace != nullptr) maintainer_ = traced(mesh_, std::move(maintainer_), claim_of(prepared_), trace_);
    watch_the_way_up();
    if (report_.operations_without_rule == 0) {
      watch_the_way_down();
      report_.rules = maintainer_->rule_counts();
      if (trace_) {
        trace_->end();
        *options_.trace = std::move(trace_->text());
        maintainer_ = prepared_.begin(mesh_);
      }
      if (!splits_.empty() && report_.faults.empty()) {
        for (const std::size_t operations : options_.buffer.operations_per_update) measure_buffer(operations);
        if (options_.repeats != 0) time_buffers();
      }
      measure();
      check_top(original.empty() ? bare_triangles() : original);
      const std::size_t cycles = std::max<std::size_t>(options_.cycles, prepared_.method().bakes ? 1 : 0);
      for (std::size_t i = 1, step = 1; i <= cycles && report_.valid(); ++i) {
        if (!report_.cycles.empty() && (report_.cycles.back().number - 1) % step != 0) report_.cycles.pop_back();
        if (report_.cycles.size() == most_reported_cycles) {
          step *= 2;
          std::erase_if(report_.cycles, [step](const Cycle& cycle) { return (cycle.number - 1) % step != 0; });
        }
        cycle(i);
      }
    }
    return std::move(report_);
  }

 private:
  using Halfedge = StripMesh::Halfedge;

  // ---- ways up and down
  void start_from_base() {
    mesh_ = prepared_.base();
    maintainer_->restart(0);
  }
  Rewrite split_one(std::size_t i) {
    const auto done = maintainer_->split(spokes_of(mesh_, splits_[i]), splits_[i].v_t, i);
    return with(done, maintainer_->between());
  }

  /// Plays all splits. Calls at_level(n) where the mesh is the reported level n, and after(i, done) after split i.
  template <class AtLevel, class After>
  void go_up(AtLevel&& at_level, After&& after) {
    std::size_t next = 0;
    for (std::size_t i = 0;; ++i) {
      for (; next < report_.levels.size() && mesh_.triangle_count() == report_.levels[next].triangles; ++next)
        at_level(next);
      if (i == splits_.size()) return;
      after(i, split_one(i));
    }
  }
  /// The same with collapses, the last record first.
  template <class AtLevel, class After>
  void go_down(AtLevel&& at_level, After&& after) {
    std::size_t next = report_.levels.size();
    for (std::size_t i = splits_.size();; --i) {
      for (; next > 0 && mesh_.triangle_count() == report_.levels[next - 1].triangles; --next) at_level(next - 1);
      if (i == 0) return;
      const Record& record = splits_[i - 1];
      const auto done = maintainer_->collapse(mesh_.spoke(record.v_s, record.v_t), i - 1);
      after(i - 1, with(done, maintainer_->between()));
    }
  }

  // ---- the way up, with all counts
  void watch_the_way_up() {
    start_from_base();
    const std::vector<std::size_t> sizes =
        level_sizes(report_.base_triangles, prepared_.mesh().fine_triangles(), options_.levels);
    std::size_t next = 0;
    Progress progress("replaying", splits_.size());
    std::size_t strips = report_.most_strips = count_strips(mesh_);
    for (std::size_t i = 0; i < splits_.size(); progress.at(i++)) {
      if (next != sizes.size() && mesh_.triangle_count() >= sizes[next]) {
        ++next;
        record_level();
      }
      const Record& record = splits_[i];
      const Refusal refusal = check_split(mesh_, spokes_of(mesh_, record), record.v_t);
      if (refusal != Refusal::granted) {
        if (report_.operations_without_rule++ == 0)
          report_.faults.push_back(
              fmt::format("split {} ({} -> {}) is not possible: {}", i, record.v_s, record.v_t, describe(refusal)));
        continue;
      }
      const auto done = split_one(i);
      strips += static_cast<std::size_t>(done.strips);
      report_.most_strips = std::max(report_.most_strips, strips);
      if (done.valence >= report_.by_valence.size()) report_.by_valence.resize(done.valence + std::size_t{1}, 0);
      ++report_.by_valence[done.valence];
      report_.operations_isolating += done.isolated > 0 ? 1 : 0;
      report_.operations_adding_strip += done.strips > 0 ? 1 : 0;
    }
    record_level();
    report_.triangles = mesh_.triangle_count();
  }

  // ---- the way back, with counts at the same levels
  void watch_the_way_down() {
    Progress progress("replaying backward", splits_.size());
    go_down([&](std::size_t) { report_.levels_down.push_back(level()); },
            [&](std::size_t i, const auto&) { progress.at(splits_.size() - i); });
    std::reverse(report_.levels_down.begin(), report_.levels_down.end());
  }

  // ---- the live index buffer
  void measure_buffer(std::size_t operations_per_update) {
    start_from_base();
    LiveMeasure measure(mesh_, options_.buffer, operations_per_update, prepared_.mesh().fine_triangles());
    const bool first = report_.live_buffers.empty();
    Progress progress("keeping an index buffer", 2 * splits_.size());
    std::size_t done = 0;
    const auto operation = [&](std::size_t, const auto&) {
      measure.count_operation();
      progress.at(done++);
    };
    const auto look = [&](Level& level, const std::string& at) {
      if (!first && at.empty()) return;
      const BufferState here = measure.look(at, report_.faults);
      if (!first) return;
      level.buffer_indices = here.indices;
      level.acmr = here.fifo_16;
      level.acmr_32 = here.fifo_32;
    };
    const std::size_t top = report_.levels.size() - 1;
    go_up([&](std::size_t at) { look(report_.levels[at], at == 0     ? "base"
                                                         : at == top ? "finest level"
                                                                     : ""); },
          operation);
    go_down([&](std::size_t at) { look(report_.levels_down[at], at == 0 ? "base again" : ""); }, operation);
    report_.live_buffers.push_back(measure.report());
  }

  /// Runs up and down without a buffer, with each, and with each and a history in turn, and takes the differences per
  /// update.
  void time_buffers() {
    const std::size_t buffers = report_.live_buffers.size();
    std::vector<Medians> with(buffers);
    std::vector<Medians> with_history(buffers);
    Medians without;
    std::vector<Triangle> changed;
    const auto through = [&](std::size_t operations, auto&& update) {
      std::size_t done = 0;
      const auto count = [&] {
        if (++done % operations == 0) update();
      };
      for (std::size_t i = 0; i < splits_.size(); ++i) {
        maintainer_->play_up(std::span(splits_).subspan(i, 1), i);
        count();
      }
      for (std::size_t i = splits_.size(); i-- > 0;) {
        maintainer_->play_down(std::span(splits_).subspan(i, 1), i);
        count();
      }
    };
    Progress progress("timing updates of the buffer", options_.repeats);
    for (std::size_t repeat = 0; repeat < options_.repeats; progress.at(repeat++)) {
      start_from_base();
      without.time([&] { through(1, [] {}); });
      for (std::size_t i = 0; i < 2 * buffers; ++i) {
        start_from_base();
        LiveBuffer buffer({.form = options_.buffer.form, .width = IndexWidth::bits32});
        buffer.reserve(2 * prepared_.mesh().fine_triangles());
        buffer.rebuild(mesh_);
        std::optional<History> history;
        constexpr std::size_t budget = 10'000;  // of undo
        if (i >= buffers) history.emplace(mesh_, budget);
        mesh_.watch(&changed);
        (history ? with_history : with)[i % buffers].time([&] {
          through(report_.live_buffers[i % buffers].operations_per_update, [&] {
            if (history) history->frame(mesh_, changed);
            buffer.update(mesh_, changed);
            changed.clear();
          });
        });
        mesh_.watch(nullptr);
        changed.clear();
      }
    }
    for (std::size_t i = 0; i < buffers; ++i) {
      LiveBufferReport& buffer = report_.live_buffers[i];
      const std::size_t updates = 2 * splits_.size() / buffer.operations_per_update;
      const auto each = [&](const Medians& timed) {
        return updates == 0 ? 0 : (timed.nanoseconds() - without.nanoseconds()) / static_cast<double>(updates);
      };
      buffer.ns_per_update = each(with[i]);
      buffer.ns_per_update_with_history = each(with_history[i]);
    }
  }

  Level level() {
    if (const std::string fault = maintainer_->fault(); !fault.empty())
      report_.faults.push_back(fmt::format("at {} triangles: {}", mesh_.triangle_count(), fault));
    return level_of(mesh_, report_.faults);
  }
  void record_level() {
    report_.levels.push_back(level());
    if (!prepared_.method().bakes) return;
    hashes_.push_back(hash_of_strips());
    for (const std::string& fault : find_faults(mesh_))
      report_.faults.push_back(fmt::format("at {} triangles: {}", mesh_.triangle_count(), fault));
  }

  // ---- timing
  /// Runs with and without strips in turn, so that slow moments of the machine affect both.
  void measure() {
    if (splits_.empty() || options_.repeats == 0) return;
    Medians up;
    Medians up_bare;
    Medians down;
    Medians down_bare;
    const std::size_t repeats = std::max(options_.repeats, options_.enough_operations / splits_.size());
    Progress progress("measuring", repeats);
    for (std::size_t i = 0; i < repeats; ++i) {
      start_from_base();
      up.time([&] { maintainer_->play_up(splits_, 0); });
      down.time([&] { maintainer_->play_down(splits_, 0); });
      mesh_ = prepared_.base();
      up_bare.time([&] { bare_->play_up(splits_, 0); });
      down_bare.time([&] { bare_->play_down(splits_, 0); });
      progress.at(i);
    }
    const auto each = static_cast<double>(splits_.size());
    report_.ns_per_operation = up.nanoseconds() / each;
    report_.ns_per_operation_bare = up_bare.nanoseconds() / each;
    report_.ns_per_collapse = down.nanoseconds() / each;
    report_.ns_per_collapse_bare = down_bare.nanoseconds() / each;
  }

  // ---- the checks
  std::vector<Corners> bare_triangles() {
    mesh_ = prepared_.base();
    bare_->play_up(splits_, 0);
    return corners_of(mesh_);
  }

  void check_top(const std::vector<Corners>& original) {
    start_from_base();
    maintainer_->play_up(splits_, 0);
    for (std::string& fault : find_faults(mesh_)) report_.faults.push_back(std::move(fault));
    const std::vector<Corners> expected = sorted_triangles(original);
    if (sorted_triangles(corners_of(mesh_)) != expected)
      report_.faults.emplace_back("after the last split the triangles differ from the original mesh");
    if (sorted_triangles(decode_strips(strip_indices(mesh_, extract_strips(mesh_)))) != expected)
      report_.faults.emplace_back("the index buffer does not draw the triangles of the original mesh");
  }

  // ---- down and up
  void cycle(std::size_t number) {
    Cycle cycle;
    cycle.number = cycle_ = number;
    const auto compare = [this](std::size_t at) {  // with the strips that a baked mesh had there before
      if (!prepared_.method().bakes) return;
      ++report_.levels_compared;
      if (hash_of_strips() != hashes_[at])
        report_.faults.push_back(
            fmt::format("cycle {}: at {} triangles the strips have changed", cycle_, report_.levels[at].triangles));
    };
    const auto count = [&cycle](std::size_t, const auto& done) {
      cycle.isolating += done.isolated > 0 ? 1 : 0;
      cycle.adding_strip += done.strips > 0 ? 1 : 0;
    };
    go_down(compare, count);
    cycle.base = checked_level();
    go_up(compare, count);
    cycle.top = checked_level();
    report_.cycles.push_back(cycle);
  }
  Level checked_level() {
    for (std::string& fault : find_faults(mesh_)) report_.faults.push_back(fmt::format("cycle {}: {}", cycle_, fault));
    return level();
  }

  // ---- baked strips
  [[nodiscard]] std::uint64_t hash_of_strips() const {
    const std::vector<std::uint32_t> indices = strip_indices(mesh_, extract_strips(mesh_));
    return fnv1a({reinterpret_cast<const char*>(indices.data()), indices.size() * sizeof(std::uint32_t)});
  }

  const PreparedMethod& prepared_;
  const std::vector<Record>& splits_;
  ReplayOptions options_;
  StripMesh mesh_;
  std::optional<Trace> trace_;  // written by the maintainer
  std::unique_ptr<Maintainer> maintainer_;
  std::unique_ptr<Maintainer> bare_;   // on the same mesh
  std::size_t cycle_ = 0;              // the number of the current one
  std::vector<std::uint64_t> hashes_;  // of the strips at each reported level, if baked
  ReplayReport report_;
};

}  // namespace

Level level_of(const StripMesh& mesh, std::vector<std::string>& faults) {
  const Strips strips = extract_strips(mesh);
  Level level{mesh.triangle_count(), strips.size(), 0, 0, strip_index_count(mesh, strips)};
  if (strips.size() != 0) level.swaps = level.indices + 1 - level.triangles - 3 * level.strips;
  for (std::size_t s = 0; s < strips.size(); ++s) level.isolated += static_cast<std::size_t>(strips[s].size() == 1);
  if (strips.order.size() != level.triangles)
    faults.push_back(
        fmt::format("at {} triangles: only {} of them are in a strip", level.triangles, strips.order.size()));
  return level;
}

std::vector<std::size_t> level_sizes(std::size_t base_triangles, std::size_t fine_triangles, std::size_t count) {
  std::vector<std::size_t> sizes;
  const auto first = static_cast<double>(base_triangles);
  const double ratio = static_cast<double>(fine_triangles) / first;
  for (std::size_t i = 0; i + 1 < count; ++i)
    sizes.push_back(static_cast<std::size_t>(
        std::ceil(first * std::pow(ratio, static_cast<double>(i) / static_cast<double>(count - 1)))));
  return sizes;
}

ReplayReport replay(const PreparedMethod& prepared, const std::vector<Corners>& original,
                    const ReplayOptions& options) {
  return Replay(prepared, options).run(original);
}

}  // namespace restrip::tools
