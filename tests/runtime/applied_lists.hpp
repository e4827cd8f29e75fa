// Custom operations everywhere on a mesh, compared with bare lists of triangles.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "restrip/operations/apply.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"
#include "whole_mesh.hpp"

namespace restrip {

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
      return bare::applied(list, shape, table, start.from(h), start.to(h), added);
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
