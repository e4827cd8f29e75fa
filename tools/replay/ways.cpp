#include "replay/ways.hpp"

#include <algorithm>
#include <stdexcept>

#include "lod/coloring_check.hpp"
#include "lod/handle_order.hpp"
#include "replay/paper_ways.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/index_keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;

/// The mesh alone: new and joined dual edges are dashed.
struct Bare {
  StripMesh& mesh;
  explicit Bare(StripMesh& on) : mesh(on) {}
  Halfedge split(const Where& where, Vertex v_t, std::size_t) { return mesh.insert_vertex(where, v_t); }
  Halfedge collapse(Halfedge chord, std::size_t) { return mesh.remove_vertex(chord); }
  Halfedge flip(Halfedge h) { return mesh.turn_edge(h); }
};

struct Rules {
  StripMesh& mesh;
  explicit Rules(StripMesh& on) : mesh(on) {}
  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t) { return restrip::split(mesh, where, v_t); }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t) { return restrip::collapse(mesh, chord); }
  Rewrite<Halfedge> flip(Halfedge h) { return restrip::flip(mesh, h); }
};

struct Kept {
  StripKeeper keeper;
  Kept(StripMesh& mesh, Policy policy, Search search) : keeper(mesh, policy) { keeper.set_search(search); }
  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t) { return keeper.split(where, v_t); }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t) { return keeper.collapse(chord); }
  Rewrite<Halfedge> flip(Halfedge h) { return keeper.flip(h); }
  void restart(std::size_t) { keeper.rebuild(); }
  [[nodiscard]] std::string fault() const {
    return keeper.locator() != nullptr ? find_fault(keeper.mesh(), *keeper.locator()) : std::string();
  }
};

/// Operations of a keeper under another cost than strips.
struct KeptLow {
  IndexKeeper keeper;
  KeptLow(StripMesh& mesh, Policy policy, const Beginning& with) : keeper(mesh, policy, with.cost) {
    IndexPlan plan = plan_of(policy);
    plan.limits.looks = with.search.states;
    keeper.set_plan(plan);
  }
  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t) { return keeper.split(where, v_t); }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t) { return keeper.collapse(chord); }
  Rewrite<Halfedge> flip(Halfedge h) { return keeper.flip(h); }
  void restart(std::size_t) { keeper.rebuild(); }
  [[nodiscard]] std::string fault() const { return find_fault(keeper); }
};

struct Baked {
  StripMesh& mesh;
  const BakedRecords<Halfedge>& records;
  BakedPlayer<StripMesh> player;
  Witness witness;
  Baked(StripMesh& on, const BakedRecords<Halfedge>& of) : mesh(on), records(of), player(on, of) {}
  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t record) {
    return player.split(record, where, v_t);
  }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t record) { return player.collapse(record, chord); }
  Rewrite<Halfedge> flip(Halfedge h) {
    player.leave_step();
    return flip_and_join(mesh, h);
  }
  // In step a player counts strips alone; a record may flip colours anywhere.
  Rewrite<Halfedge> split_and_tell(const Where& where, Vertex v_t, std::size_t record) {
    if (!player.can_split(record)) return split(where, v_t, record);
    witness.before_split(mesh, where, records[record]);
    return witness.after_split(mesh, split(where, v_t, record).halfedge, records[record]);
  }
  Rewrite<Halfedge> collapse_and_tell(Halfedge chord, std::size_t record) {
    if (!player.can_collapse(record)) return collapse(chord, record);
    witness.before_collapse(mesh, chord, records[record]);
    return witness.after_collapse(mesh, collapse(chord, record).halfedge, records[record]);
  }
  void restart(std::size_t level) { player.restart(level); }
};

template <class Operations, class... Arguments>
std::unique_ptr<Upkeep> begin_by(StripMesh& mesh, Arguments&&... arguments) {
  return std::make_unique<UpkeepBy<Operations>>(mesh, std::forward<Arguments>(arguments)...);
}
template <class Operations>
std::unique_ptr<Upkeep> begin_plainly(StripMesh& mesh, const Beginning&) {
  return begin_by<Operations>(mesh);
}

Way kept(const char* name, const char* says, Policy policy) {
  Way way{name, says, Way::Kind::ours, [policy](StripMesh& mesh, const Beginning& with) {
            if (with.cost == Cost::strips()) return begin_by<Kept>(mesh, policy, with.search);
            return begin_by<KeptLow>(mesh, policy, with);
          }};
  way.search = search_of(policy);
  way.weighed = {plan_of(policy).limits.looks, 0};
  way.local = policy == Policy::local;
  if (way.searches()) way.says += ": up to " + std::to_string(way.search.states) + " states from each strip end";
  return way;
}

Way baked() {
  Way way{"baked", "strips decided beforehand for every level, and played back", Way::Kind::ours,
          [](StripMesh& mesh, const Beginning& with) {
            if (with.baked == nullptr) throw std::invalid_argument("baked strips want a baked mesh");
            return std::make_unique<UpkeepBy<Baked>>(mesh, with.baked->records);
          }};
  way.bakes = true;
  return way;
}

std::vector<Way> all_ways() {
  std::vector<Way> all{{"bare", "the mesh update alone; strips fall apart", Way::Kind::mesh, begin_plainly<Bare>},
                       {"rules", "the rules of the tables, and nothing else", Way::Kind::rules, begin_plainly<Rules>},
                       kept("local", "the rules of the tables, one patch at a time", Policy::local),
                       kept("linked", "rules that follow the strips around the patch", Policy::linked),
                       kept("quick", "the rules, then tunnelling", Policy::quick),
                       kept("full", "the rules, then tunnelling", Policy::full),
                       baked()};
  for (Way& way : paper_ways()) all.push_back(std::move(way));
  return all;
}

}  // namespace

const std::vector<Way>& ways() {
  static const std::vector<Way> all = all_ways();
  return all;
}

const Way& way_named(const std::string& name) {
  const auto found = std::find_if(ways().begin(), ways().end(), [&](const Way& way) { return way.name == name; });
  if (found == ways().end()) throw std::invalid_argument("there is no way of keeping strips named " + name);
  return *found;
}

const Way& usual_way(bool strips_are_baked) {
  const auto usual = [&](const Way& way) { return way.kind == Way::Kind::ours && way.bakes == strips_are_baked; };
  return *std::find_if(ways().begin(), ways().end(), usual);
}

Plan::Plan(const Way& way, const ProgressiveMesh& mesh, const Given& given)
    : way_(&way), mesh_(&mesh), search_(given.search.value_or(way.search_under(given.cost))), cost_(given.cost) {
  if (!(cost_ == Cost::strips()) && !way.weighs())
    throw std::invalid_argument("the way of keeping strips named " + way.name + " knows no cost but strips");
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
    stripify(base_, Effort::full, cost_);
  }
  // Baked records name dual edges by the handles of the splits' order.
  if (!way.bakes && given.handles_along_strips) base_.renumber(handles_along_strips(mesh, base_));
}

}  // namespace restrip::tools
