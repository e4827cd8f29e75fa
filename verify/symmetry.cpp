#include "symmetry.hpp"

#include <algorithm>
#include <map>

namespace restrip::verify {
namespace {

using NodeMap = std::map<Node, Node>;

/// Triangles with ports go where their ports go; nullopt when two ports of one triangle disagree.
std::optional<NodeMap> images_by_ports(const Patch& patch, PortSymmetry symmetry) {
  NodeMap images;
  for (unsigned port = 0; port < patch.ports(); ++port) {
    const Node owner = patch.owner_of_port(port);
    const Node image = patch.owner_of_port(symmetry.image(port, patch.ports()));
    if (images.try_emplace(owner, image).first->second != image) return {};
  }
  return images;
}

std::optional<EdgePermutation> edge_images(const Patch& patch, const NodeMap& images) {
  const DualGraph& graph = patch.graph();
  EdgePermutation permutation(patch.inner_edges());
  for (auto [edge, end] = boost::edges(graph); edge != end; ++edge) {
    if (graph[*edge].kind != EdgeKind::inner) continue;
    const auto [image, exists] =
        boost::edge(images.at(boost::source(*edge, graph)), images.at(boost::target(*edge, graph)), graph);
    if (!exists) return {};
    permutation[graph[*edge].index] = graph[image].index;
  }
  return permutation;
}

}  // namespace

Mask permuted(Mask mask, const EdgePermutation& permutation) {
  Mask result = 0;
  for (unsigned i = 0; i < permutation.size(); ++i)
    if (is_solid(mask, i)) result |= single(permutation[i]);
  return result;
}

EdgePermutation port_permutation(PortSymmetry symmetry, unsigned port_count) {
  EdgePermutation permutation;
  for (unsigned port = 0; port < port_count; ++port) permutation.push_back(symmetry.image(port, port_count));
  return permutation;
}

std::vector<EdgePermutation> extensions(const Patch& patch, PortSymmetry symmetry) {
  std::optional<NodeMap> images = images_by_ports(patch, symmetry);
  if (!images) return {};
  std::vector<Node> free;
  for (const Node node : patch.triangles())
    if (!images->contains(node)) free.push_back(node);

  std::vector<EdgePermutation> result;
  std::vector<Node> targets = free;
  std::sort(targets.begin(), targets.end());
  do {
    for (std::size_t i = 0; i < free.size(); ++i) (*images)[free[i]] = targets[i];
    if (std::optional<EdgePermutation> edges = edge_images(patch, *images)) result.push_back(*edges);
  } while (std::next_permutation(targets.begin(), targets.end()));
  return result;
}

std::vector<PortSymmetry> symmetries_of(const Section& section) {
  std::vector<PortSymmetry> result;
  for (const bool mirror : {false, true})
    for (unsigned n = 0; n < section.ports; ++n) {
      const PortSymmetry symmetry{mirror, n};
      const Operation& operation = section.operations.front();
      if (extensions(operation.after, symmetry).empty()) continue;
      if (!section.serves_every_position && extensions(operation.before, symmetry).empty()) continue;
      result.push_back(symmetry);
    }
  return result;
}

std::vector<ConfigurationSymmetry> configuration_symmetries(const Operation& operation) {
  std::vector<ConfigurationSymmetry> group;
  const unsigned ports = operation.before.ports();
  for (const bool mirror : {false, true})
    for (unsigned n = 0; n < ports; ++n) {
      const PortSymmetry symmetry{mirror, n};
      if (extensions(operation.after, symmetry).empty()) continue;
      for (EdgePermutation& inner : extensions(operation.before, symmetry)) {
        ConfigurationSymmetry element{port_permutation(symmetry, ports), std::move(inner)};
        if (std::find(group.begin(), group.end(), element) == group.end()) group.push_back(std::move(element));
      }
    }
  return group;
}

Key image_of(Key key, PortSymmetry symmetry, const Section& section) {
  const Operation& operation = section.operations.front();
  const Mask ports = permuted(key.ports, port_permutation(symmetry, section.ports));
  if (operation.keyed_by_inner) return {ports, permuted(key.second, extensions(operation.before, symmetry).front())};
  const bool closed = operation.before.closed();
  PortPairs moved;
  const PortPairs pairs = pairs_of(key.second, key.ports, section.ports, closed).value_or(PortPairs{});
  for (unsigned i = 0; i < section.ports; ++i)
    for (unsigned j = i + 1; j < section.ports; ++j)
      if (pairs.has(i, j)) moved.add(symmetry.image(i, section.ports), symmetry.image(j, section.ports));
  return {ports, joined_to_predecessor(moved, ports, section.ports, closed)};
}

}  // namespace restrip::verify
