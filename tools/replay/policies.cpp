#include "replay/policies.hpp"

#include <algorithm>
#include <memory>

#include "lod/bake.hpp"
#include "restrip/operations/baked.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;

std::string says(Policy policy) {
  switch (policy) {
    case Policy::local:
      return "the rules of the tables, one patch at a time";
    case Policy::linked:
      return "rules that follow the strips around the patch";
    case Policy::quick:
    case Policy::full:
      break;
  }
  return "the rules, then tunnelling: up to " + std::to_string(search_of(policy).states) +
         " states from each strip end";
}

Upkeep begin(Policy policy, StripMesh& mesh) {
  const auto keeper = std::make_shared<StripKeeper>(mesh, policy);
  return {[keeper](const Where& where, Vertex v_t) { return keeper->split(where, v_t).halfedge; }, {}};
}

/// The base comes with colours of its own.
Upkeep play_baked(StripMesh& mesh, const ProgressiveMesh& source) {
  struct Play {
    Play(StripMesh& target, const ProgressiveMesh& source) : baked(bake(source)), player(target, baked.records) {
      target = baked.base;
    }
    BakedMesh baked;
    BakedPlayer<StripMesh> player;
  };
  const auto play = std::make_shared<Play>(mesh, source);
  return {
      [play](const Where& where, Vertex v_t) { return play->player.split(play->player.level(), where, v_t).halfedge; },
      {}};
}

}  // namespace

const std::map<std::string, Policy>& policy_names() {
  static const std::map<std::string, Policy> names{
      {"local", Policy::local}, {"linked", Policy::linked}, {"quick", Policy::quick}, {"full", Policy::full}};
  return names;
}

std::vector<StripPolicy> our_policies() {
  std::vector<StripPolicy> policies;
  for (const auto& named : policy_names()) {
    const Policy policy = named.second;
    policies.push_back(
        {named.first, says(policy), [policy](StripMesh& mesh, const ProgressiveMesh&) { return begin(policy, mesh); }});
  }
  std::sort(policies.begin(), policies.end(), [](const StripPolicy& one, const StripPolicy& two) {
    return policy_names().at(one.name) < policy_names().at(two.name);
  });
  policies.push_back({"baked", "strips decided beforehand for every level, and played back", play_baked});
  return policies;
}

}  // namespace restrip::tools
