// A patch as the graph that is searched for its best colours: the triangles of a mesh around some vertices, and the
// strips outside.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "naive_patch.hpp"
#include "outside_frontier.hpp"
#include "sample_meshes.hpp"

namespace restrip {

/// The triangles around some vertices, which edges between them are inner, and where the strips go that leave them.
class PatchInMesh {
 public:
  using Halfedge = StripMesh::Halfedge;
  PatchInMesh(const StripMesh& mesh, std::set<Vertex> centers) : mesh_(&mesh), centers_(std::move(centers)) {
    for (const Vertex v : centers_)
      for (const Halfedge h : sample::spokes_around(mesh, v))
        if (!StripMesh::on_boundary(h) && node_.emplace(StripMesh::triangle(h), 0).second)
          triangles_.push_back(StripMesh::triangle(h));
    for (std::size_t n = 0; n < triangles_.size(); ++n) node_[triangles_[n]] = static_cast<int>(n);
  }

  /// In the mesh as it is: the frontier's value of the patch's colours.
  long value() const {
    long result = 0;
    for (const Triangle t : triangles_) {
      result -= mesh_->solid_degree(t) == 0 ? 1 : 0;
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) && h.id < there.id && mesh_->solid(h)) result += 1'000'000;
      });
    }
    return result;
  }

  /// Pairs of ports, by their halfedges outside, that solid edges join inside.
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs() const {
    naive::UnionFind inside(triangles_.size());
    std::vector<std::pair<std::uint32_t, std::size_t>> ports;
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (!mesh_->solid(h)) return;
        const auto at = static_cast<std::size_t>(node_.at(t));
        if (is_inner(h))
          inside.unite(at, static_cast<std::size_t>(node_.at(StripMesh::triangle(there))));
        else
          ports.emplace_back(there.id, at);
      });
    std::set<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const auto& [one, at] : ports)
      for (const auto& [other, there] : ports)
        if (one != other && inside.find(at) == inside.find(there)) result.emplace(one, other);
    return result;
  }

  /// The best value in every world that allows these pairs inside.
  long best_anywhere(const std::set<std::pair<std::uint32_t, std::uint32_t>>& before) const {
    naive::OutsideFrontier graph = inner_graph();
    std::vector<std::uint32_t> names;
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) || !mesh_->solid(h)) return;
        graph.add_hidden(node_.at(t), static_cast<int>(names.size()));
        names.push_back(there.id);
      });
    return graph.best([&](int one, int other) {
      return before.count({names[static_cast<std::size_t>(one)], names[static_cast<std::size_t>(other)]}) != 0;
    });
  }

 private:
  template <class Visit>
  void for_each_side(Triangle t, const Visit& visit) const {
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(t, side);
      if (const auto there = mesh_->opposite(h); !StripMesh::on_boundary(there)) visit(h, there);
    }
  }
  bool is_inner(Halfedge h) const { return centers_.count(mesh_->from(h)) + centers_.count(mesh_->to(h)) > 0; }
  naive::OutsideFrontier inner_graph() const {
    naive::OutsideFrontier graph(static_cast<int>(triangles_.size()));
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) && h.id < there.id) graph.add_edge(node_.at(t), node_.at(StripMesh::triangle(there)));
      });
    return graph;
  }

  const StripMesh* mesh_;
  std::set<Vertex> centers_;
  std::vector<Triangle> triangles_;
  std::map<Triangle, int> node_;
};

}  // namespace restrip
