// Operations of shipped files, at random places, for tests of apply().
#pragma once

#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "random_operation.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/tables/shipped_operations.hpp"
#include "sample_meshes.hpp"

namespace restrip {

/// A place for the operation, if one is found soon.
template <class Table>
std::optional<StripMesh::Halfedge> random_place(const StripMesh& mesh, const Table& table, std::mt19937& random) {
  for (int tries = 0; tries < 60; ++tries)
    if (const StripMesh::Halfedge h = random_halfedge(mesh, random); check_apply(mesh, table, h) == Refusal::granted)
      return h;
  return {};
}

/// One of the operations of strips at a random place: done(table, h), on a mesh that neither grows nor vanishes.
template <class Do>
bool random_application(const StripMesh& mesh, std::mt19937& random, std::size_t size, Do&& done) {
  std::size_t count = 0;
  tables::for_each_operation([&](const char*, const auto& table) { count += table.matching ? 0U : 1U; });
  std::size_t left = random() % count;
  bool did = false;
  tables::for_each_operation([&](const char*, const auto& table) {
    if (table.matching || left-- != 0) return;
    const bool grows = table.triangles_after.size() > table.triangles_before.size();
    if (grows ? mesh.triangle_count() > size : mesh.triangle_count() < size / 2) return;
    const auto h = random_place(mesh, table, random);
    if (h) done(table, *h);
    did = h.has_value();
  });
  return did;
}

/// A collapse while there are many triangles, else a flip, by a mesh or its keeper: they make vertices of all valences.
template <class Mesh>
Checked stir(Mesh& by, const StripMesh& mesh, std::mt19937& random, std::size_t size) {
  const StripMesh::Halfedge h = random_halfedge(mesh, random);
  return mesh.triangle_count() > size ? checked_collapse(by, h) : checked_flip(by, h);
}

/// Its dual edges that are solid, by the vertices of the mesh edge.
inline std::set<std::pair<Vertex, Vertex>> solid_edges_of(const StripMesh& mesh) {
  std::set<std::pair<Vertex, Vertex>> solid;
  for (const StripMesh::Halfedge h : sample::sides_of(mesh))
    if (mesh.solid(h)) solid.insert(std::minmax({mesh.from(h), mesh.to(h)}));
  return solid;
}

}  // namespace restrip
