// What a live buffer promises beyond live_random_test.cpp, which draws it after random operations from the ranges that
// updates return: widths, room, windows, and the largest numbers.
#include "restrip/output/live_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "form_reader.hpp"
#include "random_operation.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

constexpr std::array forms{StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list};
constexpr std::array widths{IndexWidth::bits16, IndexWidth::bits32, IndexWidth::automatic};

/// A device: a separate buffer, made again when it is outgrown, that receives only the ranges.
class Device {
 public:
  template <class Live>
  void upload(const Live& live, const Upload& upload) {
    if (upload.outgrown) memory_.assign(live.room() * live.index_bytes(), std::byte{0xAB});
    for (const auto& [first, count] : upload) {
      const std::size_t width = live.index_bytes();
      ASSERT_LE((first + count) * width, memory_.size()) << "the device's buffer is too short";
      std::memcpy(memory_.data() + first * width, live.bytes().data() + first * width, count * width);
    }
    bytes_ = live.bytes().size();
  }
  [[nodiscard]] bool equals(const LiveBuffer& live) const {
    return std::equal(live.bytes().begin(), live.bytes().end(), memory_.begin());
  }
  template <class Live>
  [[nodiscard]] form_reader::Triangles drawn(const Live& live, StripForm form) const {
    std::vector<IndexRange> draws;
    if constexpr (requires { live.draws(draws); })
      live.draws(draws);
    else
      live.buffer().draws(draws);
    return form_reader::drawn({memory_.data(), bytes_}, live.index_bytes(), form, draws);
  }

 private:
  std::vector<std::byte> memory_;
  std::size_t bytes_ = 0;
};

TEST(LiveBuffer, WidensWhenAVertexNeedsIt) {
  for (const StripForm form : forms) {
    StripMesh mesh = sample::torus(8, 8);
    stripify(mesh);
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    LiveBuffer buffer({.form = form});
    LiveBuffer narrow({.form = form, .width = IndexWidth::bits16});
    Device device;
    device.upload(buffer, buffer.update(mesh, changed));
    narrow.update(mesh, changed);
    changed.clear();
    EXPECT_EQ(buffer.index_bytes(), 2U);
    Keeper keeper(mesh, Policy::rules);
    keeper.split({mesh.spoke(5), turn_ccw(mesh, turn_ccw(mesh, mesh.spoke(5)))}, Vertex{65'534});
    EXPECT_FALSE(buffer.update(mesh, changed).outgrown);
    EXPECT_EQ(buffer.index_bytes(), 2U);
    changed.clear();
    keeper.split({mesh.spoke(9), turn_ccw(mesh, turn_ccw(mesh, mesh.spoke(9)))}, Vertex{65'535});
    const Upload upload = buffer.update(mesh, changed);
    EXPECT_TRUE(upload.outgrown);
    EXPECT_EQ(buffer.index_bytes(), 4U);
    device.upload(buffer, upload);
    EXPECT_EQ(device.drawn(buffer, form), sample::triangles_of(mesh));
    EXPECT_THROW(narrow.update(mesh, changed), std::length_error);
  }
}

/// Room that was reserved is asked for once; then no update reports an outgrown buffer.
TEST(LiveBuffer, ReservesRoomOnTheDevice) {
  std::mt19937 random(23);
  for (const StripForm form : forms)
    for (const IndexWidth width : widths) {
      StripMesh mesh = sample::octahedron();
      stripify(mesh);
      Keeper keeper(mesh, Policy::quick, Cost::indices());
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      LiveBuffer buffer({.form = form, .width = width});
      Device device;
      device.upload(buffer, buffer.update(mesh, changed));
      buffer.reserve(1000);
      for (int round = 0; round < 150; ++round) {
        changed.clear();
        random_operation(keeper, random, true);
        const Upload upload = buffer.update(mesh, changed);
        ASSERT_EQ(upload.outgrown, round == 0);
        device.upload(buffer, upload);
        ASSERT_EQ(device.drawn(buffer, form), sample::triangles_of(mesh));
      }
      EXPECT_GT(mesh.triangle_count(), 100U);
      mesh.watch(nullptr);
    }
}

TEST(LiveBuffer, HasNoBatches) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(LiveBuffer({.most_vertices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_indices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_vertices = 3, .most_indices = most - 2}), std::invalid_argument);
}

/// Numbers of a caller may be as large as their type allows: their sums and products do not wrap.
TEST(LiveBuffer, TakesTheLargestNumbers) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::mt19937 random(25);
  for (const StripForm form : forms)
    for (const IndexWidth width : widths)
      for (const std::size_t gap : {std::size_t{2}, most / 2, most - 39, most})
        for (const std::size_t align : {std::size_t{4}, most / 4 * 4, most - 3, std::size_t{1} << 63, most}) {
          StripMesh mesh = sample::torus(12, 12);
          stripify(mesh);
          std::vector<Triangle> changed;
          mesh.watch(&changed);
          LiveBuffer buffer({.form = form, .width = width});
          Device device;
          device.upload(buffer, buffer.update(mesh, changed));
          changed.clear();
          for (Triangle t = 0; t < 280; t += 40) checked_flip(mesh, StripMesh::halfedge(t, 1));
          const Upload upload = buffer.update(mesh, changed, {.merge_gap = gap, .align = align});
          ASSERT_TRUE(upload.size() == 1 || (gap == 2 && align == 4));
          device.upload(buffer, upload);
          ASSERT_EQ(device.drawn(buffer, form), sample::triangles_of(mesh));
          const std::size_t room = buffer.room();
          for (const std::size_t triangles : {most, most / 2 + 1, most / 3 + 1})
            EXPECT_THROW(buffer.reserve(triangles), std::length_error);
          EXPECT_EQ(buffer.room(), room);
          mesh.watch(nullptr);
        }
  LiveMesh live(sample::torus(12, 12), {.history = most});
  live.flip(StripMesh::halfedge(7, 1));
  live.improve(100);
  live.improve(most);
  live.update();
  EXPECT_TRUE(live.undo());
}

/// An update reports an outgrown buffer if the device, as the caller made it last, has another width or too little
/// room; not for widening or growth that is undone before the caller hears of it.
TEST(LiveBuffer, ReportsOnlyWhatTheDeviceDoesNotHave) {
  for (const StripForm form : forms) {
    LiveMesh live(sample::torus(8, 8), {.history = 100'000, .format = {.form = form, .width = IndexWidth::automatic}});
    const auto split = [&](Vertex name) {
      const auto h = live.mesh().spoke(9);
      ASSERT_TRUE(live.split({h, turn_ccw(live.mesh(), turn_ccw(live.mesh(), h))}, name));
    };
    split(65'535);
    ASSERT_TRUE(live.undo());
    EXPECT_FALSE(live.update().outgrown);
    EXPECT_EQ(live.index_bytes(), 2U);
    ASSERT_TRUE(live.redo());
    EXPECT_TRUE(live.update().outgrown);
    EXPECT_EQ(live.index_bytes(), 4U);
    EXPECT_FALSE(live.update().outgrown);
    const std::size_t room = live.room();
    while (live.bytes().size() <= room * live.index_bytes()) {
      split(none);
      if (live.update().outgrown) break;
    }
    EXPECT_GT(live.room(), room);
    EXPECT_FALSE(live.update().outgrown);
  }
}

/// A frame that was not returned yet is returned after a change of width that came and went.
TEST(LiveBuffer, ReturnsWhatWasNotReturnedAfterAChangeOfWidth) {
  for (const StripForm form : forms) {
    LiveMesh live(sample::torus(8, 8), {.history = 100'000, .format = {.form = form, .width = IndexWidth::automatic}});
    Device device;
    device.upload(live, {{}, true});
    const std::array all{IndexRange{0, live.bytes().size() / live.index_bytes()}};
    device.upload(live, {all, false});
    ASSERT_TRUE(live.flip(StripMesh::halfedge(20, 1)) && live.flip(StripMesh::halfedge(90, 1)));
    ASSERT_FALSE(live.redo());
    const auto h = live.mesh().spoke(9);
    ASSERT_TRUE(live.split({h, turn_ccw(live.mesh(), h)}, 70'000));
    ASSERT_TRUE(live.undo());
    device.upload(live, live.update());
    EXPECT_TRUE(device.equals(live.buffer()));
    EXPECT_EQ(device.drawn(live, form), sample::triangles_of(live.mesh()));
    ASSERT_TRUE(live.undo());  // the flips
    for (Triangle t = 10; t < 80; t += 10) live.split_face(StripMesh::halfedge(t));
    device.upload(live, live.update());
    ASSERT_TRUE(live.split({live.mesh().spoke(9), turn_ccw(live.mesh(), live.mesh().spoke(9))}, 70'000));
    device.upload(live, live.update());
    ASSERT_TRUE(live.undo() && live.undo());
    device.upload(live, live.update());
    ASSERT_TRUE(live.redo() && live.redo() && live.undo());
    device.upload(live, live.update());
    EXPECT_TRUE(device.equals(live.buffer()));
    EXPECT_EQ(device.drawn(live, form), sample::triangles_of(live.mesh()));
  }
}

/// A stitched buffer drawn in windows of any even number of indices: each triangle once, with its winding.
TEST(LiveBuffer, DrawsAStitchedBufferInWindows) {
  std::mt19937 random(24);
  for (const IndexWidth width : widths)
    for (StripMesh& mesh : sample::meshes()) {
      stripify(mesh);
      Keeper keeper(mesh, Policy::quick, Cost::indices());
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      LiveBuffer buffer({.form = StripForm::stitched, .width = width});
      for (int round = 0; round < 30; ++round) {
        buffer.update(mesh, changed);
        changed.clear();
        for (const std::size_t n : {std::size_t{4}, std::size_t{6}, 2 * (4 + random() % 60)}) {
          form_reader::Reader reader(buffer.bytes(), buffer.index_bytes());
          for (std::size_t first = 0; first + 2 < buffer.size(); first += n - 2)
            reader.strip(first, std::min(n, buffer.size() - first), false);
          ASSERT_EQ(std::move(reader).triangles(), sample::triangles_of(mesh));
        }
        for (auto n = random() % 8; n > 0; --n) random_operation(keeper, random, mesh.triangle_count() < 60);
      }
      mesh.watch(nullptr);
    }
}

}  // namespace
}  // namespace restrip
