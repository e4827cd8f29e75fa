// Index buffers after the level of detail has moved by 1 % of its triangles: strips maintained under the index cost,
// with their live buffer; a triangle list with a slot for each triangle, without strips; and lists and strips made from
// scratch, which are copied whole. Measures time, bytes to upload, indices and vertex-cache misses, all in one run.
//
// Time covers the mesh update, the strips and the buffer. Methods from scratch are not charged for the mesh update and
// the triangle list of the new level.
#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <functional>
#include <vector>

#include "common/stopwatch.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/output/triangle_list_buffer.hpp"
#include "restrip/output/vertex_cache.hpp"
#include "restrip/search/stripify.hpp"
#include "shared.hpp"

#ifdef RESTRIP_RM_TRISTRIPPER
extern "C" std::size_t tristripper_indices(const unsigned* ids, std::size_t count, unsigned* out);
#endif

namespace restrip::bench {
namespace {

constexpr std::array<int, 2> drawn_percents{20, 100};

void count(benchmark::State& state, double nanoseconds, std::size_t bytes, std::span<const std::uint32_t> indices,
           const LevelList& level) {
  const std::size_t triangles = level.mesh.triangle_count();
  state.counters["move_ns"] = nanoseconds;
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["indices_per_triangle"] = static_cast<double>(indices.size()) / static_cast<double>(triangles);
  for (const auto& [size, acmr_name, atvr_name] :
       {std::tuple{16U, "acmr_16", "atvr_16"}, {32U, "acmr_32", "atvr_32"}}) {
    const auto misses = static_cast<double>(vertex_cache_misses(indices, size));
    state.counters[acmr_name] = misses / static_cast<double>(triangles);
    state.counters[atvr_name] = misses / static_cast<double>(level.vertices);
  }
}

/// Moves up by 1 % with a buffer that is updated once, at the end.
template <class Buffer>
void keep(benchmark::State& state, const std::string& name, const Method& method, int percent) {
  Player player(name, method, method.weighs() ? Cost::indices() : Cost::strips());
  const std::size_t from = player.level_of(percent * 0.0099);
  const std::size_t to = player.level_of(percent * 0.01);
  player.up_to(from);
  const StripMesh start = player.mesh();
  tools::Medians time;
  std::vector<Triangle> changed;
  for ([[maybe_unused]] auto _ : state) {
    player.restart(start, from);
    changed.clear();
    player.mesh().watch(&changed);
    Buffer buffer(player.mesh());
    std::size_t bytes = 0;
    const auto update = [&] {
      bytes = 0;
      for (const IndexRange& range : buffer.update(player.mesh(), changed)) bytes += 4 * range.count;
      changed.clear();
    };
    // Once up and down first, because a new buffer still has to allocate its memory.
    player.up_to(to);
    update();
    player.down_to(from);
    update();
    time.time([&] {
      player.up_to(to);
      update();
    });
    player.mesh().watch(nullptr);
    state.SetIterationTime(1e-9 * time.nanoseconds());
    count(state, time.nanoseconds(), bytes, buffer.indices(), level_list(name, percent));
  }
}

/// Memory allocated before the clock starts.
struct Made {
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> ordered;  ///< triangles of the level, to be reordered
};

/// Makes indices of the level from scratch; `indices_of` returns their number.
void make(benchmark::State& state, const std::string& name, int percent,
          const std::function<std::size_t(const LevelList&, Made&)>& indices_of) {
  const LevelList& level = level_list(name, percent);
  Made made{std::vector<std::uint32_t>(meshopt_stripifyBound(level.indices.size())), level.indices};
  std::size_t length = 0;
  tools::Medians time;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { length = indices_of(level, made); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  count(state, time.nanoseconds(), 4 * length, std::span(made.indices).first(length), level);
}

std::size_t meshopt_list(const LevelList& level, Made& made) {
  meshopt_optimizeVertexCache(made.indices.data(), level.indices.data(), level.indices.size(), level.vertices);
  return level.indices.size();
}

std::size_t meshopt_strips(const LevelList& level, Made& made) {
  meshopt_optimizeVertexCacheStrip(made.ordered.data(), level.indices.data(), made.ordered.size(), level.vertices);
  return meshopt_stripify(made.indices.data(), made.ordered.data(), made.ordered.size(), level.vertices, restart_index);
}

std::size_t own_strips(const LevelList& level, Made& made) {
  StripMesh mesh = level.mesh;
  stripify(mesh, Effort::fast, Cost::indices());
  made.indices = strip_indices(mesh, extract_strips(mesh));
  return made.indices.size();
}

#ifdef RESTRIP_RM_TRISTRIPPER
std::size_t tristripper_strips(const LevelList& level, Made& made) {
  made.indices.resize(2 * level.indices.size() + 4);
  return tristripper_indices(level.indices.data(), level.indices.size(), made.indices.data());
}
#endif

}  // namespace

void register_benchmarks() {
  for (const std::string& name : subject_names()) {
    for (const int percent : drawn_percents) {
      const std::string stem = "draw/" + name + "/" + std::to_string(percent) + "/";
      const auto add = [&](const std::string& who, auto run) { add_timed(stem + who, run); };
      for (const Method& method : tools::methods())
        if (method.kind == Method::Kind::ours && is_measured(name, method))
          add(method.name,
              [name, &method, percent](benchmark::State& state) { keep<StripBuffer>(state, name, method, percent); });
      add("list", [name, percent](benchmark::State& state) {
        keep<TriangleListBuffer>(state, name, method_named("bare"), percent);
      });
      const auto add_made = [&](const std::string& who, auto indices_of) {
        add(who, [=](benchmark::State& state) { make(state, name, percent, indices_of); });
      };
      add_made("stripify_fast", own_strips);
      add_made("meshopt_strips", meshopt_strips);
      add_made("meshopt_list", meshopt_list);
#ifdef RESTRIP_RM_TRISTRIPPER
      add_made("rm_tristripper", tristripper_strips);
#endif
    }
  }
}

}  // namespace restrip::bench
