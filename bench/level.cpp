// Moving the level of detail by 1 % of its triangles: our policies go from the strips of one level to the next,
// and keep an index buffer in step (StripBuffer); the others make strips of the new level from scratch, as is necessary
// without rules. All in one run.
//
// The inputs of the others are not counted: a triangle list of the new level with compact vertex numbers, an OpenMesh
// of it, the memory for the result. Bare mesh updates, which they need as well, are not counted either.
#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/StripifierT.hh>
#include <algorithm>
#include <map>

#include "common/stopwatch.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/search/stripify.hpp"
#include "shared.hpp"

namespace restrip::bench {
namespace {

constexpr std::array<int, 3> percents{10, 50, 100};

/// The mesh just below a level, brought there from the base by one method.
struct Below {
  StripMesh mesh;
  std::size_t from = 0;
  std::size_t to = 0;
};

const Below& below(const std::string& name, const Method& method, int percent) {
  static std::map<std::tuple<std::string, std::string, int>, Below> made;
  const std::tuple key{name, method.name, percent};
  if (!made.contains(key)) {
    Player player(name, method);
    for (const int next : percents) {
      const std::size_t from = player.level_of(next * 0.0099);
      player.up_to(from);
      made[{name, method.name, next}] = {player.mesh(), from, player.level_of(next * 0.01)};
    }
  }
  return made[key];
}

void move(benchmark::State& state, const std::string& name, const Method& method, int percent) {
  const Below& start = below(name, method, percent);
  Player player(name, method);
  tools::Medians up;
  tools::Medians down;
  tools::Medians with_buffer;
  const bool keeps_strips = method.kind == Method::Kind::ours;
  std::vector<Triangle> changed;
  for ([[maybe_unused]] auto _ : state) {
    player.restart(start.mesh, start.from);
    // Once up and down first, because a new keeper still has to allocate its memory.
    player.up_to(start.to);
    player.down_to(start.from);
    up.time([&] { player.up_to(start.to); });
    state.SetIterationTime(1e-9 * up.nanoseconds());
    if (keeps_strips && !state.counters.contains("strips")) count_strips(state, player.mesh());
    down.time([&] { player.down_to(start.from); });
    if (!keeps_strips) continue;
    // The same moves with an index buffer, which has to grow at first as well.
    player.restart(start.mesh, start.from);
    StripBuffer buffer(player.mesh());
    changed.clear();
    player.mesh().watch(&changed);
    const auto update = [&] {
      benchmark::DoNotOptimize(buffer.update(player.mesh(), changed).data());
      changed.clear();
    };
    player.up_to(start.to);
    update();
    player.down_to(start.from);
    update();
    with_buffer.time([&] {
      player.up_to(start.to);
      update();
    });
    player.mesh().watch(nullptr);
    state.counters["buffer_indices_per_triangle"] =
        static_cast<double>(buffer.indices().size()) / static_cast<double>(player.mesh().triangle_count());
  }
  state.counters["operations"] = static_cast<double>(start.to - start.from);
  state.counters["up_ns"] = up.nanoseconds();
  state.counters["down_ns"] = down.nanoseconds();
  if (keeps_strips) state.counters["up_with_buffer_ns"] = with_buffer.nanoseconds();
}

/// As it is, after the order that makes good strips was found under the clock, or before.
enum class Order { as_it_is, found, given };

void run_meshoptimizer(benchmark::State& state, const std::string& name, int percent, Order order) {
  const LevelList& list = level_list(name, percent);
  std::vector<std::uint32_t> ordered = list.indices;
  const auto find_order = [&] {
    meshopt_optimizeVertexCacheStrip(ordered.data(), list.indices.data(), list.indices.size(), list.vertices);
  };
  if (order == Order::given) find_order();
  std::vector<std::uint32_t> strips(meshopt_stripifyBound(list.indices.size()));
  std::size_t count = 0;
  tools::Medians time;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] {
      if (order == Order::found) find_order();
      count = meshopt_stripify(strips.data(), ordered.data(), ordered.size(), list.vertices, restart_index);
    });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  state.counters["up_ns"] = time.nanoseconds();
  const auto restarts = std::count(strips.begin(), strips.begin() + static_cast<std::ptrdiff_t>(count), restart_index);
  count_strips(state, list.indices.size() / 3, static_cast<std::size_t>(restarts) + 1, count);
}

void run_openmesh(benchmark::State& state, const std::string& name, int percent) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  const LevelList& list = level_list(name, percent);
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices(list.vertices);
  for (Mesh::VertexHandle& v : vertices) v = mesh.add_vertex({0, 0, 0});
  for (std::size_t i = 0; i < list.indices.size(); i += 3)
    mesh.add_face(vertices[list.indices[i]], vertices[list.indices[i + 1]], vertices[list.indices[i + 2]]);
  OpenMesh::StripifierT<Mesh> stripifier(mesh);
  tools::Medians time;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { stripifier.stripify(); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  std::size_t indices = stripifier.n_strips() - 1;
  for (const auto& strip : stripifier) indices += strip.size();
  state.counters["up_ns"] = time.nanoseconds();
  count_strips(state, mesh.n_faces(), stripifier.n_strips(), indices);
}

void run_from_scratch(benchmark::State& state, const std::string& name, int percent) {
  StripMesh mesh = level_list(name, percent).mesh;
  tools::Medians time;
  tools::Medians indices;
  for ([[maybe_unused]] auto _ : state) {
    time.time([&] { stripify_fast(mesh); });
    indices.time([&] { benchmark::DoNotOptimize(strip_indices(mesh, extract_strips(mesh)).data()); });
    state.SetIterationTime(1e-9 * time.nanoseconds());
  }
  state.counters["up_ns"] = time.nanoseconds();
  state.counters["up_with_buffer_ns"] = time.nanoseconds() + indices.nanoseconds();
  count_strips(state, mesh);
}

}  // namespace

void register_benchmarks() {
  for (const std::string& name : subject_names()) {
    for (const int percent : percents) {
      const std::string stem = "level/" + name + "/" + std::to_string(percent) + "/";
      const auto add = [&](const std::string& who, auto run) { add_timed(stem + who, run); };
      for (const Method& method : tools::methods())
        if ((method.kind == Method::Kind::ours || method.kind == Method::Kind::mesh) && is_measured(name, method))
          add(method.name, [name, &method, percent](benchmark::State& state) { move(state, name, method, percent); });
      for (const auto& [who, order] : {std::pair{"meshopt_as_it_is", Order::as_it_is},
                                       {"meshopt_ordered", Order::found},
                                       {"meshopt_order_given", Order::given}})
        add(who, [name = name, percent = percent, order = order](benchmark::State& state) {
          run_meshoptimizer(state, name, percent, order);
        });
      add("openmesh", [name, percent](benchmark::State& state) { run_openmesh(state, name, percent); });
      add("stripify_fast", [name, percent](benchmark::State& state) { run_from_scratch(state, name, percent); });
    }
  }
}

}  // namespace restrip::bench
