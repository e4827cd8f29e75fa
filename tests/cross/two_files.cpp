// The library in two files, restrip.hpp and restrip.cpp, on targets and with options that the other tests do not cover.
// The output must be the same everywhere; two_files.cmake compiles it for each target and compares.
#include <cstdio>
#include <cstring>
#include <vector>

#include "restrip.hpp"

namespace {

using restrip::StripMesh;
using restrip::Triangle;
using restrip::Vertex;
using Halfedge = StripMesh::Halfedge;

// The compiler evaluates a rule of each family.
static_assert(restrip::split_rule({4, 2}, 0b0101, 0).valid && restrip::collapse_rule({4, 2}, 0, 0).valid);
static_assert(restrip::open_split_rule({3, 0, 2}, 0, 0).valid && restrip::open_collapse_rule({3, 0, 2}, 0, 0).valid);
static_assert(restrip::boundary_split_rule({3, 1}, 0, 0).valid && restrip::boundary_collapse_rule({3, 1}, 0, 0).valid);
static_assert(restrip::flip_rule(true, 0b0101).valid && restrip::split_rule({20, 9}, 0, 0).valid);

/// n squares a side, two triangles each.
std::vector<std::array<Vertex, 3>> sheet(Vertex n) {
  std::vector<std::array<Vertex, 3>> triangles;
  const auto at = [n](Vertex row, Vertex column) { return row * (n + 1) + column; };
  for (Vertex row = 0; row < n; ++row)
    for (Vertex column = 0; column < n; ++column) {
      triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  return triangles;
}

void print(const char* what, const StripMesh& mesh) {
  const restrip::ColoringReport report = restrip::check_coloring(mesh);
  const std::vector<std::uint32_t> indices = restrip::strip_indices(mesh);
  std::uint32_t sum = 0;
  for (const std::uint32_t index : indices) sum = sum * 31 + index;
  std::printf("%s: %s, %u triangles, %u strips, %u isolated, indices %u, sum %lx\n", what,
              report.valid ? "valid" : "not valid", static_cast<unsigned>(report.triangles),
              static_cast<unsigned>(report.strips), static_cast<unsigned>(report.isolated),
              static_cast<unsigned>(indices.size()), static_cast<unsigned long>(sum));
}

/// A vertex of 70 triangles takes more than one word; cut and closed again.
void large_fan() {
  std::vector<std::array<Vertex, 3>> triangles;
  for (Vertex v = 0; v < 70; ++v) triangles.push_back({70, v, (v + 1) % 70});
  StripMesh mesh = StripMesh::build(triangles, 71);
  const auto done = restrip::split(mesh, {mesh.spoke(70, 3), mesh.spoke(70, 40)});
  print("large fan split", mesh);
  restrip::collapse(mesh, done.halfedge);
  print("large fan", mesh);
}

/// Operations at random places, the same everywhere, with undo; then a save that is loaded.
void operations(restrip::Policy policy, restrip::StripForm form, const char* what) {
  restrip::LiveMesh live(sheet(24), 25 * 25, {.policy = policy, .history = 5000, .format = {.form = form}});
  std::uint32_t random = 1;
  std::size_t done = 0;
  std::size_t ranges = 0;
  for (unsigned step = 0; step < 3000; ++step) {
    random = random * 1'664'525 + 1'013'904'223;
    const Halfedge h =
        StripMesh::halfedge((random >> 8) % static_cast<Triangle>(live.mesh().triangle_bound()), step % 3);
    switch (random >> 29) {
      case 0:
      case 1:
        done += live.collapse(h) ? 1U : 0U;
        break;
      case 2:
        done += live.flip(h) ? 1U : 0U;
        break;
      case 3:
        done += live.split_face(h) ? 1U : 0U;
        break;
      case 4:
        done += live.bisect(h) ? 1U : 0U;
        break;
      case 5:
        if (live.mesh().alive(h)) done += live.split({h, restrip::turn_ccw(live.mesh(), h)}) ? 1U : 0U;
        break;
      case 6:
        live.undo();
        break;
      default:
        ranges += live.update().size();
    }
  }
  live.improve(5000);
  const restrip::LiveMesh loaded = restrip::LiveMesh::load(live.save());
  std::printf("%u done, %u ranges\n", static_cast<unsigned>(done), static_cast<unsigned>(ranges));
  print(what, loaded.mesh());
}

/// Split and collapse with precomputed flips.
void by_record() {
  StripMesh mesh = StripMesh::build(sheet(2), 9);
  restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
  restrip::BakedRecords records;
  records.flips = {mesh.spoke(4, 5)};
  records.first = {0, 1};
  const auto done = restrip::split_baked(mesh, {mesh.spoke(4, 1), mesh.spoke(4, 7)}, records[0]);
  restrip::collapse_baked(mesh, done.halfedge, records[0]);
  print("baked", mesh);
}

/// A colouring that is not valid must be refused; never returns.
void read_invalid_coloring() {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4);
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  std::printf("%u strips of no valid colouring\n", static_cast<unsigned>(restrip::count_strips(mesh)));
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::strcmp(arguments[1], "invalid") == 0) {
    read_invalid_coloring();
    return 0;
  }
  large_fan();
  by_record();
  operations(restrip::Policy::rules, restrip::StripForm::list, "rules");
  operations(restrip::Policy::local, restrip::StripForm::restart, "local");
  operations(restrip::Policy::quick, restrip::StripForm::stitched, "quick");
  operations(restrip::Policy::full, restrip::StripForm::lengths, "full");
}
