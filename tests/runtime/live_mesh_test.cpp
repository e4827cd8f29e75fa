// One object keeps mesh, strips and buffer in step, and undoes frames: what undo, levels, recolourings, custom
// operations and deferred buffers promise beyond the random frames of live_random_test.cpp.
#include "restrip/live_mesh.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "baked_sequence.hpp"
#include "form_reader.hpp"
#include "random_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

/// A sheet whose triangles are there twice, with opposite windings: few strips, and every operation is refused.
TEST(LiveMesh, RefusesOperationsInATwoSidedSheet) {
  const sample::Triangles list = sample::with_backs(sample::triangles_of(sample::rectangle(12, 12)));
  BuildReport report;
  LiveMesh live(list, 13 * 13, {}, &report);
  EXPECT_GT(report.non_manifold_edges, 0U);
  EXPECT_EQ(form_reader::read_strips(live.indices()).size(), list.size());
  EXPECT_LE(live.indices().size(), 14 * list.size() / 10);
  for (Triangle t = 0; t < list.size(); ++t)
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(t, side);
      for (const Checked& done : {live.collapse(h), live.flip(h), live.bisect(h)})
        ASSERT_TRUE(done.refusal == Refusal::non_manifold_vertex || done.refusal == Refusal::other_patch);
    }
}

// The lines that the viewer's page prints for C++, as they are printed there.
TEST(LiveMesh, LinesOfThePageKeepTheBufferInStep) {
  std::vector<std::uint32_t> triangles;
  for (const sample::Corners& c : sample::grid(20, 20, true, true, 1))
    triangles.insert(triangles.end(), c.begin(), c.end());
  const std::size_t vertex_count = 400;
  const Vertex v = triangles[0];
  const Vertex w = triangles[1];
  std::vector<std::uint32_t> gpu;
  const auto upload_all = [&](std::span<const std::uint32_t> all) { gpu.assign(all.begin(), all.end()); };
  const auto upload = [&](std::size_t first, std::span<const std::uint32_t> some) {
    gpu.resize(std::max(gpu.size(), first + some.size()));
    std::copy(some.begin(), some.end(), gpu.begin() + static_cast<std::ptrdiff_t>(first));
  };
#include "../../web/viewer/use/live.inc"
  gpu.resize(live.indices().size());
  EXPECT_EQ(live.mesh().triangle_count(), triangles.size() / 3 - 2);
  EXPECT_EQ(form_reader::read_strips(std::span<const std::uint32_t>(gpu)), sample::triangles_of(live.mesh()));
}

// In whichever orientation a custom operation fits; live_random_test.cpp does them at given sides.
TEST(LiveApply, AnywhereTakesTheOrientationThatFits) {
  LiveMesh live(sample::torus(8, 8));
  const Checked refined = live.apply(tables::refine_face_rules, StripMesh::halfedge(20));
  ASSERT_TRUE(refined);
  const Triangle merged = StripMesh::triangle(refined.rewrite.halfedge);
  const Halfedge place = first_place(live.mesh(), tables::merge_rules, merged);
  const bool fits = check_apply(live.mesh(), tables::merge_rules, place) == Refusal::granted;
  EXPECT_EQ(bool(live.apply_anywhere(tables::merge_rules, merged)), fits);
  EXPECT_TRUE(live.apply_anywhere(tables::refine_face_rules, 40));
}

StripMesh::Halfedge random_halfedge_that_flips(const StripMesh& mesh) {
  std::mt19937 random(1);
  StripMesh::Halfedge h;
  do h = random_halfedge(mesh, random);
  while (check_flip(mesh, h) != Refusal::granted);
  return h;
}

void expect_buffer_drawn(const LiveMesh& live) {
  std::vector<IndexRange> draws;
  live.buffer().draws(draws);
  ASSERT_EQ(form_reader::drawn(live.bytes(), live.index_bytes(), live.buffer().format().form, draws),
            sample::triangles_of(live.mesh()));
}

// A buffer of 16 bits refuses vertex 65,535, and says what to do; the frame can be undone.
TEST(LiveUndo, WorksAfterAVertexThatSixteenBitsCannotName) {
  LiveMesh live(sample::torus(6, 6), {.history = 1000, .format = {.width = IndexWidth::bits16}});
  const Look before = look_at(live.mesh());
  const StripMesh::Halfedge h = live.mesh().spoke(0);
  ASSERT_TRUE(live.split({h, turn_ccw(live.mesh(), turn_ccw(live.mesh(), h))}, 65'535));
  for (int attempt = 0; attempt < 2; ++attempt) {
    std::string sentence;
    try {
      live.update();
    } catch (const std::length_error& error) {
      sentence = error.what();
    }
    for (const char* part : {"vertex 65535", "16 bits", "IndexWidth::automatic", "pack()"})
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(look_at(live.mesh()), before);
  live.update();
  expect_buffer_drawn(live);
  ASSERT_TRUE(live.redo());
  EXPECT_THROW(live.update(), std::length_error);
  live.pack();
  live.update();
  expect_buffer_drawn(live);
}

// One changed triangle frees three vertices and takes three others: undo returns all of them.
TEST(LiveUndo, TheNextVerticesAreThoseBeforeTheFrame) {
  const std::vector<std::array<Vertex, 3>> lone{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  LiveMesh live(lone, 9, {.history = 1000});
  const auto next_vertices = [&live] {
    return std::array{live.mesh().next_vertex(0), live.mesh().next_vertex(1), live.mesh().next_vertex(2)};
  };
  const std::array<Triangle, 2> out{0, 1};
  ASSERT_TRUE(live.replace(std::span(out).first(1), {}));
  live.update();
  const auto before = next_vertices();
  EXPECT_EQ(before, lone[0]);
  ASSERT_TRUE(live.replace(std::span(out).last(1), std::span(lone).first(1)));
  live.update();
  const auto after = next_vertices();
  EXPECT_EQ(after, lone[1]);
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(next_vertices(), before);
  ASSERT_TRUE(live.redo());
  EXPECT_EQ(next_vertices(), after);
}

TEST(LiveUndo, ABakedMeshPlaysItsLevelsAndBeginsAgain) {
  const auto file = baked_torus();
  LiveMesh live(file, {.history = 100'000});
  ASSERT_EQ(live.baked(), file.get());
  const auto base = look_at(live.mesh());
  EXPECT_EQ(live.level(), 0U);
  EXPECT_EQ(live.move_to_level(file->splits.size(), 10), 10U);
  live.update();
  EXPECT_EQ(live.move_to_level(file->splits.size()), file->splits.size() - 10);
  EXPECT_EQ(live.mesh().triangle_count(), 288U);
  // An operation leaves the levels, and undoing it returns to them.
  live.update();
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  EXPECT_EQ(live.level(), std::nullopt);
  EXPECT_EQ(live.move_to_level(0), 0U);
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(live.level(), file->splits.size());
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(live.level(), 10U);
  EXPECT_EQ(live.move_to_level(0), 10U);
  EXPECT_EQ(sample::triangles_of(live.mesh()), sample::triangles_of(file->mesh));
  live.keep(Policy::full, Cost::indices());
  EXPECT_EQ(live.level(), std::nullopt);
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  live.restart();
  EXPECT_EQ(live.level(), 0U);
  EXPECT_EQ(std::as_const(live).keeper().policy(), Policy::local);
  EXPECT_EQ(look_at(live.mesh()), base);
  EXPECT_EQ(live.undoable(), 0U);
  EXPECT_NE(live.update().size(), 0U);
  EXPECT_EQ(form_reader::read_strips(live.indices()), sample::triangles_of(live.mesh()));
  EXPECT_EQ(live.move_to_level(file->splits.size()), file->splits.size());
  // A saved mesh has its strips, but not its levels.
  const LiveMesh loaded = LiveMesh::load(live.save());
  EXPECT_EQ(sample::triangles_of(loaded.mesh()), sample::triangles_of(live.mesh()));
  EXPECT_EQ(loaded.baked(), nullptr);
  EXPECT_EQ(loaded.level(), std::nullopt);
}

TEST(LiveUndo, RecoloringsAreFramesAndRefuseWhatIsNotValid) {
  LiveMesh live(sample::torus(9, 9), {.history = 100'000});
  const auto before = look_at(live.mesh());
  const std::size_t strips = live.recolor(Effort::full, Cost::strips());
  EXPECT_EQ(strips, live.strips());
  EXPECT_EQ(strips, count_strips(live.mesh()));
  const Upload all = live.update();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].count, live.indices().size());
  EXPECT_EQ(live.undoable(), 1U);
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(look_at(live.mesh()), before);

  std::vector<std::uint8_t> colors(162, 0);
  EXPECT_FALSE(live.recolor(std::span(colors).first(161)));
  colors[3] = 1;  // only one of the two triangles
  EXPECT_FALSE(live.recolor(colors));
  colors.assign(162, 8);
  EXPECT_FALSE(live.recolor(colors));
  colors.assign(162, 7);  // branches
  EXPECT_FALSE(live.recolor(colors));
  EXPECT_EQ(look_at(live.mesh()), before);
  colors.assign(162, 0);
  EXPECT_TRUE(live.recolor(colors));
  EXPECT_EQ(live.strips(), 162U);
}

TEST(LiveUndo, ADeferredBufferBeginsWithTheFirstUpdate) {
  LiveMesh live(sample::torus(9, 9), {.history = 1000, .deferred = true});
  ASSERT_TRUE(live.flip(live.mesh().spoke(3)));
  EXPECT_EQ(live.bytes().size(), 0U);
  EXPECT_EQ(live.changed().size(), 0U);
  const Upload all = live.update();
  EXPECT_TRUE(all.outgrown);
  EXPECT_EQ(form_reader::read_strips(live.indices()), sample::triangles_of(live.mesh()));
  EXPECT_EQ(live.undoable(), 0U);
  ASSERT_TRUE(live.flip(live.mesh().spoke(3)));
  EXPECT_NE(live.changed().size(), 0U);
  live.update();
  EXPECT_EQ(live.undoable(), 1U);
  live.begin_buffer({.form = StripForm::list, .width = IndexWidth::bits16}, {}, 1000);
  EXPECT_EQ(live.undoable(), 0U);
  EXPECT_EQ(live.bytes().size(), 0U);
  EXPECT_FALSE(live.undo());
  EXPECT_TRUE(live.update().outgrown);
  EXPECT_EQ(live.indices16().size(), 3 * 162U);
}

}  // namespace
}  // namespace restrip
