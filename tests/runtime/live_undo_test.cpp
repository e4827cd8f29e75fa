// Undo restores triangles, handles and colours exactly, and the next update draws them.
//
// Random frames - operations, background work, recolourings, other policies, baked levels - are done, undone and
// redone. The mesh is compared with copies of it at the end of each frame: corners, neighbours, colours, first spokes,
// and the handles of the next insertions. After each update an independent decoder reads the buffer.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "check_buffer.hpp"
#include "form_reader.hpp"
#include "random_operation.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

StripMesh::Halfedge random_halfedge_that_flips(const StripMesh& mesh) {
  std::mt19937 random(1);
  StripMesh::Halfedge h;
  do h = random_halfedge(mesh, random);
  while (check_flip(mesh, h) != Refusal::granted);
  return h;
}

Checked operate(LiveMesh& live, std::mt19937& random) {
  const StripMesh& mesh = live.mesh();
  return perform(live, draw(mesh, random, all_operations, trend_between(0, 300, mesh.triangle_count())));
}

void work_on(LiveMesh& live, std::mt19937& random) {
  if (live.level() && random() % 4 != 0) {
    const std::size_t wanted = random() % (live.baked()->splits.size() + 1);
    live.move_to_level(wanted, random() % 40);
    return;
  }
  for (auto n = random() % 12; n > 0; --n) operate(live, random);
  if (random() % 3 == 0) live.improve(random() % 2000);
  if (random() % 4 == 0) live.recolor(random() % 3 == 0 ? Effort::full : Effort::fast, default_cost);
  if (random() % 8 == 0) live.recolor(std::vector<std::uint8_t>(live.mesh().triangle_bound(), 0));
  if (live.baked() == nullptr && random() % 8 == 0)
    live.keep(random() % 2 == 0 ? Policy::local : Policy::full, random() % 2 == 0 ? Cost::strips() : Cost{2, 1, 1});
}

/// The mesh at the end of a frame.
struct FrameEnd {
  Look look;
  std::size_t strips;
  std::optional<std::size_t> level;

  explicit FrameEnd(const LiveMesh& live) : look(look_at(live.mesh())), strips(live.strips()), level(live.level()) {}
};

void expect_buffer_drawn(const LiveMesh& live) {
  std::vector<IndexRange> draws;
  live.buffer().draws(draws);
  form_reader::Reader reader(live.bytes(), live.index_bytes());
  for (const auto& [first, count] : draws) {
    if (live.buffer().format().form == StripForm::list)
      reader.list(first, count);
    else
      reader.strip(first, count, live.buffer().format().form == StripForm::restart);
  }
  ASSERT_EQ(std::move(reader).triangles(), sample::triangles_of(live.mesh()));
}

/// Does frames at random, undoes and redoes them.
void go_back_and_forth(LiveMesh live, unsigned seed, int steps) {
  std::mt19937 random(seed);
  std::vector<FrameEnd> frames{FrameEnd(live)};
  std::size_t at = 0;
  for (int step = 0; step < steps; ++step) {
    if (random() % 5 < 2) {
      ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));  // without a change there is no frame
      work_on(live, random);
      const FrameEnd end(live);
      if (random() % 2 == 0) {
        live.update();
        expect_buffer_drawn(live);
      } else if (end.look != frames[at].look) {
        ASSERT_TRUE(live.undo());  // ends the frame first
        ASSERT_EQ(look_at(live.mesh()), frames[at].look);
        ASSERT_TRUE(live.redo());
      }
      if (end.look == frames[at].look) continue;
      frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(++at), frames.end());
      frames.push_back(end);
    } else {
      const bool forward = random() % 3 == 0;
      const bool exists = forward ? at + 1 < frames.size() : at > 0;
      ASSERT_EQ(forward ? live.redo() : live.undo(), exists);
      if (exists) at += forward ? 1 : std::size_t(-1);
    }
    ASSERT_EQ(look_at(live.mesh()), frames[at].look);
    ASSERT_EQ(fault_of(live.mesh()), "");
    ASSERT_EQ(live.strips(), frames[at].strips);
    ASSERT_EQ(live.strips(), count_strips(live.mesh()));
    ASSERT_EQ(live.level(), frames[at].level);
    ASSERT_EQ(live.undoable(), at);
    ASSERT_EQ(live.redoable(), frames.size() - 1 - at);
    if (random() % 2 == 0) {
      live.update();
      expect_buffer_drawn(live);
    }
  }
}

TEST(LiveUndo, RestoresTheMeshUnderEveryPolicy) {
  unsigned seed = 0;
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices()})
      for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list}) {
        SCOPED_TRACE(testing::Message() << row.name << " cost " << cost.swap << " form " << int(form));
        const IndexWidth width = seed % 2 == 0 ? IndexWidth::automatic : IndexWidth::bits32;
        const LiveOptions options{.policy = row.policy, .cost = cost, .history = 1'000'000, .format = {form, width}};
        const StripMesh mesh = seed % 3 == 0 ? sample::torus(9, 10) : sample::rectangle(11, 9);
        go_back_and_forth(LiveMesh(mesh, options), ++seed, 60);
        if (HasFatalFailure()) return;
      }
}

/// A torus that is coarsened at random. The flips clear one of the dual edges that each record makes solid.
std::shared_ptr<const BakedFile> baked_torus() {
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

TEST(LiveUndo, RestoresTheLevelsOfABakedMesh) {
  const auto file = baked_torus();
  for (unsigned seed = 1; seed < 5; ++seed) go_back_and_forth(LiveMesh(file, {.history = 1'000'000}), seed, 60);
}

// Records do not contain isolated triangles, so they are counted when the levels are left.
TEST(LiveUndo, CountsAreRightAfterTheLevels) {
  const auto file = baked_torus();
  for (std::size_t level = 0; level <= file->splits.size(); level += 7) {
    LiveMesh live(file, {.history = 1000});
    live.move_to_level(level);
    ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
    const ColoringReport report = check_coloring(live.mesh());
    EXPECT_EQ(live.keeper().isolated(), report.isolated);
    EXPECT_EQ(live.keeper().strips(), report.strips);
  }
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

TEST(LiveUndo, PackingKeepsTrianglesColorsAndOrder) {
  std::mt19937 random(3);
  for (const StripMesh& start : {sample::torus(12, 12), sample::rectangle(14, 9)}) {
    LiveMesh live(start, {.history = 1000});
    while (live.mesh().triangle_count() > start.triangle_count() / 3)
      live.collapse(random_halfedge(live.mesh(), random));
    live.update();
    const StripMesh before = live.mesh();
    const Renumbering numbers = live.pack();
    const StripMesh& after = live.mesh();
    ASSERT_EQ(fault_of(after), "");
    EXPECT_EQ(after.triangle_bound(), before.triangle_count());
    EXPECT_EQ(after.triangle_count(), before.triangle_count());
    EXPECT_LT(after.vertex_bound(), before.vertex_bound());
    ASSERT_EQ(numbers.triangles.size(), before.triangle_bound());
    ASSERT_EQ(numbers.vertices.size(), before.vertex_bound());
    Triangle next = 0;
    for (Triangle t = 0; t < before.triangle_bound(); ++t) {
      if (!before.alive(t)) {
        EXPECT_EQ(numbers.triangles[t], none);
        continue;
      }
      ASSERT_EQ(numbers.triangles[t], next++);
      EXPECT_EQ(after.solid_sides(numbers.triangles[t]), before.solid_sides(t));
      for (unsigned corner = 0; corner < 3; ++corner)
        EXPECT_EQ(after.corners(numbers.triangles[t])[corner], numbers.vertices[before.corners(t)[corner]]);
    }
    EXPECT_EQ(live.undoable(), 0U);
    EXPECT_EQ(live.strips(), count_strips(after));
    live.update();
    expect_buffer_drawn(live);
    ASSERT_TRUE(live.flip(random_halfedge_that_flips(after)));
    live.update();
    expect_buffer_drawn(live);
    EXPECT_TRUE(live.undo());
  }
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
  EXPECT_EQ(triangles_of(live.mesh()), triangles_of(file->mesh));
  live.keep(Policy::full, Cost::indices());
  EXPECT_EQ(live.level(), std::nullopt);
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  live.restart();
  EXPECT_EQ(live.level(), 0U);
  EXPECT_EQ(std::as_const(live).keeper().policy(), Policy::local);
  EXPECT_EQ(look_at(live.mesh()), base);
  EXPECT_EQ(live.undoable(), 0U);
  EXPECT_NE(live.update().size(), 0U);
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
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
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
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

TEST(LiveUndo, FramesHaveNumbersThatRemainWhenOldOnesAreDropped) {
  LiveMesh live(sample::torus(9, 9), {.history = 30});
  EXPECT_EQ(live.frame(), 0U);
  for (std::size_t n = 1; n <= 20; ++n) {
    ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
    EXPECT_EQ(live.frame(), n - 1);
    live.update();
    live.update();  // without a change
    EXPECT_EQ(live.frame(), n);
  }
  const std::size_t undoable = live.undoable();
  ASSERT_GT(undoable, 1U);
  ASSERT_LT(undoable, 15U);
  ASSERT_TRUE(live.undo() && live.undo());
  EXPECT_EQ(live.frame(), 18U);
  ASSERT_TRUE(live.redo());
  EXPECT_EQ(live.frame(), 19U);
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  live.update();
  EXPECT_EQ(live.frame(), 20U);
  while (live.undo()) continue;
  EXPECT_EQ(live.frame() + live.redoable(), 20U);
  LiveMesh without(sample::torus(9, 9));
  ASSERT_TRUE(without.flip(random_halfedge_that_flips(without.mesh())));
  without.update();
  EXPECT_EQ(without.frame(), 0U);
}

}  // namespace
}  // namespace restrip
