// Operations spread over a mesh, whose patches do not overlap: they can be done in any order, and undone, without any
// simplification.
#pragma once

#include <cstddef>
#include <vector>

#include "common/random.hpp"
#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/batch.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::bench {

/// Mesh edges to be collapsed, by their vertices, and their chords at first.
struct Sites {
  std::vector<tools::Record> records;
  std::vector<StripMesh::Halfedge> chords;

  [[nodiscard]] std::size_t size() const noexcept { return records.size(); }
};

/// Adds a collapse if it is legal, interior and apart from those before, and leaves a fan that the tables know: on real
/// meshes most splits are of such fans, while the edges of a made mesh, picked at random, would have many larger ones.
inline void add_site(const StripMesh& mesh, PatchClaims& claims, StripMesh::Halfedge chord, Sites& sites) {
  if (check_collapse(mesh, chord) != Refusal::granted || mesh.leaves_boundary(chord) ||
      mesh.leaves_boundary(mesh.opposite(chord)) ||
      spoke_count(mesh, mesh.from(chord)) + spoke_count(mesh, mesh.to(chord)) > table_max_k + 4 ||
      claims.claim(chord, sites.size()))
    return;
  const StripMesh::Halfedge back = mesh.opposite(chord);
  sites.chords.push_back(chord);
  sites.records.push_back(
      {mesh.from(chord), mesh.to(chord), mesh.to(StripMesh::next(chord)), mesh.to(StripMesh::next(back))});
}

/// Up to `count` disjoint legal collapses of interior edges, at random places in random order.
[[nodiscard]] inline Sites spread_out_sites(const StripMesh& mesh, std::size_t count) {
  tools::Random random(1);
  PatchClaims claims(mesh);
  Sites sites;
  const auto triangles = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::size_t tries = 0; sites.size() < count && tries < 16 * count; ++tries) {
    add_site(mesh, claims, StripMesh::halfedge(random.below(triangles), random.below(3)), sites);
  }
  return sites;
}

/// Adjacent sites, from the first triangle on: a part of the mesh that is being edited.
[[nodiscard]] inline Sites neighboring_sites(const StripMesh& mesh, std::size_t count) {
  PatchClaims claims(mesh);
  Sites sites;
  for (Triangle t = 0; t < mesh.triangle_bound() && sites.size() < count; ++t)
    add_site(mesh, claims, StripMesh::halfedge(t, 0), sites);
  return sites;
}

}  // namespace restrip::bench
