// A torus that is coarsened at random, with baked strips: each record makes some dual edges solid, and its flips clear
// one of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "../support/random_operations.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {

inline std::shared_ptr<const BakedFile> baked_torus() {
  auto file = std::make_shared<BakedFile>();
  StripMesh mesh = sample::torus(12, 12);
  std::mt19937 random(5);
  while (mesh.triangle_count() > 60) {
    const StripMesh::Halfedge h = random_halfedge(mesh, random);
    if (check_collapse(mesh, h) != Refusal::granted) continue;
    file->splits.push_back(record_of_collapse(mesh, h));
    mesh.remove_vertex(h);
  }
  std::reverse(file->splits.begin(), file->splits.end());
  file->points.resize(144);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) file->base.push_back(mesh.corners(t));
  file->mesh = StripMesh::build(file->base, 144);
  stripify(file->mesh, Effort::fast, Cost::strips());
  mesh = file->mesh;
  for (const SplitRecord& split : file->splits) {
    const StripMesh::Halfedge chord = split_baked(mesh, spokes_of(mesh, split), {}, split.v_t).halfedge;
    const StripMesh::Halfedge side = StripMesh::next(chord);
    if (mesh.solid(side)) {
      file->records.flips.push_back(side);
      mesh.set_solid(side, false);
    }
    file->records.first.push_back(static_cast<std::uint32_t>(file->records.flips.size()));
  }
  EXPECT_GT(file->records.flips.size(), 10U);
  EXPECT_TRUE(check_coloring(mesh).valid);
  return file;
}

}  // namespace restrip
