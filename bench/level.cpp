// Moving the level of detail by 1 % of the triangles: what it costs to have the index buffer of the next level, how
// long that buffer is, and how often a vertex cache misses when it is drawn. All in one run.
//
// Our policies, under their default costs, and a triangle list with a slot for each triangle change the mesh and bring
// their live buffer in step, once at the end. The others make strips or a list of the new level from scratch, which is
// copied whole; they are not charged for the mesh update, for the triangle list or OpenMesh of the new level, nor for
// memory.
#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/StripifierT.hh>
#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "common/stopwatch.hpp"
#include "measure/vertex_cache.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "shared.hpp"

#ifdef RESTRIP_RM_TRISTRIPPER
extern "C" std::size_t tristripper_indices(const unsigned* ids, std::size_t count, unsigned* out);
#endif

namespace restrip::bench {
namespace {

constexpr std::array<int, 3> percents{10, 50, 100};

void count(benchmark::State& state, double nanoseconds, std::size_t bytes, std::span<const std::uint32_t> indices,
           const LevelList& level) {
  const auto triangles = static_cast<double>(level.mesh.triangle_count());
  state.counters["move_ns"] = nanoseconds;
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["triangles"] = triangles;
  state.counters["indices_per_triangle"] = static_cast<double>(indices.size()) / triangles;
  for (const auto& [size, name] : {std::pair{16U, "acmr_16"}, {32U, "acmr_32"}})
    state.counters[name] = static_cast<double>(vertex_cache_misses(indices, size)) / triangles;
}

void keep(benchmark::State& state, const std::string& name, const Method& method, StripForm form, int percent) {
  Player player(name, method);
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
    LiveBuffer buffer({.form = form, .width = IndexWidth::bits32});
    buffer.rebuild(player.mesh());
    std::size_t bytes = 0;
    const auto update = [&] {
      bytes = 0;
      for (const IndexRange& range : buffer.update(player.mesh(), changed)) bytes += 4 * range.count;
      changed.clear();
    };
    // Once up and down first, because a new keeper and a new buffer still have to allocate their memory.
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

void find_order(const LevelList& level, Made& made) {
  meshopt_optimizeVertexCacheStrip(made.ordered.data(), level.indices.data(), made.ordered.size(), level.vertices);
}

/// Makes indices of the level from scratch; `indices_of` returns their number.
void make(benchmark::State& state, const std::string& name, int percent, bool order_is_given,
          const std::function<std::size_t(const LevelList&, Made&)>& indices_of) {
  const LevelList& level = level_list(name, percent);
  Made made{std::vector<std::uint32_t>(meshopt_stripifyBound(level.indices.size())), level.indices};
  if (order_is_given) find_order(level, made);
  std::size_t length = 0;
  tools::Medians time;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { length = indices_of(level, made); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  count(state, time.nanoseconds(), 4 * length, std::span(made.indices).first(length), level);
}

std::size_t own_strips(const LevelList& level, Made& made) {
  StripMesh mesh = level.mesh;
  stripify(mesh, Effort::fast, default_cost);
  made.indices = strip_indices(mesh, extract_strips(mesh));
  return made.indices.size();
}

std::size_t meshopt_list(const LevelList& level, Made& made) {
  meshopt_optimizeVertexCache(made.indices.data(), level.indices.data(), level.indices.size(), level.vertices);
  return level.indices.size();
}

std::size_t meshopt_strips(const LevelList& level, Made& made) {
  return meshopt_stripify(made.indices.data(), made.ordered.data(), made.ordered.size(), level.vertices, restart_index);
}

/// With the order that meshopt_stripify wants.
std::size_t meshopt_ordered_strips(const LevelList& level, Made& made) {
  find_order(level, made);
  return meshopt_strips(level, made);
}

/// Its strips have no swaps. The mesh is made, and its strips are written as indices, while the clock stands still.
void openmesh_strips(benchmark::State& state, const std::string& name, int percent) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  const LevelList& level = level_list(name, percent);
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices(level.vertices);
  for (Mesh::VertexHandle& v : vertices) v = mesh.add_vertex({0, 0, 0});
  for (std::size_t i = 0; i < level.indices.size(); i += 3)
    mesh.add_face(vertices[level.indices[i]], vertices[level.indices[i + 1]], vertices[level.indices[i + 2]]);
  OpenMesh::StripifierT<Mesh> stripifier(mesh);
  tools::Medians time;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { stripifier.stripify(); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  std::vector<std::uint32_t> indices;
  for (const auto& strip : stripifier) {
    if (!indices.empty()) indices.push_back(restart_index);
    indices.insert(indices.end(), strip.begin(), strip.end());
  }
  count(state, time.nanoseconds(), 4 * indices.size(), indices, level);
}

#ifdef RESTRIP_RM_TRISTRIPPER
std::size_t tristripper_strips(const LevelList& level, Made& made) {
  made.indices.resize(2 * level.indices.size() + 4);
  return tristripper_indices(level.indices.data(), level.indices.size(), made.indices.data());
}
#endif

void register_level(const std::string& name, int percent) {
  const std::string stem = "level/" + name + "/" + std::to_string(percent) + "/";
  const auto add = [&](const std::string& who, auto run) { add_timed(stem + who, run); };
  const auto add_kept = [&](const std::string& who, const Method& method, StripForm form) {
    add(who, [name, &method, form, percent](benchmark::State& state) { keep(state, name, method, form, percent); });
  };
  const auto add_made = [&](const std::string& who, auto indices_of, bool order_is_given = false) {
    add(who, [=](benchmark::State& state) { make(state, name, percent, order_is_given, indices_of); });
  };
  for (const Method& method : tools::methods())
    if (method.kind == Method::Kind::ours && is_measured(name, method))
      add_kept(method.name, method, StripForm::restart);
  add_kept("list", method_named("bare"), StripForm::list);
  add_made("stripify_fast", own_strips);
  add_made("meshopt_strips", meshopt_ordered_strips);
  add_made("meshopt_order_given", meshopt_strips, true);
  add("openmesh", [=](benchmark::State& state) { openmesh_strips(state, name, percent); });
#ifdef RESTRIP_RM_TRISTRIPPER
  add_made("rm_tristripper", tristripper_strips);
#endif
  add_made("meshopt_list", meshopt_list);
}

}  // namespace

void register_benchmarks() {
  for (const std::string& name : subject_names())
    for (const int percent : percents) register_level(name, percent);
}

}  // namespace restrip::bench
