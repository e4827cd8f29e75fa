#include "patch.hpp"

#include <fmt/format.h>

#include "mutants.hpp"

namespace restrip::verify {

Node Patch::add_triangle(const std::string& name) {
  triangles_.push_back(boost::add_vertex({name, false, 0}, graph_));
  return triangles_.back();
}

void Patch::add_port(Node owner, unsigned port) {
  outside_.resize(std::max<std::size_t>(outside_.size(), port + 1));
  outside_[port] = boost::add_vertex({fmt::format("out{}", port), true, port}, graph_);
  boost::add_edge(owner, outside_[port], {EdgeKind::port, port, false}, graph_);
}

void Patch::add_inner_edge(Node one, Node other, bool is_chord) {
  if (is_chord) chord_ = inner_edges_;
  boost::add_edge(one, other, {EdgeKind::inner, inner_edges_, is_chord}, graph_);
  ++inner_edges_;
}

void Patch::add_fan(unsigned k, std::optional<unsigned> a_before, std::optional<unsigned> d_before) {
  for (unsigned i = 0; i <= k; ++i) {
    if (a_before == i) a_ = add_triangle("A");
    if (d_before == i) d_ = add_triangle("D");
    if (i < k) add_port(add_triangle(fmt::format("t{}", i)), i);
  }
}

void Patch::join_neighbors(bool closed) {
  closed_ = closed;
  for (std::size_t i = 0; i + 1 < triangles_.size(); ++i) add_inner_edge(triangles_[i], triangles_[i + 1]);
  if (closed) add_inner_edge(triangles_.back(), triangles_.front());
}

Patch Patch::closed_fan(unsigned k) {
  Patch patch;
  patch.add_fan(k, {}, {});
  patch.join_neighbors(true);
  return patch;
}

Patch Patch::open_fan(unsigned k) {
  Patch patch;
  patch.add_fan(k, {}, {});
  patch.join_neighbors(false);
  return patch;
}

Patch Patch::ring_with_chord(unsigned k, unsigned a) {
  Patch patch;
  patch.add_fan(k, 0, mutated(Mutant::off_by_one_arc) ? a + 1 : a);
  patch.join_neighbors(true);
  // Nodes are numbered triangle, port, triangle, port; behind D without a port comes its next triangle.
  patch.add_inner_edge(*patch.a_, mutated(Mutant::chord_misplaced) ? *patch.d_ + 1 : *patch.d_, true);
  return patch;
}

Patch Patch::path_with_chord(unsigned k, unsigned i, unsigned j) {
  Patch patch;
  patch.add_fan(k, i, j);
  patch.join_neighbors(false);
  patch.add_inner_edge(*patch.a_, *patch.d_, true);
  return patch;
}

Patch Patch::path(unsigned k, unsigned i) {
  Patch patch;
  patch.add_fan(k, i, {});
  patch.join_neighbors(false);
  return patch;
}

Patch Patch::flip(unsigned first_port, unsigned second_port) {
  Patch patch;
  const Node first = patch.add_triangle("L");
  const Node second = patch.add_triangle("R");
  for (unsigned port = 0; port < 4; ++port)
    patch.add_port(port == first_port || port == second_port ? first : second, port);
  patch.add_inner_edge(first, second);
  return patch;
}

Node Patch::owner_of_port(unsigned port) const {
  return boost::target(*boost::out_edges(outside_[port], graph_).first, graph_);
}

}  // namespace restrip::verify
