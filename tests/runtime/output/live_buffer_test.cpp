// What a live buffer promises beyond live_random_test.cpp, which draws it after random operations from the ranges that
// updates return: widths, room and windows.
#include "restrip/output/live_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "form_reader.hpp"
#include "random_operation.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

constexpr std::array forms{StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list};
constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
constexpr std::array widths{IndexWidth::bits16, IndexWidth::bits32, IndexWidth::automatic};

TEST(LiveBuffer, WidensWhenAVertexNeedsIt) {
  for (const StripForm form : forms) {
    StripMesh mesh = sample::torus(8, 8);
    stripify(mesh);
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    LiveBuffer buffer({.form = form});
    LiveBuffer narrow({.form = form, .width = IndexWidth::bits16});
    buffer.update(mesh, changed);
    narrow.update(mesh, changed);
    Keeper keeper(mesh, Policy::rules);
    for (const Vertex name : {65'534U, 65'535U}) {
      changed.clear();
      keeper.split({mesh.spoke(5), turn_ccw(mesh, turn_ccw(mesh, mesh.spoke(5)))}, name);
      EXPECT_EQ(buffer.update(mesh, changed).outgrown, name == 65'535);
      EXPECT_EQ(buffer.index_bytes(), name == 65'535 ? 4U : 2U);
    }
    std::vector<IndexRange> draws;
    buffer.draws(draws);
    EXPECT_EQ(form_reader::drawn(buffer.bytes(), buffer.index_bytes(), form, draws), sample::triangles_of(mesh));
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
      buffer.update(mesh, changed);
      for (const std::size_t triangles : {most, most / 2 + 1, most / 3 + 1})
        EXPECT_THROW(buffer.reserve(triangles), std::length_error);
      buffer.reserve(1000);
      for (int round = 0; round < 150; ++round) {
        changed.clear();
        random_operation(keeper, random, true);
        ASSERT_EQ(buffer.update(mesh, changed).outgrown, round == 0);
      }
      EXPECT_GT(mesh.triangle_count(), 100U);
      mesh.watch(nullptr);
    }
}

TEST(LiveBuffer, HasNoBatches) {
  EXPECT_THROW(LiveBuffer({.most_vertices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_indices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_vertices = 3, .most_indices = most - 2}), std::invalid_argument);
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
