// Undo and redo restore the indices and colours exactly, under all policies, and operations repeated after an undo
// write the same bytes again.
#include "restrip/output/buffer_history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "buffer_changes.hpp"
#include "measure/check_buffer.hpp"
#include "random_operation.hpp"
#include "restrip/mesh/history.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

/// A mesh and its buffer, both with a history.
struct SavedState {
  StripMesh mesh;
  Keeper<StripMesh> keeper;
  std::vector<Triangle> changed;
  StripBuffer buffer;
  History history;
  BufferHistory buffers;
  std::vector<std::uint32_t> uploaded;  // by the ranges alone

  SavedState(StripMesh shape, std::size_t most, Policy policy = Policy::local, Cost cost = Cost::strips())
      : mesh(std::move(shape)),
        keeper(mesh, policy, cost),
        buffer(mesh),
        history(mesh, most),
        buffers(buffer),
        uploaded(indices()) {
    mesh.watch(&changed);
  }
  [[nodiscard]] std::vector<std::uint32_t> indices() const {
    return {buffer.indices().begin(), buffer.indices().end()};
  }
  /// The indices, followed by the triangles with their colours.
  [[nodiscard]] std::vector<std::uint32_t> look() const {
    std::vector<std::uint32_t> look = indices();
    for (const StripMesh::Halfedge h : sample::sides_of(mesh))
      look.insert(look.end(), {h.id, mesh.from(h), mesh.solid(h) ? 1U : 0U});
    return look;
  }
  void operate(unsigned seed, unsigned operations) {
    std::mt19937 random(seed);
    const bool grow = mesh.triangle_count() < 80 || random() % 2 == 0;
    for (unsigned n = 0; n < operations; ++n) random_operation(keeper, random, grow);
  }
  void upload() {
    const std::vector<std::uint32_t> before = uploaded;
    const auto ranges = buffer.update(mesh, changed);
    expect_only_reported_changes(before, buffer.indices(), ranges);
    uploaded = indices();
  }
  bool end_frame() {
    upload();
    buffers.note(buffer, changed);
    const bool made = history.frame(mesh, changed);
    if (made) buffers.frame(buffer, history.undoable());
    changed.clear();
    return made;
  }
  bool step(bool back) {
    const bool done = back ? buffers.undo(buffer) : buffers.redo(buffer);
    EXPECT_EQ(done, back ? history.undo(mesh) : history.redo(mesh));
    changed.clear();
    keeper.rebuild();
    return done;
  }
};

// Random frames, undone, redone, and, if only the mesh decides what an operation does, done once more.
void expect_the_very_looks(SavedState& kept, std::mt19937& random, int steps, bool once_more) {
  std::vector<std::vector<std::uint32_t>> looks{kept.look()};  // at the end of each frame
  std::vector<std::pair<unsigned, unsigned>> done;             // seed and operations of each
  std::size_t at = 0;
  int undone = 0;
  for (int step = 0; step < steps; ++step) {
    const auto choice = static_cast<unsigned>(random() % 5);
    if (choice < 2) {
      const bool back = choice == 0 || at + 1 == looks.size();
      if (kept.step(back)) {
        at += back ? std::size_t(-1) : 1;
        ++undone;
      }
      // The update that follows changes nothing, and reports what has been written.
      if (random() % 2 == 0) kept.upload();
    } else if (once_more && choice == 2 && at + 1 < looks.size()) {
      kept.operate(done[at].first, done[at].second);
      ASSERT_TRUE(kept.end_frame());
      ++at;
      ASSERT_EQ(kept.look(), looks[at]);
      looks.resize(at + 1);
      done.resize(at);
    } else {
      const auto seed = static_cast<unsigned>(random());
      const auto operations = static_cast<unsigned>(random() % 8 == 0 ? 60 : random() % 6);
      kept.operate(seed, operations);
      if (!kept.end_frame()) continue;
      looks.resize(++at);
      looks.push_back(kept.look());
      done.resize(at - 1);
      done.emplace_back(seed, operations);
    }
    ASSERT_EQ(kept.look(), looks[at]);
    ASSERT_TRUE(check_buffer(kept.buffer, kept.mesh).right());
  }
  EXPECT_GT(undone, steps / 6);
}

TEST(BufferHistory, GivesBackTheVeryIndices) {
  std::mt19937 random(21);
  for (StripMesh shape : {sample::torus(12, 12), sample::rectangle(9, 8)}) {
    stripify(shape, Effort::fast, Cost::strips());
    for (const std::size_t most : {std::size_t{400}, std::size_t{1} << 20}) {
      SavedState kept(shape, most);
      expect_the_very_looks(kept, random, 120, true);
      if (HasFatalFailure()) return;
      for (const Policy policy : {Policy::local, Policy::quick, Policy::full})
        for (const Cost cost : {Cost::strips(), Cost::indices()}) {
          SavedState under(shape, most, policy, cost);
          expect_the_very_looks(under, random, 60, false);
          if (HasFatalFailure()) return;
        }
    }
  }
}

// A frame in which the mesh did not change does not count, although the buffer may have been written.
TEST(BufferHistory, AnUnchangedMeshIsNotAFrame) {
  StripMesh mesh = sample::torus(12, 12);
  stripify(mesh, Effort::fast, Cost::strips());
  SavedState kept(mesh, 1 << 20);
  const std::vector<std::uint32_t> first = kept.indices();
  kept.changed = {0, 1, 2};
  EXPECT_FALSE(kept.end_frame());
  EXPECT_FALSE(kept.step(true));
  EXPECT_EQ(kept.indices(), first);
  kept.operate(1, 50);
  ASSERT_TRUE(kept.end_frame());
  const std::vector<std::uint32_t> second = kept.indices();
  kept.operate(2, 3);
  kept.upload();  // an update of a frame that has not ended
  kept.buffers.note(kept.buffer, kept.changed);
  kept.buffer.rebuild(kept.mesh);
  kept.buffers.note(kept.buffer, {});
  kept.uploaded = kept.indices();
  ASSERT_TRUE(kept.end_frame());
  const std::vector<std::uint32_t> third = kept.indices();
  ASSERT_TRUE(kept.step(true));
  EXPECT_EQ(kept.indices(), second);
  ASSERT_TRUE(kept.step(true));
  EXPECT_EQ(kept.indices(), first);
  kept.upload();
  ASSERT_TRUE(kept.step(false) && kept.step(false));
  EXPECT_EQ(kept.indices(), third);
  kept.upload();
  EXPECT_TRUE(check_buffer(kept.buffer, kept.mesh).right());
}

}  // namespace
}  // namespace restrip
