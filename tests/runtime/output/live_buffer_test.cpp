// A live buffer of every form and width draws its mesh after random operations, the returned ranges are enough to keep
// a copy of it on a device, and have the requested alignment and gaps.
#include "restrip/output/live_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
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
    form_reader::Reader reader({memory_.data(), bytes_}, live.index_bytes());
    std::vector<IndexRange> draws;
    if constexpr (requires { live.draws(draws); })
      live.draws(draws);
    else
      live.buffer().draws(draws);
    for (const auto& [first, count] : draws) {
      if (form == StripForm::list)
        reader.list(first, count);
      else
        reader.strip(first, count, form == StripForm::restart);
    }
    return std::move(reader).triangles();
  }

 private:
  std::vector<std::byte> memory_;
  std::size_t bytes_ = 0;
};

TEST(LiveBuffer, DrawsTheMeshInEveryForm) {
  std::mt19937 random(21);
  std::size_t outgrown = 0;
  for (const StripForm form : forms)
    for (const IndexWidth width : widths)
      for (StripMesh& mesh : sample::meshes()) {
        stripify(mesh);
        Keeper keeper(mesh, Policy::quick, Cost::indices());
        std::vector<Triangle> changed;
        mesh.watch(&changed);
        LiveBuffer buffer({.form = form, .width = width});
        Device device;
        for (int round = 0; round < 50; ++round) {
          const RangeOptions options{.merge_gap = random() % 40, .align = std::size_t{2} << random() % 4};
          const Upload upload = buffer.update(mesh, changed, options);
          outgrown += upload.outgrown ? 1U : 0U;
          changed.clear();
          device.upload(buffer, upload);
          ASSERT_TRUE(device.equals(buffer));
          ASSERT_EQ(device.drawn(buffer, form), sample::triangles_of(mesh));
          std::vector<IndexRange> draws;
          buffer.draws(draws);
          if (form == StripForm::list) {
            ASSERT_EQ(draws.size(), 1U);
            ASSERT_EQ(draws[0].count, 3 * mesh.triangle_count());
          }
          ASSERT_EQ(buffer.bytes().size() % 4, 0U);
          std::size_t end = 0;
          for (const IndexRange& range : upload) {
            ASSERT_TRUE(end == 0 || range.first - end > options.merge_gap);
            end = range.first + range.count;
            ASSERT_TRUE(range.first * buffer.index_bytes() % options.align == 0);
            ASSERT_TRUE(end * buffer.index_bytes() % options.align == 0 || end == buffer.size());
          }
          if (round == 30) buffer.forget();
          if (round == 35) buffer.keep_upload();
          for (auto n = random() % 8; n > 0; --n)
            random_operation(keeper, random, mesh.triangle_count() < 60 || round % 30 < 20);
        }
        mesh.watch(nullptr);
      }
  EXPECT_GT(outgrown, forms.size() * widths.size() * sample::meshes().size());
}

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
  EXPECT_THROW(LiveBuffer({.most_vertices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_indices = 64}), std::invalid_argument);
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

/// Through frames, undo and redo of a LiveMesh, the device is written by update() alone.
TEST(LiveBuffer, OfALiveMeshThroughUndo) {
  std::mt19937 random(22);
  for (const StripForm form : forms)
    for (const IndexWidth width : widths) {
      LiveMesh live(sample::torus(12, 12), {.history = 100'000, .format = {.form = form, .width = width}});
      Device device;
      device.upload(live, {{}, true});
      device.upload(
          live,
          {std::span<const IndexRange>(std::array{IndexRange{0, live.bytes().size() / live.index_bytes()}}), false});
      std::vector<std::vector<std::byte>> looks;
      for (int frame = 0; frame < 60; ++frame) {
        const std::vector<std::byte> before(live.bytes().begin(), live.bytes().end());
        const auto triangles = sample::triangles_of(live.mesh());
        for (int n = 0; n < 6; ++n) random_operation(live.keeper(), random, frame < 40);
        const bool ended = random() % 2 == 0;
        if (ended) device.upload(live, live.update());
        if (random() % 2 == 0 && live.undo() && sample::triangles_of(live.mesh()) == triangles &&
            form != StripForm::list) {
          ASSERT_TRUE(std::equal(before.begin(), before.end(), live.bytes().begin(), live.bytes().end()));
        }
        device.upload(live, live.update());
        ASSERT_EQ(device.drawn(live, form), sample::triangles_of(live.mesh()));
        if (random() % 4 == 0 && live.redo()) device.upload(live, live.update());
        ASSERT_EQ(device.drawn(live, form), sample::triangles_of(live.mesh()));
      }
    }
}

}  // namespace
}  // namespace restrip
