// Keeping an index buffer in step with the strips (StripBuffer): what an operation rewrites and costs, against writing
// the whole buffer. The top 5 % of a progressive mesh, down and up; the buffer is brought in step after every
// operation, or after sixteen or 256 of them.
#include <benchmark/benchmark.h>

#include "common/stopwatch.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "timed.hpp"
#include "way.hpp"

namespace restrip::bench {
namespace {

void keep(benchmark::State& state, const std::string& name, const Way& way, std::size_t operations_an_update) {
  Player player(name, way);
  const std::size_t top = subject(name).mesh.splits.size();
  const std::size_t low = player.level_of(0.95);
  player.up_to(top);
  const StripMesh start = player.mesh();
  tools::Medians with;
  tools::Medians without;
  std::size_t bytes = 0;
  std::size_t ranges = 0;
  std::size_t rebuilt = 0;
  std::size_t unused = 0;
  const auto through = [&](auto&& update) {
    for (std::size_t level = top; level > low; update()) {
      level = std::max(low, level - std::min(level, operations_an_update));
      player.down_to(level);
    }
    for (std::size_t level = low; level < top; update()) {
      level = std::min(top, level + operations_an_update);
      player.up_to(level);
    }
  };
  for ([[maybe_unused]] auto _ : state) {
    player.restart(start, top);
    without.time([&] { through([] {}); });
    player.restart(start, top);
    std::vector<Triangle> changed;
    StripBuffer buffer(player.mesh());
    player.mesh().watch(&changed);
    bytes = ranges = rebuilt = 0;
    with.time([&] {
      through([&] {
        const auto written = buffer.update(player.mesh(), changed);
        changed.clear();
        ranges += written.size();
        for (const StripBuffer::Range& range : written) bytes += 4 * range.count;
        if (written.size() == 1 && written.front().count == buffer.indices().size()) ++rebuilt;
      });
    });
    player.mesh().watch(nullptr);
    unused = buffer.indices().size() - buffer.used();
    state.SetIterationTime(1e-9 * with.nanoseconds());
  }
  const auto each = 2.0 * static_cast<double>(top - low);
  state.counters["upkeep_ns"] = (with.nanoseconds() - without.nanoseconds()) / each;
  state.counters["operation_ns"] = without.nanoseconds() / each;
  state.counters["bytes"] = static_cast<double>(bytes) / each;
  state.counters["ranges"] = static_cast<double>(ranges) / each;
  state.counters["rebuilt"] = static_cast<double>(rebuilt);
  state.counters["unused_percent"] =
      100.0 * static_cast<double>(unused) / static_cast<double>(StripBuffer(player.mesh()).used() + unused);
}

void write_whole(benchmark::State& state, const std::string& name, const Way& way) {
  Player player(name, way);
  player.up_to(subject(name).mesh.splits.size());
  tools::Medians time;
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { bytes = 4 * strip_indices(player.mesh(), extract_strips(player.mesh())).size(); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  state.counters["whole_ns"] = time.nanoseconds();
  state.counters["bytes"] = static_cast<double>(bytes);
}

}  // namespace

void register_benchmarks() {
  // The largest that is quickly replayed.
  const std::vector<std::string> names = subject_names();
  const std::string name = std::find(names.begin(), names.end(), "bunny") != names.end() ? "bunny" : names.front();
  for (const Way& way : tools::ways()) {
    if (way.kind != Way::Kind::ours || way.bakes) continue;
    const std::string stem = "buffer/" + name + "/" + way.name + "/";
    for (const std::size_t count : {1U, 16U, 256U})
      add_timed(
          stem + std::to_string(count), [=, &way](benchmark::State& state) { keep(state, name, way, count); }, 3,
          benchmark::kMillisecond);
    add_timed(
        stem + "whole", [=, &way](benchmark::State& state) { write_whole(state, name, way); }, 5,
        benchmark::kMillisecond);
  }
}

}  // namespace restrip::bench
