#include "replay/ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "lod/coloring_check.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;

/// The mesh alone: new and joined dual edges are dashed.
struct Bare : PlainOperations {
  StripMesh& mesh;
  explicit Bare(StripMesh& on) : mesh(on) {}
  Halfedge split(const Where& where, Vertex v_t, std::size_t) { return mesh.insert_vertex(where, v_t); }
  Halfedge collapse(Halfedge chord, std::size_t) { return mesh.remove_vertex(chord); }
  Halfedge flip(Halfedge h) { return mesh.turn_edge(h); }
};

/// Keeps strips by the library, under a policy or with baked strips.
struct LibraryOperations : PlainOperations {
  Keeper<StripMesh> keeper;
  const BakedRecords<Halfedge>* records = nullptr;
  Witness witness;

  LibraryOperations(StripMesh& mesh, Policy policy, const Beginning& with) : keeper(mesh, policy, with.cost) {
    keeper.set_search(with.search);
    IndexPlan plan = row_of(policy).plan;
    plan.limits.looks = with.search.states;
    keeper.set_plan(plan);
  }
  LibraryOperations(StripMesh& mesh, const BakedRecords<Halfedge>& of) : keeper(mesh, of), records(&of) {}

  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t record) {
    return records != nullptr ? keeper.split_record(record, where, v_t) : keeper.split(where, v_t);
  }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t record) {
    return records != nullptr ? keeper.collapse_record(record, chord) : keeper.collapse(chord);
  }
  Rewrite<Halfedge> flip(Halfedge h) { return keeper.flip(h); }
  // Played records report changes in strips only, and a record may flip colours anywhere.
  Rewrite<Halfedge> split_and_report(const Where& where, Vertex v_t, std::size_t record) {
    if (records == nullptr || !keeper.baked()->can_split(record)) return split(where, v_t, record);
    return witness.split(keeper.mesh(), where, (*records)[record], [&] { return split(where, v_t, record).halfedge; });
  }
  Rewrite<Halfedge> collapse_and_report(Halfedge chord, std::size_t record) {
    if (records == nullptr || !keeper.baked()->can_collapse(record)) return collapse(chord, record);
    return witness.collapse(keeper.mesh(), chord, (*records)[record], [&] { return collapse(chord, record).halfedge; });
  }
  void restart(std::size_t level) {
    if (records != nullptr) keeper.baked()->restart(level);
    keeper.rebuild();
  }
  [[nodiscard]] RuleCounts rule_counts() const { return keeper.rule_counts(); }
  [[nodiscard]] std::string fault() const {
    if (!(keeper.weights() == Cost::strips())) return find_fault(keeper);
    return keeper.locator() != nullptr ? find_fault(keeper.mesh(), *keeper.locator()) : std::string();
  }
};

/// Records the operations of another upkeep.
class TracedOperations : public PlainOperations {
 public:
  TracedOperations(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim, std::optional<Trace>& trace)
      : mesh_(mesh), kept_(std::move(kept)), claim_(claim), trace_(trace) {
    mesh_.watch(&changed_);
    trace_.emplace(mesh_, claim_);
  }
  TracedOperations(const TracedOperations&) = delete;
  TracedOperations& operator=(const TracedOperations&) = delete;
  ~TracedOperations() { mesh_.watch(nullptr); }

  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t record) {
    const auto done = kept_->split(where, v_t, record);
    return added(Traced::Kind::split, mesh_.from(done.halfedge), mesh_.to(done.halfedge), done);
  }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t record) {
    const Vertex v_s = mesh_.from(chord);
    const Vertex v_t = mesh_.to(chord);
    return added(Traced::Kind::collapse, v_s, v_t, kept_->collapse(chord, record));
  }
  Rewrite<Halfedge> flip(Halfedge h) {
    const Vertex from = mesh_.from(h);
    const Vertex to = mesh_.to(h);
    return added(Traced::Kind::flip, from, to, kept_->flip(h));
  }
  Repair between() {
    const Repair done = kept_->between();
    if (!changed_.empty()) add({Traced::Kind::other, 0, 0, done.strips, done.isolated});
    return done;
  }
  void restart(std::size_t level) {
    kept_->restart(level);
    changed_.clear();
    trace_.emplace(mesh_, claim_);
  }
  [[nodiscard]] std::string fault() const { return kept_->fault(); }
  [[nodiscard]] RuleCounts rule_counts() const { return kept_->rule_counts(); }

 private:
  void add(const Traced& done) {
    trace_->add(mesh_, changed_, done);
    changed_.clear();
  }
  Rewrite<Halfedge> added(Traced::Kind kind, Vertex from, Vertex to, const Rewrite<Halfedge>& done) {
    add({kind, from, to, done.strips, done.isolated});
    return done;
  }

  StripMesh& mesh_;
  std::unique_ptr<Upkeep> kept_;
  Trace::Claim claim_;
  std::optional<Trace>& trace_;
  std::vector<Triangle> changed_;
};

template <class Operations, class... Arguments>
std::unique_ptr<Upkeep> begin_by(StripMesh& mesh, Arguments&&... arguments) {
  return std::make_unique<UpkeepBy<Operations>>(mesh, std::forward<Arguments>(arguments)...);
}
Way kept(const PolicyRow& row) {
  const Policy policy = row.policy;
  const std::string says = policy == Policy::rules
                               ? "the rule of each operation and nothing else"
                               : fmt::format("the rule, then {}; for indices {}", row.says, row.says_indices);
  Way way{row.name, says, policy == Policy::rules ? Way::Kind::rules : Way::Kind::ours,
          [policy](StripMesh& mesh, const Beginning& with) { return begin_by<LibraryOperations>(mesh, policy, with); }};
  way.search = row.search;
  way.weighed = {row.plan.limits.looks, 0};
  return way;
}

Way baked() {
  Way way{"baked", "strips precomputed for every level and played back", Way::Kind::ours,
          [](StripMesh& mesh, const Beginning& with) {
            if (with.baked == nullptr) throw std::invalid_argument("baked strips need a baked mesh");
            return begin_by<LibraryOperations>(mesh, with.baked->records);
          }};
  way.bakes = true;
  return way;
}

}  // namespace

const std::vector<Way>& ways() {
  static const std::vector<Way> listed = [] {
    std::vector<Way> all;
    for (const PolicyRow& row : policies)
      if (row.policy == Policy::bare)
        all.push_back({row.name, row.says, Way::Kind::mesh,
                       [](StripMesh& mesh, const Beginning&) { return begin_by<Bare>(mesh); }});
      else
        all.push_back(kept(row));
    all.push_back(baked());
    for (Way& way : paper_ways()) all.push_back(std::move(way));
    return all;
  }();
  return listed;
}

const Way& way_named(const std::string& name) {
  const auto found = std::find_if(ways().begin(), ways().end(), [&](const Way& way) { return way.name == name; });
  if (found == ways().end()) throw std::invalid_argument("unknown policy: " + name);
  return *found;
}

const Way& usual_way(bool strips_are_baked) {
  return way_named(strips_are_baked ? baked().name : row_of(default_policy).name);
}

Plan::Plan(const Way& way, const ProgressiveMesh& mesh, const Given& given)
    : way_(&way), mesh_(&mesh), cost_(given.cost.value_or(way.weighs() ? default_cost : Cost::strips())) {
  search_ = given.search.value_or(way.search_under(cost_));
  if (!(cost_ == Cost::strips()) && !way.weighs())
    throw std::invalid_argument("policy " + way.name + " supports only --cost strips");
  if (way.bakes) {
    baked_ = given.baked;
    if (baked_ == nullptr) {
      BakeReport report;
      made_ = std::make_shared<const BakedMesh>(bake(mesh, {}, &report));
      baked_ = made_.get();
      seconds_ = report.seconds;
    }
    base_ = baked_->base;
  } else if (given.base != nullptr) {
    base_ = *given.base;
  } else {
    base_ = StripMesh::build(mesh.base, mesh.points.size());
    stripify(base_, default_effort, cost_);
  }
}

// What policies do after a rule joins strips or isolated triangles.
Trace::Claim claim_of(const Plan& plan) {
  const Way& way = plan.way();
  if (!(plan.cost() == Cost::strips()) || way.bakes) return Trace::Claim::valid;
  if (way.kind == Way::Kind::rules) return Trace::Claim::best;
  return way.kind == Way::Kind::ours ? Trace::Claim::no_worse : Trace::Claim::valid;
}

std::unique_ptr<Upkeep> traced(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim,
                               std::optional<Trace>& trace) {
  return begin_by<TracedOperations>(mesh, std::move(kept), claim, trace);
}

}  // namespace restrip::tools
