#include <string>
#include <utility>
#include <vector>

#include "replay/ways.hpp"

namespace restrip::tools {
namespace {

/// For UpkeepBy.
class TracedOperations : public PlainOperations {
 public:
  using Halfedge = StripMesh::Halfedge;

  TracedOperations(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim, std::optional<Trace>& trace)
      : mesh_(mesh), kept_(std::move(kept)), claim_(claim), trace_(trace) {
    mesh_.watch(&changed_);
    trace_.emplace(mesh_, claim_);
  }
  TracedOperations(const TracedOperations&) = delete;
  TracedOperations& operator=(const TracedOperations&) = delete;
  ~TracedOperations() { mesh_.watch(nullptr); }

  Rewrite<Halfedge> split(const Upkeep::Where& where, Vertex v_t, std::size_t record) {
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

}  // namespace

// What policies do after a rule joins strips or isolated triangles.
Trace::Claim claim_of(const Plan& plan) {
  const Way& way = plan.way();
  if (!(plan.cost() == Cost::strips()) || way.bakes) return Trace::Claim::valid;
  if (way.kind == Way::Kind::rules) return Trace::Claim::best;
  return way.kind == Way::Kind::ours ? Trace::Claim::no_worse : Trace::Claim::valid;
}

std::unique_ptr<Upkeep> traced(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim,
                               std::optional<Trace>& trace) {
  return std::make_unique<UpkeepBy<TracedOperations>>(mesh, std::move(kept), claim, trace);
}

}  // namespace restrip::tools
