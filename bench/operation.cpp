// One operation, hot: splits, collapses and flips spread over a small mesh that fits in the second-level cache, in
// every way against the bare mesh update by turns; and the parts of a split one by one.
#include <benchmark/benchmark.h>

#include <memory>

#include "common/stopwatch.hpp"
#include "settings.hpp"
#include "spread.hpp"
#include "way.hpp"

namespace restrip::bench {
namespace {

const Ground& small_ground() {
  static const Ground made =
      settings().quick ? make_ground(2'000, Effort::full, 32) : make_ground(20'000, Effort::full, 512);
  return made;
}

/// One pass over all sites in one way: down, up, up by way of the vertices, and two flips of every chord.
struct Pass {
  explicit Pass(const Way& way) : mesh_(small_ground().mesh), upkeep_(way.begin(mesh_, {way.search})) {}

  void run() {
    const Ground& g = small_ground();
    mesh_ = g.mesh;
    upkeep_->restart(0);
    std::vector<Halfedge> chords = g.sites.chords;
    std::vector<tools::NamedSplit> splits;
    collapse.time([&] { upkeep_->collapse_all(chords); });
    for (const tools::Record& record : g.sites.records) splits.push_back({spokes_of(mesh_, record), record.v_t});
    split.time([&] { upkeep_->split_all(splits, chords); });
    upkeep_->collapse_all(chords);
    split_from_vertices.time([&] { upkeep_->play_up(g.sites.records, 0); });
    chords.clear();
    for (const tools::Record& record : g.sites.records) {
      const Halfedge chord = mesh_.spoke(record.v_s, record.v_t);
      if (check_flip(mesh_, chord) == Refusal::granted) chords.push_back(chord);
    }
    flips = chords.size();
    flip.time([&] { upkeep_->flip_all(chords); });
  }

  tools::Medians split;
  tools::Medians split_from_vertices;
  tools::Medians collapse;
  tools::Medians flip;
  std::size_t flips = 1;

 private:
  StripMesh mesh_;
  std::unique_ptr<tools::Upkeep> upkeep_;
};

void operation(benchmark::State& state, const Way& way) {
  Pass with(way);
  Pass bare(way_named("bare"));
  for ([[maybe_unused]] auto _ : state) {
    with.run();
    bare.run();
    state.SetIterationTime(1e-9 * (with.split.nanoseconds() + with.collapse.nanoseconds()));
  }
  const auto each = static_cast<double>(small_ground().sites.size());
  const auto report = [&state](const std::string& what, double ns, double bare_ns) {
    state.counters[what + "_ns"] = ns;
    state.counters[what + "_bare_ns"] = bare_ns;
  };
  report("split", with.split.nanoseconds() / each, bare.split.nanoseconds() / each);
  report("split_from_vertices", with.split_from_vertices.nanoseconds() / each,
         bare.split_from_vertices.nanoseconds() / each);
  report("collapse", with.collapse.nanoseconds() / each, bare.collapse.nanoseconds() / each);
  report("flip", with.flip.nanoseconds() / static_cast<double>(with.flips),
         bare.flip.nanoseconds() / static_cast<double>(bare.flips));
}

/// The parts of a split and of a collapse, each in a pass of its own: read the colours, look the rule up, change the
/// mesh, write the colours.
void parts(benchmark::State& state) {
  const Ground& g = small_ground();
  const std::size_t n = g.sites.size();
  const std::vector<tools::Record>& records = g.sites.records;
  const std::vector<Halfedge>& chords = g.sites.chords;
  struct Work {
    VertexSplit<Halfedge> where;
    detail::InteriorFan<Halfedge> fan;
    Word ring = 0;
    Rule rule;
    Halfedge at;
  };
  std::array<tools::Medians, 8> times;
  for ([[maybe_unused]] auto _ : state) {
    StripMesh mesh = g.mesh;
    std::vector<Work> work(n);
    const auto pass = [&](std::size_t part, auto&& one) {
      times[part].time([&] {
        for (std::size_t i = 0; i < n; ++i) one(work[i], i);
      });
    };
    const auto moved = [](const Work& w) {
      return std::span<const Halfedge>(w.fan.spokes + w.fan.a - 1, w.fan.k - w.fan.a);
    };
    pass(0, [&](Work& w, std::size_t i) { detail::read_ring(mesh, chords[i], w.fan, w.ring); });
    pass(1, [&](Work& w, std::size_t) { w.rule = collapse_rule({w.fan.k, w.fan.a}, w.ring, w.fan.ports); });
    pass(2, [&](Work& w, std::size_t i) { w.at = mesh.remove_vertex(chords[i], moved(w)); });
    pass(3, [&](Work& w, std::size_t) {
      w.fan.dash(mesh, w.rule.colors);
      detail::light_fan(mesh, w.fan, w.at, w.rule.colors);
    });
    for (std::size_t i = 0; i < n; ++i) work[i] = {spokes_of(mesh, records[i]), {}, 0, {}, {}};
    pass(4, [&](Work& w, std::size_t) { detail::read_interior_fan(mesh, w.where.left, w.where.right, w.fan); });
    pass(5, [&](Work& w, std::size_t) { w.rule = split_rule({w.fan.k, w.fan.a}, w.fan.loop, w.fan.ports); });
    pass(6, [&](Work& w, std::size_t i) {
      w.at = mesh.insert_vertex(w.where.left, w.where.right, moved(w), records[i].v_t);
    });
    pass(7, [&](Work& w, std::size_t) {
      w.fan.dash(mesh, detail::kept_loop(w.fan.k, w.fan.a, w.rule.colors));
      detail::light_ring(mesh, w.fan, w.at, w.rule.colors);
    });
    state.SetIterationTime(1e-9 * (times[4].nanoseconds() + times[5].nanoseconds() + times[7].nanoseconds()));
  }
  const char* names[] = {"collapse_gather_ns", "collapse_lookup_ns", "collapse_mesh_ns", "collapse_scatter_ns",
                         "split_gather_ns",    "split_lookup_ns",    "split_mesh_ns",    "split_scatter_ns"};
  for (std::size_t i = 0; i < times.size(); ++i)
    state.counters[names[i]] = times[i].nanoseconds() / static_cast<double>(n);
}

}  // namespace

void register_benchmarks() {
  for (const Way& way : tools::ways()) {
    if (way.kind == Way::Kind::mesh || way.kind == Way::Kind::paper || way.bakes) continue;
    benchmark::RegisterBenchmark(("operation/" + way.name).c_str(),
                                 [&way](benchmark::State& state) { operation(state, way); })
        ->UseManualTime()
        ->Iterations(settings().quick ? 3 : 31);
  }
  benchmark::RegisterBenchmark("parts", parts)->UseManualTime()->Iterations(settings().quick ? 3 : 101);
}

}  // namespace restrip::bench
