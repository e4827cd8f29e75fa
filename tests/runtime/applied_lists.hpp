// Custom operations on bare lists of triangles: the reference for apply().
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "own_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"
#include "whole_mesh.hpp"

namespace restrip {

/// The list after an operation at the directed edge from -> to; empty if the patch does not exist there, has a vertex
/// twice, or leaves a mesh that is not manifold. `added`: the new vertices, in the order of the operation file.
template <class Table>
std::optional<bare::List> applied(const bare::List& list, const bare::Shape& shape, const Table& table, Vertex from,
                                  Vertex to, const std::vector<Vertex>& added) {
  std::map<unsigned, Vertex> names;
  std::vector<bare::Corners> out;
  for (const tables::PatchTriangle& t : table.triangles_before) {
    const bool first = out.empty();
    const Vertex a = first ? from : out[t.from][(t.from_side + 1U) % 3];
    const Vertex b = first ? to : out[t.from][t.from_side];
    const auto c = bare::apex(list, a, b);
    if (!c) return {};
    out.push_back({a, b, *c});
    for (std::size_t s = 0; s < 3; ++s)
      if (!names.emplace(t.vertex[s], out.back()[s]).second && names.at(t.vertex[s]) != out.back()[s]) return {};
  }
  for (std::size_t t = 0; t < out.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (table.triangles_before[t].side[s] == tables::PatchTriangle::boundary_side &&
          bare::apex(list, out[t][(s + 1) % 3], out[t][s]))
        return {};
  std::set<Vertex> gone;
  for (const auto& [place, name] : names)
    if (!gone.insert(name).second) return {};
  std::vector<Vertex> made;
  std::vector<Vertex> named;
  bare::List after;
  for (const bare::Corners& c : list)
    if (std::none_of(out.begin(), out.end(),
                     [&](const bare::Corners& o) { return bare::sorted({o}) == bare::sorted({c}); }))
      after.push_back(c);
  if (after.size() + out.size() != list.size()) return {};
  for (const tables::PatchTriangle& t : table.triangles_after) {
    bare::Corners corners{};
    for (std::size_t s = 0; s < 3; ++s) {
      if (!names.contains(t.vertex[s])) {
        made.push_back(added.at(made.size()));
        names[t.vertex[s]] = made.back();
      }
      corners[s] = names.at(t.vertex[s]);
      named.push_back(corners[s]);
    }
    after.push_back(corners);
  }
  for (const Vertex v : named) gone.erase(v);
  std::vector<Vertex> old(named);
  old.insert(old.end(), gone.begin(), gone.end());
  if (!bare::all_regular(shape, old)) return {};
  if (!bare::as_good(shape, after, named, {gone.begin(), gone.end()}, made)) return {};
  return bare::sorted(after);
}

/// Does an operation at every halfedge of a mesh, as a list and as a StripMesh; returns how often it was granted.
/// table_at(h) is the table there.
template <class TableAt>
std::size_t try_everywhere(const StripMesh& start, TableAt&& table_at) {
  std::size_t granted = 0;
  const bare::List list = bare::sorted(sample::triangles_of(start));
  const bare::Shape shape = bare::shape_of(list);
  for (const StripMesh::Halfedge h : sample::sides_of(start)) {
    const auto& table = table_at(h);
    const auto after = [&](const std::vector<Vertex>& added) {
      return applied(list, shape, table, start.from(h), start.to(h), added);
    };
    StripMesh mesh = start;
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    const Checked done = checked_apply(mesh, table, h);
    EXPECT_EQ(done.granted(), after({1000, 1001, 1002}).has_value()) << describe(done.refusal);
    if (!done) {
      EXPECT_EQ(sample::triangles_of(mesh), list);
      continue;
    }
    ++granted;
    EXPECT_EQ(fault_of(mesh), "");
    const auto wanted = after({done.new_vertices.begin(), done.new_vertices.end()});
    EXPECT_TRUE(wanted && *wanted == sample::triangles_of(mesh));
    EXPECT_TRUE(names_all_changes(changed, start, mesh));
  }
  return granted;
}

}  // namespace restrip
