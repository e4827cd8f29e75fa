// Batches of disjoint operations on one and two threads, compared with the plain loop. Real time: a batch is as slow as
// its slowest thread.
#include "restrip/operations/batch.hpp"

#include <benchmark/benchmark.h>

#include <chrono>

#include "meshes/made_mesh.hpp"
#include "restrip/search/stripify.hpp"
#include "shared.hpp"

namespace restrip::bench {
namespace {

/// A made mesh with strips, and collapses all over it.
struct Ground {
  StripMesh mesh;
  Sites sites;
};

const Ground& large_ground() {
  static const Ground made = [] {
    const tools::Soup soup = tools::make_mesh(settings().quick ? 2'000 : 1'000'000);
    Ground ground{StripMesh::build(soup.triangles, soup.points.size()), {}};
    stripify(ground.mesh, Effort::fast, Cost::strips());
    ground.sites = spread_out_sites(ground.mesh, settings().quick ? 64 : 20'000);
    return ground;
  }();
  return made;
}

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// `threads` 0: one by one, no batch.
void batch(benchmark::State& state, unsigned threads, bool checked) {
  const Ground& g = large_ground();
  const BatchOptions options{threads, checked};
  double down = 0;
  double up = 0;
  for ([[maybe_unused]] auto _ : state) {
    StripMesh mesh = g.mesh;
    const std::vector<StripMesh::Halfedge>& chords = g.sites.chords;
    const double took_down = seconds([&] {
      if (threads != 0)
        collapse_batch(mesh, chords, options);
      else
        for (const StripMesh::Halfedge chord : chords) collapse(mesh, chord);
    });
    std::vector<SplitRequest> requests;
    for (const tools::Record& record : g.sites.records) requests.push_back({spokes_of(mesh, record), record.v_t});
    const double took_up = seconds([&] {
      if (threads != 0)
        split_batch(mesh, requests, options);
      else
        for (const SplitRequest& request : requests) split(mesh, request.where, request.new_vertex);
    });
    down += took_down;
    up += took_up;
    state.SetIterationTime(took_down + took_up);
  }
  const double each = 1e-9 * static_cast<double>(state.iterations()) * static_cast<double>(g.sites.size());
  state.counters["collapse_ns"] = down / each;
  state.counters["split_ns"] = up / each;
}

}  // namespace

void register_benchmarks() {
  const auto add = [](const std::string& name, unsigned threads, bool checked) {
    benchmark::RegisterBenchmark(("batch/" + name).c_str(),
                                 [=](benchmark::State& state) { batch(state, threads, checked); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(3);
  };
  add("loop", 0, true);
  for (const unsigned threads : {1U, 2U}) {
    add("checked_before/" + std::to_string(threads), threads, true);
    add("checking/" + std::to_string(threads), threads, false);
  }
}

}  // namespace restrip::bench
