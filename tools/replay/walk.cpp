#include "replay/walk.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>

#include "common/progress.hpp"
#include "common/random.hpp"
#include "lod/coloring_check.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Split = VertexSplit;

/// Strips and isolated triangles of a mesh, or a change in them.
struct Account {
  std::int64_t strips = 0;
  std::int64_t isolated = 0;
  friend Account operator+(const Account& a, const Account& b) {
    return {a.strips + b.strips, a.isolated + b.isolated};
  }
};

Account count(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  return {static_cast<std::int64_t>(report.strips), static_cast<std::int64_t>(report.isolated)};
}

/// Takes steps on one mesh. The effect of a step depends on the seed, its number and the mesh.
class Walker {
 public:
  Walker(StripMesh& mesh, std::uint64_t seed, std::size_t home_size, const BeginMaintainer& begin)
      : mesh_(mesh), seed_(seed), home_size_(home_size), maintainer_(begin(mesh)) {}

  /// Takes one step. Returns the fault that it caused, if any.
  std::string step(std::uint64_t number) {
    Random random(seed_ + number * 0xD1B54A32D192ED03U);
    const Halfedge h = somewhere(random);
    if (h.id == none) return {};
    const std::uint32_t dice = random.below(12);
    // A mesh that has grown is shrunk, and vice versa.
    const std::uint32_t splits = mesh_.triangle_count() > home_size_ ? 3 : 5;
    if (dice < splits) return try_split(h, random);
    if (dice < 8) return try_collapse(random.below(2) == 0 ? h : mesh_.opposite(h));
    return try_flip(h);
  }

  /// Checks the whole mesh, the reported changes of strips and isolated triangles, and the maintainer's data. `start`:
  /// the counts before the first step.
  [[nodiscard]] std::string whole_fault(const Account& start) const {
    const std::vector<std::string> faults = find_faults(mesh_);
    if (!faults.empty()) return faults.front();
    const Account there = count(mesh_);
    const Account expected = start + reported;
    if (there.strips != expected.strips)
      return fmt::format("{} strips, but the operations' own account says {}", there.strips, expected.strips);
    if (there.isolated != expected.isolated)
      return fmt::format("{} isolated triangles, but the operations' own account says {}", there.isolated,
                         expected.isolated);
    return maintainer_->fault();
  }

  WalkReport report;
  Account reported;  ///< the sum of the changes that the operations reported

 private:
  Halfedge somewhere(Random& random) const {
    for (unsigned attempt = 0; attempt < 8; ++attempt) {
      const Triangle t = random.below(static_cast<std::uint32_t>(mesh_.triangle_bound()));
      const unsigned side = random.below(3);
      if (mesh_.alive(t)) return StripMesh::halfedge(t, side);
    }
    return {none};
  }

  std::string try_split(Halfedge h, Random& random) {
    const Vertex v = mesh_.from(h);
    if (mesh_.non_manifold(v)) return refuse();
    std::vector<Halfedge>& spokes = spokes_;
    spokes.clear();
    for_each_spoke(mesh_, v, [&](Halfedge spoke) { spokes.push_back(spoke); });
    const auto any = [&] { return spokes[random.below(static_cast<std::uint32_t>(spokes.size()))]; };
    Split where{any(), any(), Split::Spokes::both};
    const std::uint32_t kind = random.below(6);
    if (mesh_.leaves_boundary(h) && kind < 2)
      where.spokes = kind == 0 ? Split::Spokes::left_only : Split::Spokes::right_only;
    if (check_split(mesh_, where) != Refusal::granted) return refuse();
    const auto done = maintainer_->split(where, none, no_record);
    ++report.splits;
    report.isolating += done.isolated > 0 ? 1 : 0;
    return settle(done, {mesh_.from(done.halfedge), mesh_.to(done.halfedge), none, none});
  }

  std::string try_collapse(Halfedge chord) {
    if (check_collapse(mesh_, chord) != Refusal::granted) return refuse();
    const auto done = maintainer_->collapse(chord, no_record);
    ++report.collapses;
    report.isolating += done.isolated > 0 ? 1 : 0;
    return settle(done, {mesh_.from(done.halfedge), none, none, none});
  }

  std::string try_flip(Halfedge h) {
    if (check_flip(mesh_, h) != Refusal::granted) return refuse();
    const std::array<Vertex, 2> ends{mesh_.from(h), mesh_.to(h)};
    const auto done = maintainer_->flip(h);
    ++report.flips;
    report.flips_isolating += done.isolated > 0 ? 1 : 0;
    return settle(done, {mesh_.from(done.halfedge), mesh_.to(done.halfedge), ends[0], ends[1]});
  }

  std::string refuse() {
    ++report.refused;
    return {};
  }

  std::string settle(const Rewrite& done, const std::array<Vertex, 4>& around) {
    const ColoringChange between = maintainer_->between();
    reported = reported + Account{done.strips + between.strips, done.isolated + between.isolated};
    for (const Vertex v : around) {
      if (v == none) continue;
      if (std::string fault = find_fault_around(mesh_, v); !fault.empty()) return fault;
    }
    return {};
  }

  StripMesh& mesh_;
  std::uint64_t seed_;
  std::size_t home_size_;
  std::unique_ptr<Maintainer> maintainer_;
  std::vector<Halfedge> spokes_;
};

LiveBufferReport measured_walk(StripMesh mesh, std::size_t operations_per_update, const WalkOptions& options,
                               const BeginMaintainer& begin, std::vector<std::string>& faults) {
  Walker walker(mesh, options.seed, mesh.triangle_count(), begin);
  LiveMeasure measure(mesh, options.buffer, operations_per_update, 2 * mesh.triangle_count());
  measure.look("start", faults);
  Progress progress("keeping an index buffer", options.steps);
  for (std::uint64_t step = 0, done = 0; step < options.steps; progress.at(step++)) {
    walker.step(step);
    if (walker.report.operations() != done) measure.count_operation();
    done = walker.report.operations();
  }
  measure.look("end", faults);
  return measure.report();
}

}  // namespace

WalkReport walk(StripMesh& mesh, const WalkOptions& options, const BeginMaintainer& begin) {
  if (const std::vector<std::string> faults = find_faults(mesh); !faults.empty()) {
    WalkReport report;
    report.options = options;
    report.fault = faults.front();
    return report;
  }
  const std::size_t home_size = mesh.triangle_count();
  Walker walker(mesh, options.seed, home_size, begin);
  const Account start = count(mesh);
  const StripMesh home = mesh;
  std::string fault;
  std::uint64_t step = 0;
  Progress progress("walking", options.steps);
  for (; step < options.steps && fault.empty(); ++step) {
    fault = walker.step(step);
    progress.at(step);
    const bool whole = (step + 1) % options.whole_check_every == 0 || step + 1 == options.steps;
    if (fault.empty() && whole) fault = walker.whole_fault(start);
    if (!fault.empty()) break;
  }
  WalkReport report = walker.report;
  report.options = options;
  report.fault = fault;
  if (!fault.empty()) {
    report.fault_step = step;
    return report;
  }
  report.triangles = mesh.triangle_count();
  const Account end = start + walker.reported;  // just confirmed by a recount
  report.strips = static_cast<std::size_t>(end.strips);
  report.isolated = static_cast<std::size_t>(end.isolated);
  std::vector<std::string> faults;
  for (const std::size_t operations : options.buffer.operations_per_update)
    report.live_buffers.push_back(measured_walk(home, operations, options, begin, faults));
  if (!faults.empty()) report.fault = faults.front();
  return report;
}

}  // namespace restrip::tools
