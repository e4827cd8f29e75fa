// From ten thousand to twenty million triangles: bytes a triangle and nanoseconds an operation. Collapses at random
// places of a made mesh, each patch cold unless the mesh fits in a cache, and the splits that undo them; for the bare
// mesh and the rules also next to each other, as when one part of the mesh is edited.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <span>

#include "common/stopwatch.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/stripify.hpp"
#include "shared.hpp"

namespace restrip::bench {
namespace {

/// The bytes that this process has allocated by glibc.
double allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// One mesh at a time: the largest takes a gigabyte while it is made.
struct LargeGround {
  std::size_t triangles = 0;
  StripMesh mesh;
  Sites spread;
  Sites neighboring;
};

const LargeGround& ground(std::size_t triangles) {
  static LargeGround g;
  if (g.triangles == triangles) return g;
  g = {};
  const tools::Soup soup = tools::make_mesh(triangles);
  g.mesh = StripMesh::build(soup.triangles, soup.points.size());
  stripify(g.mesh, Effort::fast, default_cost);
  // More than a cache can hold, so that the way up does not hit data of the way down.
  const std::size_t count = std::min<std::size_t>(triangles / 25, settings().quick ? 100 : 100'000);
  g.spread = spread_out_sites(g.mesh, count);
  g.neighboring = neighboring_sites(g.mesh, std::min<std::size_t>(count, 4'000));
  g.triangles = triangles;
  return g;
}

void scale(benchmark::State& state, std::size_t triangles, const Method& method, bool side_by_side) {
  const LargeGround& g = ground(triangles);
  std::span<const tools::Record> sites = side_by_side ? g.neighboring.records : g.spread.records;
  // The searches take long and examine so much that fewer places are enough.
  if (method.searches()) sites = sites.first(std::min<std::size_t>(sites.size(), 20'000));
  const double before = allocated_bytes();
  StripMesh mesh = g.mesh;
  const double with_mesh = allocated_bytes();
  const Cost cost = method.weighs() ? default_cost : Cost::strips();
  const auto maintainer = method.begin(mesh, {method.search_under(cost), cost});
  tools::Medians down;
  tools::Medians up;
  for ([[maybe_unused]] auto _ : state) {
    down.time([&] { maintainer->play_down(sites, 0); });
    up.time([&] { maintainer->play_up(sites, 0); });
    state.SetIterationTime(1e-9 * (down.nanoseconds() + up.nanoseconds()));
  }
  const double with_keeper = allocated_bytes();  // searches make their room when they begin
  const auto each = static_cast<double>(sites.size());
  const auto all = static_cast<double>(g.mesh.triangle_count());
  state.counters["triangles"] = all;
  state.counters["sites"] = each;
  state.counters["collapse_ns"] = down.nanoseconds() / each;
  state.counters["split_ns"] = up.nanoseconds() / each;
  state.counters["mesh_bytes"] = (with_mesh - before) / all;
  state.counters["keeper_bytes"] = (with_keeper - with_mesh) / all;
}

/// The memory of an index buffer kept in step.
void buffer_memory(benchmark::State& state, std::size_t triangles) {
  const LargeGround& g = ground(triangles);
  for ([[maybe_unused]] auto _ : state) {
    const double before = allocated_bytes();
    LiveBuffer buffer({.width = IndexWidth::bits32});
    const double time = tools::nanoseconds_of([&] { buffer.rebuild(g.mesh); });
    const auto all = static_cast<double>(g.mesh.triangle_count());
    state.counters["triangles"] = all;
    state.counters["buffer_bytes"] = (allocated_bytes() - before) / all;
    state.SetIterationTime(1e-9 * time);
  }
}

}  // namespace

void register_benchmarks() {
  std::vector<std::size_t> sizes{10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000, 20'000'000};
  if (settings().quick) sizes = {2'000, 8'000};
  for (const std::size_t size : sizes) {
    const auto add = [size](const std::string& what, auto run) {
      auto* registered = benchmark::RegisterBenchmark(("scale/" + std::to_string(size) + "/" + what).c_str(), run);
      registered->UseManualTime()->Unit(benchmark::kMillisecond);
      registered->Iterations(settings().quick ? 3 : size < 1'000'000 ? 15 : 5);
      // Meshes are made for one size after the other, and repeated inside.
      registered->Repetitions(1);
    };
    for (const bool side_by_side : {false, true})
      for (const char* name : {"bare", "local"})
        add(std::string(side_by_side ? "side_by_side/" : "random/") + name,
            [=](benchmark::State& state) { scale(state, size, method_named(name), side_by_side); });
    for (const char* name : {"quick", "full"})
      add(std::string("random/") + name,
          [=](benchmark::State& state) { scale(state, size, method_named(name), false); });
    add("buffer", [size](benchmark::State& state) { buffer_memory(state, size); });
  }
}

}  // namespace restrip::bench
