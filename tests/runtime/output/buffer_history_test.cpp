// Undo and redo restore the indices of a buffer exactly; under all policies and in every form:
// output/live_buffer_test.cpp and live_twins_test.cpp.
#include "restrip/output/buffer_history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "buffer_changes.hpp"
#include "random_operation.hpp"
#include "restrip/mesh/history.hpp"
#include "restrip/output/check_buffer.hpp"
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

  SavedState(StripMesh shape, std::size_t most)
      : mesh(std::move(shape)),
        keeper(mesh, Policy::local, Cost::strips()),
        buffer(mesh),
        history(mesh, most),
        buffers(buffer),
        uploaded(indices()) {
    mesh.watch(&changed);
  }
  [[nodiscard]] std::vector<std::uint32_t> indices() const {
    return {buffer.indices().begin(), buffer.indices().end()};
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
