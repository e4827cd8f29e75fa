#include "patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mutants.hpp"

namespace restrip::verify {

Patch::Patch(const std::vector<PatchTriangle>& triangles, bool ring,
             const std::optional<std::pair<std::string, std::string>>& chord)
    : closed_(ring) {
  std::size_t ports = 0;
  for (const PatchTriangle& triangle : triangles) ports += triangle.ports.size();
  outside_.resize(ports, boost::graph_traits<DualGraph>::null_vertex());
  for (const PatchTriangle& triangle : triangles) {
    const Node node = boost::add_vertex({triangle.name, false, 0}, graph_);
    triangles_.push_back(node);
    for (const unsigned port : triangle.ports) {
      if (port >= ports || outside_[port] != boost::graph_traits<DualGraph>::null_vertex())
        throw std::logic_error(fmt::format("port {} is there twice, or one before it is not", port));
      outside_[port] = boost::add_vertex({fmt::format("out{}", port), true, port}, graph_);
      boost::add_edge(node, outside_[port], {EdgeKind::port, port, false}, graph_);
    }
  }
  for (std::size_t i = 0; i + 1 < triangles_.size(); ++i) add_inner_edge(triangles_[i], triangles_[i + 1]);
  if (ring) add_inner_edge(triangles_.back(), triangles_.front());
  if (!chord) return;
  // Behind D comes its next triangle.
  const std::size_t end = index_of(chord->second) + (mutated(Mutant::chord_misplaced) && ring ? 1 : 0);
  add_inner_edge(triangles_[index_of(chord->first)], triangles_.at(end), true);
}

std::size_t Patch::index_of(const std::string& name) const {
  const auto found =
      std::find_if(triangles_.begin(), triangles_.end(), [&](Node node) { return graph_[node].name == name; });
  if (found == triangles_.end()) throw std::logic_error("no triangle is named " + name);
  return static_cast<std::size_t>(found - triangles_.begin());
}

void Patch::add_inner_edge(Node one, Node other, bool is_chord) {
  if (is_chord) chord_ = inner_edges_;
  boost::add_edge(one, other, {EdgeKind::inner, inner_edges_, is_chord}, graph_);
  ++inner_edges_;
}

Node Patch::owner_of_port(unsigned port) const {
  return boost::target(*boost::out_edges(outside_[port], graph_).first, graph_);
}

}  // namespace restrip::verify
