// A whole replay, from 2 % of the triangles to all of them and back: each policy, under its default cost, alternates
// with the bare mesh; in nanoseconds an operation.
#include <benchmark/benchmark.h>

#include "common/stopwatch.hpp"
#include "restrip/output/strips.hpp"
#include "shared.hpp"

namespace restrip::bench {
namespace {

void count_strips(benchmark::State& state, const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  const auto triangles = static_cast<double>(mesh.triangle_count());
  state.counters["triangles"] = triangles;
  state.counters["strips"] = static_cast<double>(strips.size());
  state.counters["indices_per_triangle"] = static_cast<double>(strip_index_count(mesh, strips)) / triangles;
}

void replay(benchmark::State& state, const std::string& name, const Method& method) {
  Player with(name, method);
  Player bare(name, method_named("bare"));
  const std::size_t top = subject(name).mesh.splits.size();
  tools::Medians up;
  tools::Medians down;
  tools::Medians up_bare;
  tools::Medians down_bare;
  for ([[maybe_unused]] auto _ : state) {
    with.restart();
    up.time([&] { with.up_to(top); });
    if (!state.counters.contains("strips")) count_strips(state, with.mesh());
    down.time([&] { with.down_to(0); });
    bare.restart();
    up_bare.time([&] { bare.up_to(top); });
    down_bare.time([&] { bare.down_to(0); });
    state.SetIterationTime(up.nanoseconds() * 1e-9);
  }
  const auto each = static_cast<double>(top);
  state.counters["split_ns"] = up.nanoseconds() / each;
  state.counters["split_bare_ns"] = up_bare.nanoseconds() / each;
  state.counters["collapse_ns"] = down.nanoseconds() / each;
  state.counters["collapse_bare_ns"] = down_bare.nanoseconds() / each;
}

}  // namespace

void register_benchmarks() {
  for (const std::string& name : subject_names()) {
    for (const Method& method : tools::methods()) {
      if (method.kind == Method::Kind::mesh || method.kind == Method::Kind::paper || !is_measured(name, method))
        continue;
      auto* registered =
          benchmark::RegisterBenchmark(("replay/" + name + "/" + method.name).c_str(),
                                       [name, &method](benchmark::State& state) { replay(state, name, method); });
      registered->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);
      // The searches take so long there that one run is enough.
      if (name == "dragon" && method.searches()) registered->Repetitions(1);
    }
  }
}

}  // namespace restrip::bench
