#include "definition/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <boost/pending/disjoint_sets.hpp>

namespace restrip::verify {

namespace {

/// Adds all worlds that extend `world` at `port` and the ports after it.
void extend(Constraint constraint, unsigned ports, unsigned port, const World& world, std::vector<World>& all) {
  if (port == ports || constraint == Constraint::matching) return all.push_back(world);
  extend(constraint, ports, port + 1, world, all);  // it is not connected to any later port
  if (is_solid(world.ports, port)) return;
  for (unsigned other = port + 1; other < ports; ++other) {
    if (is_solid(world.ports, other)) continue;
    World more = world;
    more.ports |= single(port) | single(other);
    more.connected.push_back({port, other});
    extend(constraint, ports, port + 1, more, all);
  }
}

using Components = boost::disjoint_sets<std::uint8_t*, std::uint8_t*>;

/// Adds an edge to a forest; false if it would close a cycle.
bool grows(Components components, unsigned one, unsigned other) {
  if (components.find_set(one) == components.find_set(other)) return false;
  components.union_set(one, other);
  return true;
}

}  // namespace

std::vector<World> worlds_of(Constraint constraint, unsigned ports) {
  std::vector<World> all;
  extend(constraint, ports, 0, {}, all);
  std::sort(all.begin(), all.end(), [](const World& one, const World& other) {
    return std::pair(one.connected.size(), one.connected) < std::pair(other.connected.size(), other.connected);
  });
  return all;
}

std::string text_of(const World& world) {
  std::string text;
  for (const auto& [one, other] : world.connected) text += fmt::format(" {}-{}", one, other);
  return text.empty() ? "no ports connected outside" : fmt::format("ports{} connected outside", text);
}

PatchInWorlds::PatchInWorlds(const Side& side, Constraint constraint, const std::vector<World>& worlds)
    : side_(side), most_solid_(most_solid(constraint)) {
  for (const World& world : worlds) {
    auto& edges = outside_.emplace_back();
    for (const auto& [one, other] : world.connected) edges.emplace_back(side.triangles + one, side.triangles + other);
  }
}

/// A graph is a forest if none of its edges, in any order, connects nodes that the edges before it connect. So the
/// edges of the patch come first, once for all worlds.
bool PatchInWorlds::valid(Colors colors, std::size_t world) const {
  ++graphs_;
  if (known_ != colors) {
    known_ = colors;
    is_forest_ = grow_inside(colors);
  }
  if (!is_forest_) return false;
  Forest forest = inside_;
  const Components components(forest.rank.data(), forest.parent.data());
  return std::all_of(outside_[world].begin(), outside_[world].end(),
                     [&](const auto& edge) { return grows(components, edge.first, edge.second); });
}

bool PatchInWorlds::grow_inside(Colors colors) const {
  Components components(inside_.rank.data(), inside_.parent.data());
  for (unsigned node = 0; node < side_.triangles + side_.ports(); ++node)
    components.make_set(static_cast<std::uint8_t>(node));
  std::array<unsigned, most_triangles + most_ports> degree{};
  const auto add = [&](unsigned one, unsigned other) {
    for (const unsigned node : {one, other})
      if (++degree[node] > most_solid_) return false;
    return grows(components, one, other);
  };
  for (unsigned edge = 0; edge < side_.inner_edges(); ++edge)
    if (is_solid(colors.inner, edge) && !add(side_.edges[edge][0], side_.edges[edge][1])) return false;
  for (unsigned port = 0; port < side_.ports(); ++port)
    if (is_solid(colors.ports, port) && !add(side_.owner_of_port[port], side_.triangles + port)) return false;
  return true;
}

Definition::Definition(const Operation& operation)
    : operation_(operation),
      worlds_(worlds_of(operation.constraint, operation.ports())),
      before_(operation.before, operation.constraint, worlds_),
      after_(operation.after, operation.constraint, worlds_),
      valid_after_(mask_count(operation.ports())),
      question_of_(mask_count(operation.before.colors()), none) {
  for (Mask kept = 0; kept < valid_after_.size(); ++kept)
    for (Mask inner = 0; inner < mask_count(operation.after.inner_edges()); ++inner)
      if (after_.valid({inner, kept})) valid_after_[kept].push_back(inner);

  for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports) {
    std::vector<unsigned> possible;
    for (unsigned world = 0; world < worlds_.size(); ++world)
      if (is_subset(worlds_[world].ports, ports)) possible.push_back(world);
    std::unordered_map<std::vector<unsigned>, unsigned, boost::hash<std::vector<unsigned>>> known;
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner) {
      if (!before_.valid({inner, ports})) continue;
      std::vector<unsigned> worlds;
      for (const unsigned world : possible)
        if (before_.valid({inner, ports}, world)) worlds.push_back(world);
      const auto number = static_cast<unsigned>(questions_.size());
      const auto [place, is_new] = known.try_emplace(worlds, number);
      question_of_[concatenated(inner, ports, operation.ports())] = place->second;
      if (is_new) questions_.push_back({std::move(worlds), {}});
    }
    std::vector<Candidate> in_order;  // the preferred ones first
    for (Mask kept = 0; kept <= ports; ++kept)
      if (admissible(operation_, ports, kept))
        for (const Mask inner : valid_after_[kept])
          in_order.push_back({cost({0, ports}, {inner, kept}), {inner, kept}});
    std::sort(in_order.begin(), in_order.end());
    for (const auto& question : known) {
      auto& [worlds, best] = questions_[question.second];
      for (auto one = in_order.begin(); one != in_order.end() && !best; ++one)
        if (!refuting_world(worlds, one->colors)) best = *one;
    }
  }
}

std::optional<unsigned> Definition::refuting_world(const std::vector<unsigned>& worlds, Colors recoloring) const {
  for (const unsigned world : worlds)
    if (!after_.valid(recoloring, world)) return world;
  return {};
}

Judged Definition::judged(Colors configuration, Colors recoloring) const {
  const std::uint64_t answer = concatenated(recoloring.inner, recoloring.ports, operation_.ports());
  const auto [place, is_new] =
      known_.try_emplace(question_number(configuration) * wide_mask_count(most_colors) + answer);
  Judged& judged = place->second;
  if (!is_new) return judged;
  if (!admissible(operation_, configuration.ports, recoloring.ports)) return judged = {Verdict::wrong_ports};
  if (refuting_world(configuration, recoloring).has_value()) return judged = {Verdict::unsound};
  const CostValues own = cost(configuration, recoloring);
  const CostValues least = best(configuration).value().cost;
  unsigned criterion = 0;
  while (criterion < own.size() && own[criterion] == least[criterion]) ++criterion;
  if (criterion < own.size()) judged = {Verdict::not_best, criterion};
  return judged;
}

}  // namespace restrip::verify
