// A mesh that is coarsened at random, with baked strips: each record leads to the colours that an operation under the
// policy `local` gives.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "random_operations.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {

/// `levels` becomes the colours of each level, from the base on.
inline std::shared_ptr<const BakedFile> baked_sequence(StripMesh mesh,
                                                       std::vector<std::vector<std::uint8_t>>* levels = nullptr) {
  auto file = std::make_shared<BakedFile>();
  const auto vertices = static_cast<Vertex>(mesh.vertex_bound());
  std::mt19937 random(5);
  for (std::size_t least = mesh.triangle_count() / 5; mesh.triangle_count() > least;) {
    const StripMesh::Halfedge h = random_halfedge(mesh, random);
    if (check_collapse(mesh, h) != Refusal::granted) continue;
    file->splits.push_back(record_of_collapse(mesh, h));
    mesh.remove_vertex(h);
  }
  std::reverse(file->splits.begin(), file->splits.end());
  file->points.resize(vertices);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) file->base.push_back(mesh.corners(t));
  file->mesh = StripMesh::build(file->base, vertices);
  stripify(file->mesh, Effort::fast, Cost::strips());
  mesh = file->mesh;
  if (levels != nullptr) levels->push_back(sample::colors_of(mesh));
  for (const SplitRecord& split : file->splits) {
    StripMesh plain = mesh;
    split_baked(plain, spokes_of(plain, split), {}, split.v_t);
    Keeper(mesh, Policy::local, Cost::strips()).split(spokes_of(mesh, split), split.v_t);
    for (const StripMesh::Halfedge h : sample::recolored_edges(plain, mesh)) file->records.flips.push_back(h);
    file->records.first.push_back(static_cast<std::uint32_t>(file->records.flips.size()));
    if (levels != nullptr) levels->push_back(sample::colors_of(mesh));
  }
  EXPECT_GT(file->records.flips.size(), 10U);
  EXPECT_TRUE(check_coloring(mesh).valid);
  return file;
}

inline std::shared_ptr<const BakedFile> baked_torus() { return baked_sequence(sample::torus(12, 12)); }

}  // namespace restrip
