#include "replay/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "lod/coloring_check.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {

void Maintainer::play_up(std::span<const Record> records, std::size_t first) {
  for (const Record& record : records) {
    split_silently(spokes_of(mesh_, record), record.v_t, first++);
    between();
  }
}

void Maintainer::play_down(std::span<const Record> records, std::size_t first) {
  for (std::size_t i = records.size(); i-- > 0;) {
    collapse_silently(mesh_.spoke(records[i].v_s, records[i].v_t), first + i);
    between();
  }
}

namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;

/// The mesh alone: new and joined dual edges are dashed. Reports no changes of strips.
class Bare final : public Maintainer {
 public:
  using Maintainer::Maintainer;
  Rewrite split(const Where& where, Vertex v_t, std::size_t) override {
    return {{}, mesh_.insert_vertex(where, v_t), 0};
  }
  Rewrite collapse(Halfedge chord, std::size_t) override { return {{}, mesh_.remove_vertex(chord), 0}; }
  Rewrite flip(Halfedge h) override { return {{}, mesh_.turn_edge(h), 0}; }
};

/// The library's Keeper under a policy.
class UnderPolicy final : public Maintainer {
 public:
  UnderPolicy(StripMesh& mesh, Policy policy, const MaintainerInputs& with)
      : Maintainer(mesh), keeper_(mesh, policy, with.cost) {
    keeper_.set_search(with.search);
    IndexPlan plan = row_of(policy).plan;
    plan.limits.looks = with.search.states;
    keeper_.set_plan(plan);
  }
  Rewrite split(const Where& where, Vertex v_t, std::size_t) override { return keeper_.split(where, v_t); }
  Rewrite collapse(Halfedge chord, std::size_t) override { return keeper_.collapse(chord); }
  Rewrite flip(Halfedge h) override { return keeper_.flip(h); }
  void restart(std::size_t) override { keeper_.rebuild(); }
  [[nodiscard]] RuleCounts rule_counts() const override { return keeper_.rule_counts(); }
  [[nodiscard]] std::string fault() const override {
    if (!(keeper_.weights() == Cost::strips())) return find_fault(keeper_);
    const StripLocator* const locator = restrip::detail::locator_of(keeper_);
    return locator != nullptr ? find_fault(mesh_, *locator) : std::string();
  }

 private:
  Keeper keeper_;
};

/// Baked strips; operations that are not the next record are done by a Keeper. Played records report changes in strips
/// only, so isolated triangles and the valence are counted here. Outside the patch only the flips of the record change
/// colours.
class Baked final : public Maintainer {
 public:
  Baked(StripMesh& mesh, const BakedRecords& records)
      : Maintainer(mesh), keeper_(mesh, Policy::local, Cost::strips()), records_(records) {}
  Rewrite split(const Where& where, Vertex v_t, std::size_t record) override {
    if (!can_split(record)) return on_its_own().split(where, v_t);
    fan_triangles(mesh_, where.spoke(), patch_);
    const auto valence = static_cast<std::uint32_t>(patch_.size());
    const int before = isolated(record);
    Rewrite done = play_split(where, v_t, record);
    edge_triangles(mesh_, done.halfedge, more_);
    patch_.insert(patch_.end(), more_.begin(), more_.end());
    done.isolated = isolated(record) - before;
    done.valence = valence;
    return done;
  }
  Rewrite collapse(Halfedge chord, std::size_t record) override {
    if (!can_collapse(record)) return on_its_own().collapse(chord);
    edge_triangles(mesh_, chord, patch_);
    const int before = isolated(record);
    Rewrite done = play_collapse(chord, record);
    done.isolated = isolated(record) - before;
    fan_triangles(mesh_, done.halfedge, more_);
    done.valence = static_cast<std::uint32_t>(more_.size());
    return done;
  }
  Rewrite flip(Halfedge h) override { return on_its_own().flip(h); }
  void restart(std::size_t level) override { level_ = level; }
  [[nodiscard]] RuleCounts rule_counts() const override { return keeper_.rule_counts(); }

 private:
  void split_silently(const Where& where, Vertex v_t, std::size_t record) override {
    can_split(record) ? play_split(where, v_t, record) : on_its_own().split(where, v_t);
  }
  void collapse_silently(Halfedge chord, std::size_t record) override {
    can_collapse(record) ? play_collapse(chord, record) : on_its_own().collapse(chord);
  }
  [[nodiscard]] bool can_split(std::size_t record) const { return level_ == record && record < records_.size(); }
  [[nodiscard]] bool can_collapse(std::size_t record) const { return level_ == record + 1; }
  Rewrite play_split(const Where& where, Vertex v_t, std::size_t record) {
    level_ = record + 1;
    return split_baked(mesh_, where, records_[record], v_t);
  }
  Rewrite play_collapse(Halfedge chord, std::size_t record) {
    level_ = record;
    return collapse_baked(mesh_, chord, records_[record]);
  }
  /// For an operation that is not a record.
  Keeper& on_its_own() {
    if (level_) keeper_.forget();
    level_.reset();
    return keeper_;
  }

  /// Isolated triangles of the patch and at the flips of a record, each once; they stay in the patch.
  int isolated(std::size_t record) {
    for (const Halfedge h : records_[record])
      if (mesh_.alive(h)) patch_.insert(patch_.end(), {StripMesh::triangle(h), StripMesh::triangle(mesh_.opposite(h))});
    std::sort(patch_.begin(), patch_.end());
    patch_.erase(std::unique(patch_.begin(), patch_.end()), patch_.end());
    return static_cast<int>(std::count_if(patch_.begin(), patch_.end(),
                                          [this](Triangle t) { return mesh_.alive(t) && mesh_.solid_degree(t) == 0; }));
  }

  Keeper keeper_;
  std::optional<std::size_t> level_ = 0;  // records played, until an operation is not one
  const BakedRecords& records_;
  std::vector<Triangle> patch_;
  std::vector<Triangle> more_;
};

/// Records the operations of another maintainer.
class Traces final : public Maintainer {
 public:
  Traces(StripMesh& mesh, std::unique_ptr<Maintainer> of, Trace::Claim claim, std::optional<Trace>& trace)
      : Maintainer(mesh), traced_(std::move(of)), claim_(claim), trace_(trace) {
    mesh_.watch(&changed_);
    trace_.emplace(mesh_, claim_);
  }
  ~Traces() override { mesh_.watch(nullptr); }

  Rewrite split(const Where& where, Vertex v_t, std::size_t record) override {
    const auto done = traced_->split(where, v_t, record);
    return added(Traced::Kind::split, mesh_.from(done.halfedge), mesh_.to(done.halfedge), done);
  }
  Rewrite collapse(Halfedge chord, std::size_t record) override {
    const Vertex v_s = mesh_.from(chord);
    const Vertex v_t = mesh_.to(chord);
    return added(Traced::Kind::collapse, v_s, v_t, traced_->collapse(chord, record));
  }
  Rewrite flip(Halfedge h) override {
    const Vertex from = mesh_.from(h);
    const Vertex to = mesh_.to(h);
    return added(Traced::Kind::flip, from, to, traced_->flip(h));
  }
  ColoringChange between() override {
    const ColoringChange done = traced_->between();
    if (!changed_.empty()) add({Traced::Kind::other, 0, 0, done.strips, done.isolated});
    return done;
  }
  void restart(std::size_t level) override {
    traced_->restart(level);
    changed_.clear();
    trace_.emplace(mesh_, claim_);
  }
  [[nodiscard]] std::string fault() const override { return traced_->fault(); }
  [[nodiscard]] RuleCounts rule_counts() const override { return traced_->rule_counts(); }

 private:
  void add(const Traced& done) {
    trace_->add(mesh_, changed_, done);
    changed_.clear();
  }
  Rewrite added(Traced::Kind kind, Vertex from, Vertex to, const Rewrite& done) {
    add({kind, from, to, done.strips, done.isolated});
    return done;
  }

  std::unique_ptr<Maintainer> traced_;
  Trace::Claim claim_;
  std::optional<Trace>& trace_;
  std::vector<Triangle> changed_;
};

Method under(const PolicyRow& row) {
  const Policy policy = row.policy;
  const std::string description =
      policy == Policy::rules ? "the rule of each operation and nothing else"
                              : fmt::format("the rule, then {}; for indices {}", row.description, row.for_indices);
  Method method{row.name, description, policy == Policy::rules ? Method::Kind::rules : Method::Kind::ours,
                [policy](StripMesh& mesh, const MaintainerInputs& with) -> std::unique_ptr<Maintainer> {
                  return std::make_unique<UnderPolicy>(mesh, policy, with);
                }};
  method.search = row.search;
  method.weighed = {row.plan.limits.looks, 0};
  return method;
}

Method baked() {
  Method method{"baked", "strips precomputed for every level and played back", Method::Kind::ours,
                [](StripMesh& mesh, const MaintainerInputs& with) -> std::unique_ptr<Maintainer> {
                  if (with.baked == nullptr) throw std::invalid_argument("baked strips need a baked mesh");
                  return std::make_unique<Baked>(mesh, with.baked->records);
                }};
  method.bakes = true;
  return method;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> listed = [] {
    std::vector<Method> all;
    for (const PolicyRow& row : policies)
      if (row.policy == Policy::bare)
        all.push_back({row.name, row.description, Method::Kind::mesh,
                       [](StripMesh& mesh, const MaintainerInputs&) { return std::make_unique<Bare>(mesh); }});
      else
        all.push_back(under(row));
    all.push_back(baked());
    for (Method& method : paper_methods()) all.push_back(std::move(method));
    return all;
  }();
  return listed;
}

const Method& method_named(const std::string& name) {
  const auto found =
      std::find_if(methods().begin(), methods().end(), [&](const Method& method) { return method.name == name; });
  if (found == methods().end()) throw std::invalid_argument("unknown policy: " + name);
  return *found;
}

const Method& default_method(bool strips_are_baked) {
  return method_named(strips_are_baked ? baked().name : row_of(default_policy).name);
}

PreparedMethod::PreparedMethod(const Method& method, const ProgressiveMesh& mesh, const Given& given)
    : method_(&method), mesh_(&mesh), cost_(given.cost.value_or(method.weighs() ? default_cost : Cost::strips())) {
  search_ = given.search.value_or(method.search_under(cost_));
  if (!(cost_ == Cost::strips()) && !method.weighs())
    throw std::invalid_argument("policy " + method.name + " supports only --cost strips");
  if (method.bakes) {
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
Trace::Claim claim_of(const PreparedMethod& prepared) {
  const Method& method = prepared.method();
  if (!(prepared.cost() == Cost::strips()) || method.bakes) return Trace::Claim::valid;
  if (method.kind == Method::Kind::rules) return Trace::Claim::best;
  return method.kind == Method::Kind::ours ? Trace::Claim::no_worse : Trace::Claim::valid;
}

std::unique_ptr<Maintainer> traced(StripMesh& mesh, std::unique_ptr<Maintainer> maintainer, Trace::Claim claim,
                                   std::optional<Trace>& trace) {
  return std::make_unique<Traces>(mesh, std::move(maintainer), claim, trace);
}

}  // namespace restrip::tools
